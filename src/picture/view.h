/* One character as the engine sees it, for the inspection's picture and for its data. */
#ifndef MT_PICTURE_VIEW_H
#define MT_PICTURE_VIEW_H

#include "blend/pair.h"

typedef struct mt_view {
    uint32_t code_point;
    bool paired; /* there is a second font; otherwise only pair.a, pair.advance_a and pair.morph.a are set */
    mt_glyph_pair pair;
} mt_view;

/* Decomposes the character in A and, with B not NULL, in B, and matches both, by its hints in `hints` (unless
 * NULL); in the arena. MT_NO_GLYPH, and what mt_glyph_pair_prepare gives. */
mt_status mt_view_prepare(mt_font *a, mt_font *b, uint32_t code_point, const mt_hint_index *hints,
                          const mt_params *params, mt_arena *arena, mt_view *view);

#endif
