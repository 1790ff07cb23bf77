/* One character or glyph as the engine sees it, for the inspection's picture and for its data. */
#pragma once

#include "blend/pair.h"
#include "picture/picture.h"

typedef struct mt_view {
    const mt_choice *choice;
    mt_choice_glyphs glyphs;
    bool paired; /* there is a second glyph; otherwise only pair.a, its advance and pair.morph.a are set */
    mt_glyph_pair pair;
} mt_view;

/* Takes a view that lasts as long as the call; the arena is for what is made of it. */
typedef mt_status (*mt_view_taken)(const mt_view *view, int index, mt_arena *arena, void *user);

/* Prepares each choice between the row's first two fonts, one by one in their order; decomposes a glyph that is alone. Where one
 * cannot be made, *failed is its index. As mt_choices_pair, mt_pair_prepare and `take`. */
mt_status mt_views_make(mt_row *row, const mt_inspection *what, mt_view_taken take, void *user, int *failed);
