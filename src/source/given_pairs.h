/* Glyphs of two fonts or more that a person has said to go together, whatever else would pair them. */
#pragma once

#include "source/font.h"

typedef struct mt_given_pairs {
    int font_count, count;
    uint32_t
        *glyphs;  /* rows of `font_count` glyphs, by the first font's, of which no two rows have the same */
} mt_given_pairs; /* all zero is empty */

/* Of `count` rows in any order, which are copied. MT_BAD_PARAMETER for a row with glyph 0 or with one that its font has not, and
 * for two rows of one glyph of the first font; MT_NO_MEMORY. */
mt_status mt_given_pairs_make(const uint32_t *glyphs, int count, mt_font *const *fonts, int font_count,
                              mt_given_pairs *pairs);
void mt_given_pairs_free(mt_given_pairs *pairs);

/* The glyph of font number `font` that goes with a glyph of the first; 0 where none is given. `pairs` may be NULL. */
uint32_t mt_given_partner(const mt_given_pairs *pairs, uint32_t first, int font);

/* The glyph that stands for a character in font number `font`: the partner of the first font's glyph for it, where one is given,
 * otherwise the font's own; 0 where there is none. `pairs` may be NULL. */
uint32_t mt_given_glyph(const mt_given_pairs *pairs, mt_font *const *fonts, int font, uint32_t code_point);
