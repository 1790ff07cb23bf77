/* The old 'kern' table (OpenType spec, "kern", and Apple's): subtables of formats 0 and 2. */
#pragma once

#include "kerning/subtable.h"

/* The pair adjustment of a 'kern' table: formats 0 and 2, horizontal, neither of minima nor across the line. MT_NO_MEMORY. */
mt_status mt_pair_source_kern(mt_bytes kern, double scale, mt_arena *arena, mt_pair_source *source);
/* Whether a 'kern' table has any such subtable. */
bool mt_kern_table_kerns(mt_bytes kern);

/* Format 0, pairs in ascending order: those of a left glyph; the value of a pair, 0 where it is not listed. */
int mt_kern_listed_count(const mt_pair_subtable *subtable, uint32_t left);
uint32_t mt_kern_listed(const mt_pair_subtable *subtable, uint32_t left, int i);
double mt_kern_listed_value(const mt_pair_subtable *subtable, uint32_t left, uint32_t right);

/* Format 2: a row is the offset of a left class' values from the subtable's start, a column the offset in the row. */
int mt_kern_row(const mt_pair_subtable *subtable, uint32_t left);
int mt_kern_column(const mt_pair_subtable *subtable, uint32_t right);
double mt_kern_classed_value(const mt_pair_subtable *subtable, int row, int column);
