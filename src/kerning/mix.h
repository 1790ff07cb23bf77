/* Pair adjustment at some places: values mixed and rounded, glyphs that kern alike at all of them brought together. */
#pragma once

#include "kerning/pairs.h"
#include "layout/value_write.h"

typedef struct mt_mixed_pairs {
    int glyph_count;
    mt_value_rows values; /* how cells and listed values are kept; the parts are those of mt_pairs */
    int row_count,
        column_count; /* row 0 and column 0 are all 0; no other row or column is, and no two are equal */
    uint16_t *row_of, *column_of; /* of each glyph */
    int32_t *cells;               /* row_count × column_count rows of values */
    int listed_count;
    mt_listed_pair *listed; /* ascending; those whose value is not their cell's */
    int32_t *listed_values; /* listed_count rows of values */
} mt_mixed_pairs;

/* MT_NO_MEMORY; MT_TOO_LARGE as mt_pairs_divide. */
mt_status mt_pairs_mix(const mt_pairs *pairs, const mt_places *places, mt_arena *arena,
                       mt_mixed_pairs *mixed);

const int32_t *mt_mixed_cell(const mt_mixed_pairs *mixed, int row, int column);
const int32_t *mt_mixed_listed(const mt_mixed_pairs *mixed, int i);
