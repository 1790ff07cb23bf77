/* Hints as the morph takes them: those of a table for each pair of glyphs of two fonts, on the grid. Characters
 * that lead to the same two glyphs have their hints in common, as they share the blend of these glyphs. */
#pragma once

#include "hints/table.h"
#include "source/given_pairs.h"

typedef struct mt_hint_index mt_hint_index;

/* The two glyphs that a name stands for. */
typedef struct mt_hint_glyphs {
    bool paired; /* the hint is left out otherwise */
    uint32_t a, b;
} mt_hint_glyphs;

/* Between fonts number `step` and step + 1, whose glyphs for a character mt_given_glyph finds. `named` has the glyphs of each line of
 * the table by name; it may be NULL where there are none. Keeps neither the table nor the fonts nor the pairs, which may be NULL.
 * Hints for characters that one font lacks are left out. MT_BAD_HINTS, with `error` (unless NULL) filled in, for a place that is over
 * MT_COORD_MAX and for more than MT_GLYPH_HINTS_MAX hints for one pair of glyphs; MT_NO_MEMORY. */
mt_status mt_hint_index_new(const mt_hint_table *table, const mt_hint_glyphs *named, mt_font *const *fonts,
                            int step, const mt_given_pairs *pairs, mt_hint_index **index,
                            mt_hint_error *error);
void mt_hint_index_free(mt_hint_index *index); /* NULL is fine */

/* The hints for A's glyph `a` and B's glyph `b`, in the order of the file; they belong to the index. None
 * where `index` is NULL. */
mt_hints mt_hint_index_find(const mt_hint_index *index, uint32_t a, uint32_t b);

/* The line of the file in which one of the index's hints stands. */
int mt_hint_index_line(const mt_hint_index *index, const mt_hint *hint);
