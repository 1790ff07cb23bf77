/* Value records of GPOS (OpenType spec, "GPOS": Value record): how far a glyph is moved, and its advance changed. */
#pragma once

#include "layout/gdef_deltas.h"
#include "sfnt/sfnt.h"

/* XPlacement, YPlacement, XAdvance, YAdvance: the order of the bits of a value format. */
enum { MT_VALUE_PARTS = 4, MT_VALUE_X_ADVANCE = 2 };

/* Bytes of a record of that format. */
size_t mt_value_size(unsigned format);

/* The record at `at`, with what the font's place on its axes adds; `parent` is what its device offsets count from.
 * What the format has not is 0. */
void mt_value_read(mt_bytes parent, size_t at, unsigned format, const mt_gdef_deltas *variations,
                   double values[MT_VALUE_PARTS]);

/* The parts that a format has, a bit each: from a plain value or from a device table. */
unsigned mt_value_parts(unsigned format);

/* A number of font units rounded to the nearest one that a table holds, halves upwards. */
int mt_value_rounded(double value);
