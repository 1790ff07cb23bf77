/* What mt_math holds, shared by the files that prepare and write it: as mt_math_table has it, with the new font's glyphs. A row
 * is a value in each font, in the new font's units. */
#pragma once

#include "math/math.h"
#include "math/table/math_table.h"

typedef struct mt_math_row {
    uint16_t glyph;
    bool in_first; /* the first font has the value itself */
    const double *in_fonts;
} mt_math_row;

typedef struct mt_math_rows {
    int count;
    mt_math_row *list; /* ascending by glyph */
} mt_math_rows;

typedef struct mt_math_kern_rows {
    bool present;
    int count;                     /* of the heights */
    const double *heights, *kerns; /* rows one behind the other; of the kerns one more */
} mt_math_kern_rows;

typedef struct mt_math_corner_rows {
    uint16_t glyph;
    mt_math_kern_rows corners[MT_MATH_CORNERS];
} mt_math_corner_rows;

typedef struct mt_math_variant_row {
    uint16_t glyph;
    const double *measure;
} mt_math_variant_row;

typedef struct mt_math_part_row {
    uint16_t glyph;
    unsigned flags;
    const double *start, *end, *full;
} mt_math_part_row;

typedef struct mt_math_growth {
    uint16_t glyph;
    int variant_count, part_count; /* without parts there is no assembly */
    mt_math_variant_row *variants;
    mt_math_part_row *parts;
    const double *italics;
} mt_math_growth;

typedef struct mt_math_growths {
    int count;
    mt_math_growth *list; /* ascending by glyph */
} mt_math_growths;

struct mt_math {
    bool has_constants;
    const double *constants[MT_MATH_CONSTANTS];
    mt_math_rows italics, accents;
    int extended_count;
    uint16_t *extended; /* ascending */
    int kern_count;
    mt_math_corner_rows *kerns; /* ascending by glyph */
    const double *least_overlap;
    mt_math_growths growths[MT_MATH_DIRECTIONS];
};
