/* MATH in writing: what the files that write it share. */
#pragma once

#include "layout/value_write.h"
#include "math/math_data.h"
#include "sfnt/table.h"

typedef struct mt_math_writer {
    const mt_math *math;
    mt_places places;
    bool first_only; /* without the values that the first font has not */
    mt_arena *scratch;
} mt_math_writer;

/* What a value is of: a new glyph, or MT_MATH_FONT; and in which direction it measures. */
typedef struct mt_math_of {
    int glyph;
    mt_direction direction;
} mt_math_of;

enum { MT_MATH_FONT = -1 };

/* A row at the first place, not rounded. */
double mt_math_at_first(const mt_math_writer *writer, mt_math_of of, const double *row);
/* A MathValueRecord. The pool starts `to_pool` bytes from the start of the table that has the record. */
void mt_math_write_value(const mt_math_writer *writer, mt_math_of of, const double *row,
                         mt_variation_pool *pool, size_t to_pool, mt_table *table);

/* A table of a known head, and behind it what 16-bit offsets in the head lead to. */
typedef struct mt_math_nest {
    mt_table *head; /* what was written to it is the head so far */
    size_t head_length;
    mt_table inner;
    bool too_far; /* an offset would not do */
} mt_math_nest;

/* The table is to have `head_length` more bytes, and then what comes into the nest. */
mt_math_nest mt_math_nest_begin(mt_table *table, size_t head_length);
/* Writes the offset of what is put into nest.inner next. */
void mt_math_nest_offset(mt_math_nest *nest);
/* Moves what is in the nest into the table, and frees it. MT_TOO_LARGE where an offset would not do. */
mt_status mt_math_nest_end(mt_math_nest *nest);

/* write_info.c, write_growths.c: the MathGlyphInfo table; the MathVariants table. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_math_write_info(const mt_math_writer *writer, mt_table *table);
mt_status mt_math_write_growths(const mt_math_writer *writer, mt_table *table);
