/* One character as the engine sees it, for the inspection's picture and for its data. */
#pragma once

#include "blend/pair.h"

typedef struct mt_view {
    uint32_t code_point;
    bool paired; /* there is a second font; otherwise only pair.a, its advance and pair.morph.a are set */
    mt_glyph_pair pair;
} mt_view;

/* Prepares the character between the row's first two fonts, in the arena; of a row of one font, decomposes it. As
 * mt_pair_prepare_char. */
mt_status mt_view_prepare(mt_row *row, uint32_t code_point, mt_arena *arena, mt_view *view);
