#include "morph/model/morph.h"

#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/fit/contour_pair.h"
#include "morph/paper/pieces.h"
#include "morph/paper/relax.h"
#include "morph/paper/rotation.h"
#include "morph/paper/similarity.h"
#include "morph/trials.h"

/* ---- 2.2.1 mapping the connected weights --------------------------------------------------------------- */

static mt_hull *hulls_of(const mt_side *side, mt_arena *arena, mt_status *status) {
    mt_hull *hulls = mt_arena_new(arena, (size_t)side->shape.count, sizeof *hulls);
    *status = hulls ? MT_OK : MT_NO_MEMORY;
    for (int k = 0; *status == MT_OK && k < side->shape.count; k++)
        *status = mt_hull_of(&side->shape.components[k], side->box, arena, &hulls[k]);
    return hulls;
}

static mt_status match_components(mt_morph *morph, const mt_params *params, mt_arena *arena) {
    int rows = morph->a.shape.count, columns = morph->b.shape.count;
    mt_status status;
    mt_hull *in_a = hulls_of(&morph->a, arena, &status);
    if (status != MT_OK) return status;
    mt_hull *in_b = hulls_of(&morph->b, arena, &status);
    if (status != MT_OK) return status;
    double *s = mt_arena_new(arena, (size_t)rows * (size_t)columns, sizeof *s);
    if (!s) return MT_NO_MEMORY;
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++)
            s[(size_t)i * (size_t)columns + (size_t)j] = mt_similarity(&in_a[i], &in_b[j], params->weights);
    return mt_match_components(s, rows, columns, params->rounds, params->threshold, arena, &morph->matches);
}

/* ---- 2.3 formula (5): B turned by -q ------------------------------------------------------------------- */

static mt_status turn_b(mt_morph *morph, const mt_params *params, mt_arena *arena) {
    if (params->rotation == MT_ROTATION_NONE) return MT_OK;
    morph->degrees = params->degrees;
    if (params->rotation == MT_ROTATION_FOUND) {
        mt_status status = match_components(morph, params, arena); /* as they stand, to compare their axes */
        if (status != MT_OK) return status;
        morph->degrees = mt_find_rotation(&morph->a.shape, &morph->b.shape, &morph->matches);
    }
    mt_rings turned_rings;
    mt_shape turned;
    mt_status status =
        mt_shape_turn(&morph->b.shape, mt_box_middle(morph->b.box), -morph->degrees, arena, &turned);
    if (status == MT_OK) status = mt_shape_rings(&turned, arena, &turned_rings);
    if (status == MT_OK)
        status =
            mt_union(&turned_rings, MT_NONZERO, arena, &morph->b.whole); /* rounding may make edges touch */
    if (status != MT_OK) return status;
    morph->b.shape = morph->b.whole;
    morph->b.box = mt_shape_box(&morph->b.whole);
    return MT_OK;
}

/* Hints give B's places as drawn; the engine looks for them where B was turned to. */
static mt_status turn_hints(const mt_hints *hints, const mt_morph *morph, mt_box box, mt_arena *arena,
                            mt_hints *turned) {
    mt_hint *made = mt_arena_new(arena, (size_t)hints->count, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    for (int i = 0; i < hints->count; i++) {
        made[i] = hints->hints[i];
        if (morph->degrees != 0) made[i].b = mt_turn(made[i].b, mt_box_middle(box), -morph->degrees);
    }
    *turned = (mt_hints){hints->count, made};
    return MT_OK;
}

/* ---- all of it ----------------------------------------------------------------------------------------- */

mt_status mt_morph_prepare(const mt_shape *a, const mt_shape *b, const mt_hints *hints,
                           const mt_params *params, mt_arena *arena, mt_morph *morph) {
    mt_morph made = {.a = {.whole = *a, .shape = *a, .box = mt_shape_box(a)},
                     .b = {.whole = *b, .shape = *b, .box = mt_shape_box(b)}};
    if ((a->count == 0) != (b->count == 0)) return MT_NO_COUNTERPART;
    if (a->count > MT_COMPONENTS_MAX || b->count > MT_COMPONENTS_MAX) return MT_TOO_LARGE;
    mt_status status = a->count ? turn_b(&made, params, arena) : MT_OK;
    if (status == MT_OK && a->count) status = match_components(&made, params, arena);
    mt_hints turned = {0};
    if (status == MT_OK && hints) status = turn_hints(hints, &made, mt_shape_box(b), arena, &turned);
    if (status != MT_OK) return status;
    bool joint = a->count > 0 && params->method == MT_METHOD_JOINT;
    status = joint ? mt_join_best(&made, &turned, params, arena) : mt_map_pieces(&made, params, arena);
    if (status == MT_OK) *morph = made;
    return status;
}

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

/* Between the ends: as they come where that is clean, else the union of all, fitted. Chords instead of curves may touch where
 * the curves do not, so that what is not clean is looked at again, more finely. */
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
    if (weights.b == 0)
        status = mt_shape_outline(&morph->a.whole, params, arena, &made);
    else if (weights.a == 0)
        status = mt_shape_outline(&morph->b.whole, params, arena, &made);
    else
        status = outline_between(morph, weights, params, arena, &made);
    if (status != MT_OK) return status;
    turn_outline_back(morph, weights, &made);
    *outline = made;
    return MT_OK;
}
