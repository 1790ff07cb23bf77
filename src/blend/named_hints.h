/* The glyphs that hints by name are for: those of the first font, and their partners in a blend of all characters. */
#pragma once

#include "hints/index.h"

/* Fills glyphs[i], for each step from font number i to the next of `count`, with those of each of the table's lines by name; in the arena, NULL
 * where there are no such lines. MT_BAD_HINTS, with `error` (unless NULL) filled in, for a name that the first font has not;
 * as mt_row_glyphs_make. */
mt_status mt_named_hints_find(mt_font *const *fonts, int count, const mt_given_pairs *pairs,
                              const mt_hint_table *table, mt_arena *arena, mt_hint_glyphs **glyphs,
                              mt_hint_error *error);
