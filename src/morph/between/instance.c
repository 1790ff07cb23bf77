/* Section 2.3: the blend C(r) by formula (4), and C_int(r) by formula (5), at one pair of weights, or at one across and another upwards.
 *
 *     joined components   contour pairs mixed point by point, displaced ───┐
 *     links               rAᵢ ⊕ (1 − r)Bⱼ ── union ── curves fitted ───────┴─ do they overlap? ── union of all, fitted
 *
 * Theorem 1: at r = 1 and r = 0 the outline is A's and B's own, fitted, with its cuts closed. Chords may touch where the curves do not:
 * an overlap is confirmed with chords MT_OVERLAP_CARE times as fine. O(n log n) for n vertices of all sums and contours, in practice. */
#include "morph/between/instance.h"

#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/fit/contour_pair.h"
#include "morph/paper/rotation.h"

/* ---- 2.3 the blend ------------------------------------------------------------------------------------- */

/* Formula (4): a Minkowski sum for each link, and room for `more` rings after them. */
static mt_status sums_of_links(const mt_morph *morph, mt_weights weights, int more, mt_arena *arena,
                               mt_rings *sums) {
    size_t room = (size_t)morph->links.count + (size_t)more;
    *sums = (mt_rings){morph->links.count, mt_arena_new(arena, room, sizeof(mt_ring))};
    if (!sums->rings) return MT_NO_MEMORY;
    for (int i = 0; i < sums->count; i++) {
        const mt_ring *p = &morph->a.pieces.rings[morph->links.links[i].a];
        const mt_ring *q = &morph->b.pieces.rings[morph->links.links[i].b];
        mt_status status = mt_ring_new(arena, p->count + q->count, &sums->rings[i]);
        if (status != MT_OK) return status;
        mt_minkowski(p, q, weights, &sums->rings[i]);
    }
    return MT_OK;
}

/* The contours of aligned components, and room for `more` after them. */
static mt_status mix_contours(const mt_morph *morph, mt_weights weights, int more, mt_arena *arena,
                              mt_outline *outline) {
    size_t room = (size_t)morph->contour_count + (size_t)more;
    *outline = (mt_outline){morph->contour_count, mt_arena_new(arena, room, sizeof(mt_contour))};
    if (!outline->contours) return MT_NO_MEMORY;
    for (int i = 0; i < morph->contour_count; i++) {
        mt_status status = mt_contour_pair_mix(&morph->contours[i], weights, arena, &outline->contours[i]);
        if (status != MT_OK) return status;
    }
    return MT_OK;
}

mt_status mt_morph_rings(const mt_morph *morph, mt_weights weights, const mt_params *params, mt_arena *arena,
                         mt_rings *rings) {
    mt_outline aligned;
    mt_rings flat;
    mt_status status = mix_contours(morph, weights, 0, arena, &aligned);
    if (status == MT_OK) status = mt_flatten(&aligned, mt_grid_units(params->tolerance), arena, &flat);
    if (status == MT_OK) status = sums_of_links(morph, weights, flat.count, arena, rings);
    if (status != MT_OK) return status;
    for (int i = 0; i < flat.count; i++) rings->rings[rings->count++] = flat.rings[i];
    for (int i = 0; i < rings->count; i++)
        for (int k = 0; k < rings->rings[i].count; k++)
            rings->rings[i].points[k] = mt_morph_turn(morph, weights, rings->rings[i].points[k]);
    return MT_OK;
}

mt_status mt_morph_blend(const mt_morph *morph, mt_weights weights, const mt_params *params, mt_arena *arena,
                         mt_shape *blend) {
    mt_rings rings;
    mt_status status = mt_morph_rings(morph, weights, params, arena, &rings);
    return status == MT_OK ? mt_union(&rings, MT_NONZERO, arena, blend) : status;
}

/* ---- the blend as curves ------------------------------------------------------------------------------- */

mt_status mt_shape_outline(const mt_shape *shape, const mt_params *params, mt_arena *arena,
                           mt_outline *outline) {
    mt_rings rings;
    mt_status status = mt_shape_rings(shape, arena, &rings);
    if (status != MT_OK) return status;
    return mt_fit(&rings, mt_grid_units(params->tolerance), mt_grid_units(params->fit), arena, outline);
}

/* Aligned contours as they are, and the union of the others' sums, fitted. */
static mt_status both_kinds(const mt_morph *morph, mt_weights weights, const mt_params *params,
                            mt_arena *arena, mt_outline *outline) {
    mt_rings sums;
    mt_shape linked;
    mt_outline fitted;
    mt_status status = sums_of_links(morph, weights, 0, arena, &sums);
    if (status == MT_OK) status = mt_union(&sums, MT_NONZERO, arena, &linked);
    if (status == MT_OK) status = mt_shape_outline(&linked, params, arena, &fitted);
    if (status == MT_OK) status = mix_contours(morph, weights, fitted.count, arena, outline);
    if (status != MT_OK) return status;
    for (int i = 0; i < fitted.count; i++) outline->contours[outline->count++] = fitted.contours[i];
    return MT_OK;
}

static void turn_outline_back(const mt_morph *morph, mt_weights weights, mt_outline *outline) {
    for (int i = 0; i < outline->count; i++)
        for (int k = 0; k < outline->contours[i].count; k++) {
            mt_segment *s = &outline->contours[i].segments[k];
            s->end = mt_morph_turn(morph, weights, s->end);
            s->control[0] = mt_morph_turn(morph, weights, s->control[0]);
        }
}

/* Between the ends: contours as they are where nothing overlaps, else the union of all, fitted. */
static mt_status outline_between(const mt_morph *morph, mt_weights weights, const mt_params *params,
                                 mt_arena *arena, mt_outline *outline) {
    mt_shape shape;
    bool clean = false;
    double tolerance = mt_grid_units(params->tolerance);
    mt_status status = both_kinds(morph, weights, params, arena, outline);
    if (status == MT_OK) status = mt_outline_resolve(outline, tolerance, arena, &shape, &clean);
    if (status == MT_OK && !clean)
        status = mt_outline_resolve(outline, tolerance / MT_OVERLAP_CARE, arena, &shape, &clean);
    return status == MT_OK && !clean ? mt_shape_outline(&shape, params, arena, outline) : status;
}

mt_status mt_morph_outline(const mt_morph *morph, mt_weights weights, const mt_params *params,
                           mt_arena *arena, mt_outline *outline) {
    mt_outline made;
    mt_status status;
    /* Theorem 1: at its ends the blend is A, and B, with the cuts closed along which a component was divided. */
    if (weights.b == 0 && weights.up == 0)
        status = mt_shape_outline(&morph->a.whole, params, arena, &made);
    else if (weights.a == 0 && weights.up == 0)
        status = mt_shape_outline(&morph->b.whole, params, arena, &made);
    else
        status = outline_between(morph, weights, params, arena, &made);
    if (status != MT_OK) return status;
    turn_outline_back(morph, weights, &made);
    *outline = made;
    return MT_OK;
}
