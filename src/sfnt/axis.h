/* The axis of Morphotype's variable fonts: from the first font, where they stand without a setting, to the last. */
#pragma once

#include <math.h>

#include "sfnt/sfnt.h"

/* A place on the axis as the tables have it (F2Dot14): 0 is where the font stands without a setting, MT_PLACE_ONE the end. */
enum { MT_PLACE_ONE = 1 << 14 };

#define MT_AXIS_TAG MT_TAG('M', 'R', 'P', 'H')
#define MT_AXIS_TAG_TEXT "MRPH"
#define MT_AXIS_NAME "Morph"

enum { MT_AXIS_END = 100 };

/* What users set for a place, where nothing is mapped (axis_map.h). */
static inline double mt_axis_value(int place) {
    return (double)MT_AXIS_END * place / MT_PLACE_ONE;
}

/* The place that is nearest to a value from -MT_AXIS_END to MT_AXIS_END. */
static inline int mt_axis_place(double value) {
    return (int)floor(value / MT_AXIS_END * MT_PLACE_ONE + 0.5);
}
