#include "morph/join.h"

#include <math.h>

#include "geometry/decompose.h"
#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/align.h"
#include "morph/masters.h"

#define STOPS_A_RING                                                                                         \
    140.0 /* places along a ring that are aligned, at least; more where the drawing has more vertices */
#define HOLE_DISTANCE                                                                                        \
    0.25 /* between the barycentres of two holes that are taken for counterparts, in boxes */

typedef struct mt_joining {
    mt_part a, b;
    const mt_params *params;
    mt_arena *arena;
} mt_joining;

/* ---- two rings ----------------------------------------------------------------------------------------- */

static mt_status stops_of(const mt_joining *j, const mt_ring *ring, mt_stops *stops) {
    mt_trace trace;
    double chord = mt_grid_units(j->params->tolerance);
    mt_status status = mt_trace_ring(ring, chord, j->arena, &trace);
    double step = fmax(1, mt_ring_length(ring) / STOPS_A_RING);
    return status == MT_OK ? mt_stops_of(&trace, chord, step, j->arena, stops) : status;
}

static mt_status join_rings(const mt_joining *j, const mt_ring *p, const mt_ring *q, mt_masters *masters) {
    mt_stops a, b;
    mt_alignment alignment;
    mt_status status = stops_of(j, p, &a);
    if (status == MT_OK) status = stops_of(j, q, &b);
    if (status == MT_OK) status = mt_align(&a, j->a.box, &b, j->b.box, j->arena, &alignment);
    if (status != MT_OK) return status;
    return mt_masters_fit(&a, &b, &alignment, mt_grid_units(j->params->fit), j->arena, masters);
}

/* ---- holes without a counterpart ----------------------------------------------------------------------- */

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

/* A point in the ink of a part: the barycentre of the piece that lies nearest to the hole's own place. A piece is convex,
 * so its barycentre is inside it. */
static mt_status point_inside(const mt_joining *j, const mt_ring *hole, mt_box box, mt_part to,
                              mt_point *found) {
    mt_pieces pieces;
    mt_status status = mt_decompose(to.component, j->arena, &pieces);
    if (status != MT_OK) return status;
    double least = INFINITY;
    for (int i = 0; i < pieces.count; i++) {
        double d = apart(hole, box, &pieces.rings[i], to.box);
        if (d >= least) continue;
        least = d;
        double x, y;
        mt_ring_centre(&pieces.rings[i], &x, &y);
        *found = (mt_point){(int32_t)lround(x), (int32_t)lround(y)};
    }
    return MT_OK;
}

/* The hole's own contour on the one side, all of it at one point on the other. */
static mt_status close_hole(const mt_joining *j, const mt_ring *hole, bool in_a, mt_masters *masters) {
    mt_rings one = {1, (mt_ring *)hole};
    mt_outline outline;
    mt_point point;
    double tolerance = mt_grid_units(j->params->tolerance), fit = mt_grid_units(j->params->fit);
    *masters = (mt_masters){0};
    mt_status status = mt_fit(&one, tolerance, fit, j->arena, &outline);
    if (status != MT_OK || outline.count == 0) return status;
    status = point_inside(j, hole, in_a ? j->a.box : j->b.box, in_a ? j->b : j->a, &point);
    if (status != MT_OK) return status;
    mt_contour open = outline.contours[0], shut = {open.count, NULL};
    shut.segments = mt_arena_new(j->arena, (size_t)shut.count, sizeof(mt_segment));
    if (!shut.segments) return MT_NO_MEMORY;
    for (int i = 0; i < shut.count; i++)
        shut.segments[i] = (mt_segment){open.segments[i].degree, {point}, point};
    *masters = in_a ? (mt_masters){open, shut} : (mt_masters){shut, open};
    return MT_OK;
}

/* ---- a component --------------------------------------------------------------------------------------- */

/* Pairs holes, nearest first: partner[i] is the hole of B that goes with hole i of A, or 0. */
static mt_status pair_holes(const mt_joining *j, int *partner, bool *taken) {
    for (;;) {
        double least = HOLE_DISTANCE;
        mt_link best = {0, 0};
        for (int p = 1; p < j->a.component->count; p++)
            for (int q = 1; q < j->b.component->count && !partner[p]; q++) {
                if (taken[q]) continue;
                double d = apart(&j->a.component->rings[p], j->a.box, &j->b.component->rings[q], j->b.box);
                if (d >= least) continue;
                least = d;
                best = (mt_link){p, q};
            }
        if (best.a == 0) return MT_OK;
        partner[best.a] = best.b;
        taken[best.b] = true;
    }
}

