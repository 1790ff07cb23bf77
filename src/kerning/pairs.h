/* Pair adjustment of fonts in one structure: what each has for each pair of new glyphs.
 *
 * On each side, a class of new glyphs is a class of each font's glyphs: those that the font's matrices do not tell
 * apart. Pairs that any font gives one by one, and that differ from the classes' value, are listed. */
#pragma once

#include "glyphset/places.h"
#include "kerning/source.h"

/* One font's values for its own classes; row 0 and column 0 are of glyphs of which it says nothing. */
typedef struct mt_pair_matrix {
    int rows, columns;
    double *values; /* rows × columns × part_count */
} mt_pair_matrix;

enum { MT_NO_CLASS = -1 }; /* of a glyph that a font has not: its pairs are the first font's */

/* Classes of new glyphs, as left or as right glyphs; number 0 is class 0 of every font. */
typedef struct mt_pair_classes {
    int count;
    int *in_fonts; /* each font's own class, for each class in turn */
    uint16_t *of;  /* the class of each new glyph */
} mt_pair_classes;

typedef struct mt_listed_pair {
    uint16_t left, right;
} mt_listed_pair;

typedef struct mt_pairs {
    int font_count, glyph_count;
    int part_count;
    uint8_t parts[MT_PAIR_PARTS]; /* which of a pair's parts the values are of, ascending */
    mt_pair_matrix *fonts;        /* what each has */
    mt_pair_classes left, right;
    int listed_count;
    mt_listed_pair *listed; /* ascending */
    double *listed_values;  /* of each font in turn, part_count each, for each pair in turn */
} mt_pairs;

/* The most that pairs may come to: cells of a matrix, and pairs listed; and what all of the fonts' pairs may cost, in steps
 * (a glyph looked up in a subtable, a pair read). A malformed font can ask for any number; the largest fonts take a
 * tenth. */
enum { MT_PAIR_CELLS_MAX = 1 << 22, MT_PAIRS_LISTED_MAX = 1 << 20, MT_PAIR_STEPS_MAX = 1 << 26 };
