/* From two shapes to a morph, in the order of the paper.
 *
 *     B ── turned by −q (2.3) ──▶ both plain ──▶ matched with A's components (2.2.1) ──▶ method joint: joined (trials.c), the rest decomposed and linked
 *                                                                    └──▶ method paper: decomposed (2.1), linked (2.2.2)
 *
 * The angle q, when it is to be found, takes a matching of its own before. Invariant: the morph's shapes and arrays live in the arena or in
 * the caller's shapes. The cost is that of the trials, or of the triangulations with the paper's method. */
#include "morph/prepare.h"

#include <assert.h>

#include "geometry/limits.h"
#include "geometry/plain.h"
#include "geometry/union.h"
#include "morph/paper/components.h"
#include "morph/paper/pieces.h"
#include "morph/paper/rotation.h"
#include "morph/trials.h"

/* ---- 2.3 formula (5): B turned by -q ------------------------------------------------------------------- */

static mt_status turn_b(mt_morph *morph, const mt_params *params, mt_arena *arena) {
    if (params->rotation == MT_ROTATION_NONE) return MT_OK;
    morph->degrees = params->degrees;
    if (params->rotation == MT_ROTATION_FOUND) {
        mt_status status = mt_match_sides(morph, params, arena); /* unturned, to compare their axes */
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

/* Hints have B's places as drawn; the morph has them turned with B. */
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

/* ---- sides ------------------------------------------------------------------------------------------------ */

static mt_status make_plain(mt_side *side, mt_arena *arena) {
    mt_status status = mt_shape_make_plain(&side->whole, arena, &side->whole);
    if (status != MT_OK) return status;
    side->shape = side->whole;
    side->box = mt_shape_box(&side->whole);
    return side->whole.count > MT_COMPONENTS_MAX ? MT_TOO_LARGE : MT_OK;
}

static mt_status make_both_plain(mt_morph *morph, mt_arena *arena) {
    mt_status status = make_plain(&morph->a, arena);
    if (status == MT_OK) status = make_plain(&morph->b, arena);
    bool one_blank = (morph->a.whole.count == 0) != (morph->b.whole.count == 0);
    return status == MT_OK && one_blank ? MT_NO_COUNTERPART : status;
}

/* ---- all of it ----------------------------------------------------------------------------------------- */

mt_status mt_morph_prepare(const mt_shape *a, const mt_shape *b, const mt_hints *hints,
                           const mt_params *params, mt_arena *arena, mt_morph *morph) {
    mt_morph made = {.a = {.whole = *a, .shape = *a, .box = mt_shape_box(a)},
                     .b = {.whole = *b, .shape = *b, .box = mt_shape_box(b)}};
    if ((a->count == 0) != (b->count == 0)) return MT_NO_COUNTERPART;
    if (a->count > MT_COMPONENTS_MAX || b->count > MT_COMPONENTS_MAX) return MT_TOO_LARGE;
    mt_status status = a->count ? turn_b(&made, params, arena) : MT_OK;
    if (status == MT_OK) status = make_both_plain(&made, arena);
    bool drawn = made.a.whole.count > 0;
    made.proved = !drawn;
    if (status == MT_OK && drawn) status = mt_match_sides(&made, params, arena);
    mt_hints turned = {0};
    if (status == MT_OK && hints) status = turn_hints(hints, &made, mt_shape_box(b), arena, &turned);
    bool joint = drawn && params->method == MT_METHOD_JOINT;
    if (status == MT_OK)
        status = joint ? mt_join_best(&made, &turned, params, arena) : mt_map_pieces(&made, params, arena);
    assert(status != MT_OK || mt_morph_is_valid(&made));
    if (status == MT_OK) *morph = made;
    return status;
}
