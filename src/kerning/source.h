/* Pair adjustment of one font: subtables of GPOS and of the old 'kern' table, read in one way.
 *
 * A subtable is a list of pairs, or a matrix of classes. What it has for a left glyph is a row, for a right glyph of a
 * matrix a column: numbers without further meaning, the same for glyphs that it does not tell apart, and -1 where it has
 * nothing. */
#pragma once

#include "kerning/subtable.h"
#include "layout/layout.h"

/* The pair adjustment of these lookups of GPOS, in their order. MT_NO_MEMORY. */
mt_status mt_pair_source_gpos(const mt_layout *layout, const int *lookups, int count,
                              const mt_gdef_deltas *variations, double scale, mt_arena *arena,
                              mt_pair_source *source);
bool mt_pair_is_listed(const mt_pair_subtable *subtable);
int mt_pair_row(const mt_pair_subtable *subtable, uint32_t left);
int mt_pair_column(const mt_pair_subtable *subtable, uint32_t right); /* -1 for a list */

/* The right glyphs that a list has for a row (of the glyph `left`), numbered from 0. */
int mt_pair_listed_count(const mt_pair_subtable *subtable, int row, uint32_t left);
uint32_t mt_pair_listed(const mt_pair_subtable *subtable, int row, uint32_t left, int i);

/* A pair as subtables see it: a row and a column in each, and the glyphs for the lists. */
typedef struct mt_pair {
    const int32_t *rows, *columns;
    uint32_t left, right;
} mt_pair;

/* The value of a pair; with rows of -1 in all lists, what the classes alone give. */
void mt_pair_value(const mt_pair_source *source, const mt_pair *pair, double values[MT_PAIR_PARTS]);
