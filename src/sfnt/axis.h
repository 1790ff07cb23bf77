/* The axis of Morphotype's variable fonts: from the first font to the last. Without a setting they stand at the first or, as
 * families do, at any other. */
#pragma once

#include <math.h>

#include "sfnt/sfnt.h"

/* A place on the axis as the tables have it (F2Dot14): 0 is where the font stands without a setting, MT_PLACE_ONE the end, and
 * -MT_PLACE_ONE the start where that is another. */
enum { MT_PLACE_ONE = 1 << 14 };

/* How far along the axis the last font is, the first being at 0: what maps count in (axis_map.h). */
enum { MT_AXIS_END = 100 };

/* The axis as users know it: what they set for the first font and for the last, which may be less. */
typedef struct mt_axis {
    uint32_t tag;
    double from, to;
    double
        home; /* where the font stands without a setting: `from`, or any value up to `to` where that is more */
} mt_axis;

/* The axis of a font that has no other: the registered one for morphs. */
#define MT_AXIS_DEFAULT ((mt_axis){MT_TAG('M', 'O', 'R', 'F'), 0, MT_AXIS_END, 0})

/* Then the tables have its places from 0 to -MT_PLACE_ONE. */
static inline bool mt_axis_goes_down(const mt_axis *axis) {
    return axis->to < axis->from;
}

/* What users set for a value from 0 to MT_AXIS_END. */
static inline double mt_axis_user(const mt_axis *axis, double value) {
    if (value >= MT_AXIS_END) return axis->to;
    return axis->from + value * ((axis->to - axis->from) / MT_AXIS_END);
}

/* How far along the axis that is: the other way round. */
static inline double mt_axis_along(const mt_axis *axis, double user) {
    return axis->to == user ? MT_AXIS_END : (user - axis->from) / (axis->to - axis->from) * MT_AXIS_END;
}

/* How far along the axis a place is, from 0 to MT_AXIS_END, where the font stands at the first without a setting and nothing is
 * mapped (axis_map.h). */
static inline double mt_axis_value(int place) {
    return (double)MT_AXIS_END * place / MT_PLACE_ONE;
}

/* The same where it may stand at another. */
static inline double mt_axis_value_of(const mt_axis *axis, int place) {
    double home = mt_axis_along(axis, axis->home), value = mt_axis_value(place);
    return home + value * ((place < 0 ? home : MT_AXIS_END - home) / MT_AXIS_END);
}

/* The place that is nearest to a value from -MT_AXIS_END to MT_AXIS_END. */
static inline int mt_axis_place(double value) {
    return (int)floor(value / MT_AXIS_END * MT_PLACE_ONE + 0.5);
}
