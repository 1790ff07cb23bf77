/* Pair adjustment at one T: values mixed and rounded, glyphs that kern alike brought together. */
#ifndef MT_PAIR_MIX_H
#define MT_PAIR_MIX_H

#include "layout/pairs.h"

typedef struct mt_mixed_pairs {
    int glyph_count, part_count;
    const uint8_t *parts; /* as in mt_pairs */
    int row_count,
        column_count; /* row 0 and column 0 are all 0; no other row or column is, and no two are equal */
    uint16_t *row_of, *column_of; /* of each glyph */
    int *cells;                   /* row_count × column_count × part_count */
    int listed_count;
    mt_listed_pair *listed; /* ascending; those whose value is not their cell's */
    int *listed_values;     /* listed_count × part_count */
} mt_mixed_pairs;

/* MT_NO_MEMORY. */
mt_status mt_pairs_mix(const mt_pairs *pairs, double t, mt_arena *arena, mt_mixed_pairs *mixed);

const int *mt_mixed_cell(const mt_mixed_pairs *mixed, int row, int column);

#endif
