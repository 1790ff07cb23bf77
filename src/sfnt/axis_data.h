/* How a font in writing varies along its one axis, as plain data. */
#pragma once

#include <stdint.h>

#include "sfnt/axis.h"
#include "sfnt/axis_map.h"

/* Names in 'name' behind those of the places and their PostScript names: of the axis for slope and of the font's value on it, and
 * then, of an italic font, the places' parts. */
enum { MT_SLOPE_NAMES = 2 };

/* A point in whole font units. */
typedef struct mt_font_point {
    int16_t x, y;
} mt_font_point;

/* Where a glyph's points are at some places; in between each moves on a straight line, as to the place 0, where it is as
 * the font stands. The points are those of its contours or, of a composite, the offsets of its references, and behind
 * them the four phantom points: left, right, top and bottom of the glyph's room in the line ('gvar'). */
typedef struct mt_glyph_path {
    int place_count; /* 0: the glyph stays as it is */
    const int
        *places; /* ascending, without 0; the first and the last are the axis' ends, or neighbours of 0 */
    mt_font_point *const *at; /* for each place, all points: at most 2^15 from where they are at 0 */
} mt_glyph_path;

enum { MT_PHANTOM_POINTS = 4 };

typedef struct mt_named_place {
    double value; /* on the axis, as users set it */
    const char *name;
    bool elided;      /* left out where the names of several axes are joined: Regular */
    double linked;    /* the value of the bold style to this one; the value itself where there is none */
    const char *part; /* of the name, what is of this axis; the name itself where it has no other part */
} mt_named_place;

/* Whether the font is the upright one or the italic one of a family that has each as a file: what 'STAT' says besides. */
typedef enum mt_slope { MT_SLOPE_UNTOLD, MT_SLOPE_UPRIGHT, MT_SLOPE_ITALIC } mt_slope;

typedef struct mt_axis_data {
    mt_axis axis;
    const char *name; /* UTF-8, as are those of the places */
    int named_count;
    const mt_named_place *named; /* ascending */
    const mt_glyph_path *paths;  /* one a glyph */
    mt_axis_map map;
    mt_slope slope;
} mt_axis_data;

/* The number of the first of the names for slope. */
static inline int mt_name_slope(const mt_axis_data *variation) {
    return MT_NAME_PLACES + 2 * variation->named_count;
}
