/* What a picture, an inspection or a hint is of: an mt_choice, a character or a glyph of the first font. */
#pragma once

#include "blend/row.h"

/* Writes U+0041 or /NAME; cut where it does not fit. */
enum { MT_CHOICE_LABEL_ROOM = 260 };
void mt_choice_label(const mt_choice *choice, char label[MT_CHOICE_LABEL_ROOM]);

/* The row keeps these characters and glyphs alone. As mt_row_set_chars and mt_row_set_glyph_numbers. */
mt_status mt_row_choose(mt_row *row, const mt_choice *choices, int count);

typedef struct mt_choice_glyphs {
    uint32_t a, b; /* b is MT_NO_PARTNER where the second font has none, and in a row of one font */
} mt_choice_glyphs;

/* The glyphs of each choice in the first two fonts, in the arena: those that a character has by itself, and a named glyph's
 * partner in a blend of all characters. A named glyph without one is told to the row's `kept`. As mt_row_glyphs_make; MT_NO_GLYPH
 * when a font lacks a character, *failed is then its index. */
mt_status mt_choices_pair(mt_row *row, const mt_choice *choices, int count, mt_arena *arena,
                          mt_choice_glyphs **glyphs, int *failed);
