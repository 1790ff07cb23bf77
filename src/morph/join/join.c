/* One pair of parts joined: a contour pair for each pair of rings.
 *
 *     A ┌──────┐       B ╭──────╮     outer with outer, o with o': aligned (align.c) and fitted (contour_pair.c)
 *       │ o  h │         │ o'   │     h has no counterpart: slit open (slit.c), or it closes (closing.c)
 *       └──────┘         ╰──────╯
 *
 * Parts that are the same points, shifted, are not aligned: one fit serves both, so that theorem 1 of section 2.3 holds for them exactly.
 * A pair is left to the paper's links where an alignment costs more than the caller allows, or where the half-way contours cover more than
 * OVERLAP_MOST of their ink twice, or miss it. O(n m) for n and m samples of two rings, but for slits. */
#include "morph/join/join.h"

#include <math.h>

#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/align/align.h"
#include "morph/align/cache.h"
#include "morph/fit/contour_pair.h"
#include "morph/fit/smooth.h"
#include "morph/join/closing.h"
#include "morph/join/holes.h"

/* Samples of a ring that are aligned, at least; more where the drawing has more vertices. */
#define RING_SAMPLES 140.0

/* The most by which a master may depart from its curve to be smooth in between, in tolerances of the fit. */
#define SMOOTHING 2.0

/* The most that half-way contours may cover twice, or miss, of their ink. */
#define OVERLAP_MOST 0.25

/* ---- two rings ----------------------------------------------------------------------------------------- */

/* Aligns two rings and fits a contour pair to them. *cost: of the alignment. */
static mt_status fit_rings(const mt_joining *j, const mt_ring *p, const mt_ring *q, mt_contour_pair *masters,
                           double *cost) {
    mt_ring_samples a, b;
    mt_links pins;
    mt_alignment alignment;
    double flatness = j->context->settings.flatness, fit = mt_grid_units(j->context->params->fit);
    mt_status status = mt_ring_samples_at_least(p, flatness, RING_SAMPLES, j->arena, &a);
    if (status == MT_OK) status = mt_ring_samples_at_least(q, flatness, RING_SAMPLES, j->arena, &b);
    if (status == MT_OK) status = mt_pins_of(j->context->hints, &a, &b, j->arena, &pins);
    if (status == MT_OK)
        status = mt_align(&a, &j->a.frame, &b, &j->b.frame, &j->context->settings.align, &pins, j->arena,
                          &alignment);
    if (status != MT_OK) return status;
    *cost = alignment.cost;
    status = mt_contour_pair_fit(&a, &b, &alignment, fit, j->arena, masters);
    return status == MT_OK ? mt_contour_pair_smooth(masters, SMOOTHING * fit, j->arena) : status;
}

/* The same by the cache. With hints, which pin rings, nothing is cached. */
static mt_status join_rings(mt_joining *j, const mt_ring *p, const mt_ring *q, mt_contour_pair *masters) {
    mt_alignment_cache *cache = j->context->hints->count ? NULL : j->context->settings.cache;
    mt_cache_key key = {p, q, j->a.frame, j->b.frame, j->context->settings.align, true};
    const mt_cache_entry *before = mt_alignment_cache_find(cache, &key);
    double cost = before ? before->cost : 0;
    mt_status status = MT_OK;
    if (before)
        *masters = before->pair;
    else
        status = fit_rings(j, p, q, masters, &cost);
    if (status == MT_OK && !before) status = mt_alignment_cache_add(cache, &key, cost, masters, j->arena);
    j->costliest = fmax(j->costliest, cost);
    return status;
}

/* ---- drawable contours --------------------------------------------------------------------------- */

/* Whether the half-way contours hardly overlap themselves or each other. */
static mt_status is_drawable(const mt_joining *j, const mt_contour_pair *contours, int count,
                             bool *drawable) {
    mt_outline outline = {count, mt_arena_new(j->arena, (size_t)count, sizeof(mt_contour))};
    mt_rings rings;
    mt_shape shape;
    if (!outline.contours) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (int i = 0; status == MT_OK && i < count; i++)
        status = mt_contour_pair_mix(&contours[i], mt_weights_at(0.5), j->arena, &outline.contours[i]);
    if (status == MT_OK) status = mt_flatten(&outline, j->context->settings.flatness, j->arena, &rings);
    if (status == MT_OK) status = mt_union(&rings, MT_NONZERO, j->arena, &shape);
    if (status != MT_OK) return status;
    double ink = (double)mt_shape_area2(&shape), drawn = (double)mt_component_area2(&rings);
    *drawable = fabs(drawn - ink) <= OVERLAP_MOST * ink;
    return MT_OK;
}

