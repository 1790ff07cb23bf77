/* Where the fonts of a varying font stand on its axis.
 *
 * Fonts are counted in their order on the axis. Stops are the same fonts in the order in which tables have them: the one that the
 * font stands at without a setting first, since tables tell of the others by how far they are from it, then the others in theirs. */
#pragma once

#include "sfnt/axis.h"

enum { MT_STOPS_MAX = 64 };

typedef struct mt_stops {
    int count; /* 2 … MT_STOPS_MAX */
    int home;  /* the font that the font stands at without a setting */
    int at
        [MT_STOPS_MAX]; /* of each font, its place (axis.h): ascending, 0 at `home`; ends at ±MT_PLACE_ONE */
} mt_stops;

/* Evenly from 0, the first, to MT_PLACE_ONE. */
static inline mt_stops mt_stops_even(int count) {
    mt_stops stops = {.count = count};
    int steps = count - 1;
    for (int i = 0; i < count; i++) stops.at[i] = (MT_PLACE_ONE * i + steps / 2) / steps;
    return stops;
}

/* Those of fonts at these values of the axis, which ascend from axis.from to axis.to; one is axis.home. A place is the nearest that is
 * not under the value's own: who does not round (FreeType up to 2.12) is never past it there, where contours collapse. False where two
 * values are at one place. */
bool mt_stops_make(const mt_axis *axis, const double *values, int count, mt_stops *stops);

/* Which font a stop is. */
static inline int mt_stops_font(const mt_stops *stops, int stop) {
    if (stop == 0) return stops->home;
    return stop <= stops->home ? stop - 1 : stop;
}
