/* Where on the way through the fonts positions are written for. The fonts lie at 0, 1, 2, …; what a value is between
 * two of them is mixed of both.
 *
 * A static font is written for one place. A varying one is written for all fonts, in the order of stops (stops.h): the first gives
 * its default values, and the others what a variation store adds to them. */
#pragma once

#include "glyphset/charset.h"
#include "sfnt/var_store.h"

typedef struct mt_places {
    int font_count;
    int count;
    const double *at;
    mt_var_store *store; /* takes what varies; NULL where there is one place */
} mt_places;

/* All fonts of the store, with room for their places in `at`. */
mt_places mt_places_of_fonts(double at[MT_STOPS_MAX], mt_var_store *store);

/* The two fonts that a place lies between: `first` and the one after it, so far from the first (0 … 1); past the first or the last font
 * those that are nearest, and so far before or past them. */
typedef struct mt_between {
    int first;
    double t;
} mt_between;

mt_between mt_between_at(const mt_places *places, int i);

static inline double mt_between_mix(mt_between between, double first, double second) {
    return (1 - between.t) * first + between.t * second;
}
