#include "picture/view.h"

#include "geometry/decompose.h"
#include "morph/model/params.h"

#include <string.h>

/* Puts the pieces of one component after those of the ones before it. */
static mt_status append_pieces(mt_side *side, const mt_pieces *pieces, mt_arena *arena) {
    if (pieces->count == 0) return MT_OK;
    mt_ring *all = mt_arena_new(arena, (size_t)side->pieces.count + (size_t)pieces->count, sizeof *all);
    if (!all) return MT_NO_MEMORY;
    if (side->pieces.count > 0) memcpy(all, side->pieces.rings, (size_t)side->pieces.count * sizeof *all);
    memcpy(all + side->pieces.count, pieces->rings, (size_t)pieces->count * sizeof *all);
    side->pieces.rings = all;
    side->pieces.count += pieces->count;
    return MT_OK;
}

/* The one side of a morph without a partner. */
static mt_status decompose(const mt_shape *shape, mt_arena *arena, mt_side *side) {
    *side = (mt_side){.shape = *shape, .box = mt_shape_box(shape)};
    side->first = mt_arena_new(arena, (size_t)shape->count + 1, sizeof *side->first);
    if (!side->first) return MT_NO_MEMORY;
    for (int i = 0; i < shape->count; i++) {
        mt_pieces pieces;
        mt_status status = mt_decompose(&shape->components[i], arena, &pieces);
        if (status == MT_OK) status = append_pieces(side, &pieces, arena);
        if (status != MT_OK) return status;
        side->first[i + 1] = side->pieces.count;
    }
    return MT_OK;
}

static mt_status prepare_one(mt_font *font, uint32_t code_point, const mt_params *params, mt_arena *arena,
                             mt_glyph_pair *pair) {
    uint32_t glyph = mt_font_glyph(font, code_point);
    if (glyph == 0) return MT_NO_GLYPH;
    mt_status status = mt_glyph_shape(font, glyph, params->tolerance, arena, &pair->a, &pair->advance_a);
    return status == MT_OK ? decompose(&pair->a, arena, &pair->morph.a) : status;
}

mt_status mt_view_prepare(mt_font *a, mt_font *b, uint32_t code_point, const mt_hint_index *hints,
                          const mt_params *params, mt_arena *arena, mt_view *view) {
    *view = (mt_view){.code_point = code_point, .paired = b};
    mt_status status = mt_params_check(params);
    if (status != MT_OK) return status;
    if (!b) return prepare_one(a, code_point, params, arena, &view->pair);
    return mt_glyph_pair_prepare(a, b, code_point, hints, params, arena, &view->pair);
}
