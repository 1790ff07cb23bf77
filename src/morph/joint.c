#include "morph/joint.h"

#include <math.h>

#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/align.h"
#include "morph/masters.h"

#define STOPS_A_RING                                                                                         \
    140.0 /* places along a ring that are aligned, at least; more where the drawing has more vertices */
#define HOLE_DISTANCE                                                                                        \
    0.25 /* between the barycentres of two holes that are taken for counterparts, in boxes */

typedef struct mt_joining {
    const mt_side *a, *b;
    const mt_component *in_a, *in_b;
    const mt_params *params;
    mt_arena *arena;
} mt_joining;

/* ---- two rings
 * ----------------------------------------------------------------------------------------------- */

static mt_status stops_of(const mt_joining *j, const mt_ring *ring, mt_stops *stops) {
    mt_trace trace;
    mt_status status = mt_trace_ring(ring, mt_grid_units(j->params->tolerance), j->arena, &trace);
    double step = fmax(1, mt_ring_length(ring) / STOPS_A_RING);
    return status == MT_OK ? mt_stops_of(&trace, step, j->arena, stops) : status;
}

static mt_status join_rings(const mt_joining *j, const mt_ring *p, const mt_ring *q, mt_masters *masters) {
    mt_stops a, b;
    mt_alignment alignment;
    mt_status status = stops_of(j, p, &a);
    if (status == MT_OK) status = stops_of(j, q, &b);
    if (status == MT_OK) status = mt_align(&a, j->a->box, &b, j->b->box, j->arena, &alignment);
    if (status != MT_OK) return status;
    return mt_masters_fit(&a, &b, &alignment, mt_grid_units(j->params->fit), j->arena, masters);
}

/* ---- holes without a counterpart
 * ------------------------------------------------------------------------------ */

static double side(int32_t low, int32_t high) {
    return fmax(1, (double)high - low);
}

/* The barycentre of a ring, relative to its glyph's box. */
static void place_of(const mt_ring *ring, mt_box box, double *x, double *y) {
    mt_ring_centre(ring, x, y);
    *x = (*x - box.min.x) / side(box.min.x, box.max.x);
    *y = (*y - box.min.y) / side(box.min.y, box.max.y);
}

static double apart(const mt_ring *p, mt_box box_p, const mt_ring *q, mt_box box_q) {
    double px, py, qx, qy;
    place_of(p, box_p, &px, &py);
    place_of(q, box_q, &qx, &qy);
    return hypot(px - qx, py - qy);
}

/* A point in the ink of component k of `to`: the barycentre of the piece that lies nearest to the hole's own
 * place. A piece is convex, so its barycentre is inside it. */
static mt_point point_inside(const mt_ring *hole, mt_box box, const mt_side *to, int k) {
    double least = INFINITY;
    mt_point found = {0};
    for (int i = to->first[k]; i < to->first[k + 1]; i++) {
        double d = apart(hole, box, &to->pieces.rings[i], to->box);
        if (d >= least) continue;
        least = d;
        double x, y;
        mt_ring_centre(&to->pieces.rings[i], &x, &y);
        found = (mt_point){(int32_t)lround(x), (int32_t)lround(y)};
    }
    return found;
}

/* The hole's own contour on the one side, all of it at one point on the other. */
static mt_status close_hole(const mt_joining *j, const mt_ring *hole, mt_point point, bool in_a,
                            mt_masters *masters) {
    mt_rings one = {1, (mt_ring *)hole};
    mt_outline outline;
    double tolerance = mt_grid_units(j->params->tolerance), fit = mt_grid_units(j->params->fit);
    mt_status status = mt_fit(&one, tolerance, fit, j->arena, &outline);
    if (status != MT_OK) return status;
    *masters = (mt_masters){0};
    if (outline.count == 0) return MT_OK;
    mt_contour shut = {outline.contours[0].count, NULL};
    shut.segments = mt_arena_new(j->arena, (size_t)shut.count, sizeof(mt_segment));
    if (!shut.segments) return MT_NO_MEMORY;
    for (int i = 0; i < shut.count; i++)
        shut.segments[i] = (mt_segment){outline.contours[0].segments[i].degree, {point}, point};
    *masters = in_a ? (mt_masters){outline.contours[0], shut} : (mt_masters){shut, outline.contours[0]};
    return MT_OK;
}

/* ---- a component
 * --------------------------------------------------------------------------------------------- */

/* Pairs holes, nearest first: partner[i] is the hole of B that goes with hole i of A, or 0. */
static mt_status pair_holes(const mt_joining *j, int *partner, bool *taken) {
    for (;;) {
        double least = HOLE_DISTANCE;
        mt_link best = {0, 0};
        for (int p = 1; p < j->in_a->count; p++)
            for (int q = 1; q < j->in_b->count && !partner[p]; q++) {
                if (taken[q]) continue;
                double d = apart(&j->in_a->rings[p], j->a->box, &j->in_b->rings[q], j->b->box);
                if (d >= least) continue;
                least = d;
                best = (mt_link){p, q};
            }
        if (best.a == 0) return MT_OK;
        partner[best.a] = best.b;
        taken[best.b] = true;
    }
}

static mt_status join_holes(const mt_joining *j, int k, int l, mt_masters *contours, int *count) {
    int *partner = mt_arena_new(j->arena, (size_t)j->in_a->count, sizeof *partner);
    bool *taken = mt_arena_new(j->arena, (size_t)j->in_b->count, sizeof *taken);
    if (!partner || !taken) return MT_NO_MEMORY;
    mt_status status = pair_holes(j, partner, taken);
    for (int p = 1; status == MT_OK && p < j->in_a->count; p++) {
        const mt_ring *hole = &j->in_a->rings[p];
        if (partner[p])
            status = join_rings(j, hole, &j->in_b->rings[partner[p]], &contours[*count]);
        else
            status = close_hole(j, hole, point_inside(hole, j->a->box, j->b, l), true, &contours[*count]);
        *count += contours[*count].a.count > 0;
    }
    for (int q = 1; status == MT_OK && q < j->in_b->count; q++) {
        if (taken[q]) continue;
        const mt_ring *hole = &j->in_b->rings[q];
        status = close_hole(j, hole, point_inside(hole, j->b->box, j->a, k), false, &contours[*count]);
        *count += contours[*count].a.count > 0;
    }
    return status;
}

/* Whether the contours at T = t keep clear of themselves and of each other. */
static mt_status is_clean(const mt_joining *j, const mt_masters *contours, int count, double t, bool *clean) {
    mt_outline outline = {count, mt_arena_new(j->arena, (size_t)count, sizeof(mt_contour))};
    mt_shape shape;
    if (!outline.contours) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) {
        mt_status status = mt_masters_mix(&contours[i], mt_weights_at(t), j->arena, &outline.contours[i]);
        if (status != MT_OK) return status;
    }
    return mt_outline_resolve(&outline, mt_grid_units(j->params->tolerance), j->arena, &shape, clean);
}

mt_status mt_join(const mt_side *a, int k, const mt_side *b, int l, const mt_params *params, mt_arena *arena,
                  mt_masters *contours, int *made) {
    mt_joining j = {a, b, &a->shape.components[k], &b->shape.components[l], params, arena};
    bool clean = false;
    int count = 1;
    mt_status status = join_rings(&j, &j.in_a->rings[0], &j.in_b->rings[0], &contours[0]);
    if (status == MT_OK) status = join_holes(&j, k, l, contours, &count);
    if (status == MT_OK) status = is_clean(&j, contours, count, 0.5, &clean);
    if (status == MT_OK) *made = clean ? count : 0;
    return status;
}