static mt_status join_holes(const mt_joining *j, mt_masters *contours, int *count) {
    const mt_rings *in_a = j->a.component, *in_b = j->b.component;
    int *partner = mt_arena_new(j->arena, (size_t)in_a->count, sizeof *partner);
    bool *taken = mt_arena_new(j->arena, (size_t)in_b->count, sizeof *taken);
    if (!partner || !taken) return MT_NO_MEMORY;
    mt_status status = pair_holes(j, partner, taken);
    for (int p = 1; status == MT_OK && p < in_a->count; p++) {
        mt_masters *to = &contours[*count];
        if (partner[p])
            status = join_rings(j, &in_a->rings[p], &in_b->rings[partner[p]], to);
        else
            status = close_hole(j, &in_a->rings[p], true, to);
        *count += to->a.count > 0;
    }
    for (int q = 1; status == MT_OK && q < in_b->count; q++) {
        if (taken[q]) continue;
        status = close_hole(j, &in_b->rings[q], false, &contours[*count]);
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

/* ---- parts that are alike ----------------------------------------------------------------------------------- */

/* Whether b is a, moved: the same points all by the same way. */
static bool is_moved(const mt_component *a, const mt_component *b, mt_point *by) {
    if (a->count != b->count) return false;
    mt_point p = a->rings[0].points[0], q = b->rings[0].points[0];
    *by = (mt_point){q.x - p.x, q.y - p.y};
    for (int i = 0; i < a->count; i++) {
        if (a->rings[i].count != b->rings[i].count) return false;
        for (int k = 0; k < a->rings[i].count; k++) {
            p = a->rings[i].points[k];
            if (!mt_point_equal(b->rings[i].points[k], (mt_point){p.x + by->x, p.y + by->y})) return false;
        }
    }
    return true;
}

static mt_status moved_contour(const mt_contour *contour, mt_point by, mt_arena *arena, mt_contour *moved) {
    *moved = (mt_contour){contour->count, mt_arena_new(arena, (size_t)contour->count, sizeof(mt_segment))};
    if (!moved->segments) return MT_NO_MEMORY;
    for (int i = 0; i < contour->count; i++) {
        mt_segment s = contour->segments[i];
        s.control[0] = (mt_point){s.control[0].x + by.x, s.control[0].y + by.y};
        s.end = (mt_point){s.end.x + by.x, s.end.y + by.y};
        moved->segments[i] = s;
    }
    return MT_OK;
}

/* Theorem 1 for a part: where both are alike, there is nothing to align, and each in-between is alike too. */
static mt_status join_alike(const mt_joining *j, mt_point by, mt_masters *contours, int *made) {
    mt_outline outline;
    double tolerance = mt_grid_units(j->params->tolerance), fit = mt_grid_units(j->params->fit);
    mt_status status = mt_fit(j->a.component, tolerance, fit, j->arena, &outline);
    for (int i = 0; status == MT_OK && i < outline.count; i++) {
        contours[i].a = outline.contours[i];
        status = moved_contour(&outline.contours[i], by, j->arena, &contours[i].b);
    }
    if (status == MT_OK) *made = outline.count;
    return status;
}

mt_status mt_join(mt_part a, mt_part b, const mt_params *params, mt_arena *arena, mt_masters *contours,
                  int *made) {
    mt_joining j = {a, b, params, arena};
    mt_point by;
    if (is_moved(a.component, b.component, &by)) return join_alike(&j, by, contours, made);
    bool clean = false;
    int count = 1;
    mt_status status = join_rings(&j, &a.component->rings[0], &b.component->rings[0], &contours[0]);
    if (status == MT_OK) status = join_holes(&j, contours, &count);
    if (status == MT_OK) status = is_clean(&j, contours, count, 0.5, &clean);
    if (status == MT_OK) *made = clean ? count : 0;
    return status;
}
