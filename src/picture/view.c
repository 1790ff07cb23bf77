/* A prepared pair, or one glyph decomposed by itself. */
#include "picture/view.h"

#include "geometry/decompose.h"

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

mt_status mt_view_prepare(mt_row *row, uint32_t code_point, mt_arena *arena, mt_view *view) {
    *view = (mt_view){.code_point = code_point, .paired = row->font_count > 1};
    mt_status status = mt_pair_prepare_char(row, code_point, arena, &view->pair);
    if (status != MT_OK || view->paired) return status;
    return decompose(&view->pair.a, arena, &view->pair.morph.a);
}
