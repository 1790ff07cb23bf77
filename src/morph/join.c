#include "morph/join.h"

#include <math.h>

#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/align.h"
#include "morph/holes.h"
#include "morph/masters.h"

/* Places along a ring that are aligned, at least; more where the drawing has more vertices. */
#define STOPS_A_RING 140.0

/* ---- two rings ----------------------------------------------------------------------------------------- */

static mt_status stops_of(const mt_joining *j, const mt_ring *ring, mt_stops *stops) {
    mt_trace trace;
    double chord = mt_grid_units(j->params->tolerance);
    mt_status status = mt_trace_ring(ring, chord, j->arena, &trace);
    double step = fmax(1, mt_ring_length(ring) / STOPS_A_RING);
    return status == MT_OK ? mt_stops_of(&trace, chord, step, j->arena, stops) : status;
}

mt_status mt_join_rings(const mt_joining *j, const mt_ring *p, const mt_ring *q, mt_masters *masters) {
    mt_stops a, b;
    mt_alignment alignment;
    mt_status status = stops_of(j, p, &a);
    if (status == MT_OK) status = stops_of(j, q, &b);
    if (status == MT_OK) status = mt_align(&a, j->a.box, &b, j->b.box, j->arena, &alignment);
    if (status != MT_OK) return status;
    return mt_masters_fit(&a, &b, &alignment, mt_grid_units(j->params->fit), j->arena, masters);
}

/* ---- a part -------------------------------------------------------------------------------------------- */

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

/* ---- parts that are alike ------------------------------------------------------------------------------ */

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
    mt_status status = mt_join_rings(&j, &a.component->rings[0], &b.component->rings[0], &contours[0]);
    if (status == MT_OK) status = mt_join_holes(&j, contours, &count);
    if (status == MT_OK) status = is_clean(&j, contours, count, 0.5, &clean);
    if (status == MT_OK) *made = clean ? count : 0;
    return status;
}
