/* A prepared pair, or one glyph decomposed by itself. */
#include "picture/view.h"

#include "geometry/decompose.h"
#include "glyphset/match.h"

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

static mt_status prepare(mt_row *row, const mt_choice *choice, mt_choice_glyphs glyphs, mt_arena *arena,
                         mt_view *view) {
    *view = (mt_view){.choice = choice, .glyphs = glyphs, .paired = glyphs.b != MT_NO_PARTNER};
    mt_status status = mt_pair_prepare(row, 0, glyphs.a, glyphs.b, arena, &view->pair);
    if (status != MT_OK || view->paired) return status;
    return decompose(&view->pair.a, arena, &view->pair.morph.a);
}

mt_status mt_views_make(mt_row *row, const mt_inspection *what, mt_view_taken take, void *user, int *failed) {
    mt_arena arena = {0}, kept = {0};
    mt_choice_glyphs *glyphs;
    mt_status status = mt_choices_pair(row, what->choices, what->count, &kept, &glyphs, failed);
    for (int i = 0; status == MT_OK && i < what->count; i++) {
        mt_view view;
        mt_arena_reset(&arena);
        status = prepare(row, &what->choices[i], glyphs[i], &arena, &view);
        if (status != MT_OK)
            *failed = i;
        else
            status = take(&view, i, &arena, user);
    }
    mt_arena_release(&arena);
    mt_arena_release(&kept);
    return status;
}
