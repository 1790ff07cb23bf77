/* A MATH table at hand: what its reading shares. Whatever leads out of the table marks it as damaged, and reads as nothing. */
#pragma once

#include "base/memory.h"
#include "layout/gdef_deltas.h"
#include "math/table/math_table.h"

enum { MT_MATH_GLYPHS_MAX = 65535 }; /* of a list that has a record for each */

typedef struct mt_math_reader {
    mt_gdef_deltas deltas;
    int glyph_count; /* of the font */
    mt_arena *arena;
    int left; /* of MT_MATH_RECORDS_MAX */
    bool damaged;
} mt_math_reader;

/* What the 16-bit offset at `at` leads to; empty for 0. */
mt_bytes mt_math_follow(mt_math_reader *reader, mt_bytes table, size_t at);
/* How many records of `size` bytes there are from `first` on: what the 16 bits at `at` say, if it is not over `most`. None
 * in an empty table. */
int mt_math_count(mt_math_reader *reader, mt_bytes table, size_t at, size_t first, size_t size, int most);
/* The MathValueRecord at `at`, with what the font's place on its axes adds. */
double mt_math_read_value(mt_math_reader *reader, mt_bytes table, size_t at);
/* A glyph's number; one that the font has not is damage. */
uint16_t mt_math_read_glyph(mt_math_reader *reader, mt_bytes table, size_t at);
/* The glyphs of the Coverage table that the offset at `at` leads to, of those that the font has. MT_NO_MEMORY. */
mt_status mt_math_covered(mt_math_reader *reader, mt_bytes table, size_t at, mt_covered **list, int *count);

/* kerns.c, constructions.c: the MathKernInfo table; the MathVariants table. MT_NO_MEMORY. */
mt_status mt_math_read_kerns(mt_math_reader *reader, mt_bytes info, mt_math_kerns *kerns);
mt_status mt_math_read_variants(mt_math_reader *reader, mt_bytes table, mt_math_table *math);
