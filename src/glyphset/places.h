/* Where on the way through the fonts positions are written for. The fonts lie at 0, 1, 2, …; what a value is between
 * two of them is mixed of both.
 *
 * A static font is written for one place, which may be another one upwards than across, and where glyphs may have places of their own. A varying one is written for all fonts, in the order of stops (stops.h): the first gives
 * its default values, and the others what a variation store adds to them. */
#pragma once

#include "geometry/point.h"
#include "glyphset/charset.h"
#include "sfnt/var_store.h"

typedef struct mt_places {
    int font_count;
    int count;
    const mt_at *at;
    const mt_at *glyphs; /* where there is one place: of each new glyph, its own; NULL: all are at that */
    mt_var_store *store; /* takes what varies; NULL where there is one place */
} mt_places;

/* Where a static font is, and its glyphs, as in mt_places. */
typedef struct mt_font_at {
    mt_at at;
    const mt_at *glyphs;
} mt_font_at;

/* The same place in both directions, and for all glyphs. */
static inline mt_font_at mt_font_at_t(double t) {
    return (mt_font_at){mt_at_both(t), NULL};
}

/* All fonts of the store, with room for their places in `at`. */
mt_places mt_places_of_fonts(mt_at at[MT_STOPS_MAX], mt_var_store *store);

/* Of a static font; it refers to `at`. */
mt_places mt_places_of_one(const mt_font_at *at, int font_count);

/* The two fonts that a place lies between: `first` and the one after it, so far from the first (0 … 1); past the first or the last font
 * those that are nearest, and so far before or past them. */
typedef struct mt_between {
    int first;
    double t;
} mt_between;

typedef enum mt_direction { MT_ACROSS, MT_UP } mt_direction;

mt_between mt_between_at(const mt_places *places, int i, mt_direction direction);
/* The same of a new glyph, and of two that stand side by side, which are between their own places. */
mt_between mt_between_at_glyph(const mt_places *places, int i, int glyph, mt_direction direction);
mt_between mt_between_at_pair(const mt_places *places, mt_at left, mt_at right, mt_direction direction);

/* Of a part of a value record (layout/value.h): placements and advances across and upwards take turns. */
static inline mt_direction mt_value_direction(int part) {
    return part % 2 ? MT_UP : MT_ACROSS;
}

static inline double mt_between_mix(mt_between between, double first, double second) {
    return (1 - between.t) * first + between.t * second;
}
