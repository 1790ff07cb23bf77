/* How far a variable font has got where users set its axis: on straight lines between points ('avar', segment maps). */
#pragma once

#include "morphotype.h"

/* From 0 to MT_AXIS_END (axis.h) both. */
typedef struct mt_map_point {
    double value; /* what users set */
    double place; /* how far the font has got there; 100 is the last of its sources */
} mt_map_point;

/* Values ascend, and stay apart when rounded to places of the tables (axis_data.h); places do not descend. The first point is
 * 0, 0 and the last MT_AXIS_END, MT_AXIS_END. */
typedef struct mt_axis_map {
    int count; /* 0: each value is its place */
    mt_map_point *points;
} mt_axis_map;

/* What mt_variable_set_map takes; the points are for mt_axis_map_free. MT_BAD_PARAMETER, MT_NO_MEMORY. */
mt_status mt_axis_map_make(const double *values, const double *places, int count, mt_axis_map *map);
void mt_axis_map_free(mt_axis_map *map);

/* Of a value from 0 to MT_AXIS_END. */
double mt_axis_map_place(const mt_axis_map *map, double value);
/* What to set for a place of the tables. It leads to that place or, where only values between two
 * places of the axis would, to just under it, also for who does not round (FreeType up to 2.12): past the place of a font in
 * between, contours collapse. */
double mt_axis_map_value(const mt_axis_map *map, int place);