/* ---- equal parts ------------------------------------------------------------------------------ */

/* Whether b is a, shifted: the same points, all by the same vector. */
static bool is_shifted(const mt_component *a, const mt_component *b, mt_point *by) {
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

static mt_status shifted_contour(const mt_contour *contour, mt_point by, mt_arena *arena,
                                 mt_contour *shifted) {
    *shifted = (mt_contour){contour->count, mt_arena_new(arena, (size_t)contour->count, sizeof(mt_segment))};
    if (!shifted->segments) return MT_NO_MEMORY;
    for (int i = 0; i < contour->count; i++) {
        mt_segment s = contour->segments[i];
        s.control[0] = (mt_point){s.control[0].x + by.x, s.control[0].y + by.y};
        s.end = (mt_point){s.end.x + by.x, s.end.y + by.y};
        shifted->segments[i] = s;
    }
    return MT_OK;
}

/* Theorem 1 for a part: both are equal but for a shift, and so is each in-between. */
static mt_status join_equal(const mt_joining *j, mt_point by, mt_contour_pair *contours, int *count) {
    mt_outline outline;
    double tolerance = j->context->settings.flatness, fit = mt_grid_units(j->context->params->fit);
    mt_status status = mt_fit(j->a.component, tolerance, fit, j->arena, &outline);
    for (int i = 0; status == MT_OK && i < outline.count; i++) {
        contours[*count].a = outline.contours[i];
        status = shifted_contour(&outline.contours[i], by, j->arena, &contours[(*count)++].b);
    }
    return status;
}

/* ---- parts --------------------------------------------------------------------------------------------- */

/* A hole without a counterpart closes, carried by the contours that the part has by then. */
static mt_status close_holes(const mt_joining *j, const int *partner, bool in_a,
                             const mt_contour_pair *around, int around_count, mt_contour_pair *contours,
                             int *count) {
    const mt_part *own = in_a ? &j->a : &j->b, *other = in_a ? &j->b : &j->a;
    mt_shape ink = {1, (mt_component *)other->component};
    mt_closing closing = {.in_a = in_a, .ink = &ink, .params = j->context->params};
    mt_status status = mt_carrier_of(around, around_count, in_a, own->frame.box, other->frame.box, j->arena,
                                     &closing.carrier);
    for (int i = 1; status == MT_OK && i < own->component->count; i++)
        if (!partner[i])
            status = mt_close_region(&(mt_rings){1, &own->component->rings[i]}, &closing, j->arena, contours,
                                     count);
    return status;
}

static mt_status join_all(mt_joining *j, mt_contour_pair *contours, int *count) {
    mt_hole_pairs pairs;
    mt_contour_pair *around = contours + *count;
    mt_status status = mt_pair_holes(j, &pairs);
    const mt_component *a = j->a.component, *b = j->b.component;
    if (status == MT_OK) status = join_rings(j, &a->rings[0], &b->rings[0], &contours[(*count)++]);
    for (int i = 1; status == MT_OK && i < a->count; i++)
        if (pairs.in_b[i])
            status = join_rings(j, &a->rings[i], &b->rings[pairs.in_b[i]], &contours[(*count)++]);
    int joined = (int)(contours + *count - around);
    if (status == MT_OK) status = close_holes(j, pairs.in_b, true, around, joined, contours, count);
    return status == MT_OK ? close_holes(j, pairs.in_a, false, around, joined, contours, count) : status;
}

mt_status mt_join(mt_part a, mt_part b, double most, const mt_join_context *context, mt_arena *arena,
                  mt_contour_pair *contours, int *count) {
    mt_joining j = {a, b, context, arena, 0};
    mt_point by;
    if (is_shifted(a.component, b.component, &by)) return join_equal(&j, by, contours, count);
    int before = *count;
    bool drawable = false;
    mt_status status = join_all(&j, contours, count);
    if (status == MT_OK) status = is_drawable(&j, contours + before, *count - before, &drawable);
    if (status == MT_OK && (!drawable || j.costliest > most)) *count = before;
    return status;
}
