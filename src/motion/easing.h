/* Easing: how far a motion has got when a share of its time has passed. Curves from (0, 0) to (1, 1) as in CSS (W3C, "CSS Easing
 * Functions Level 1", 2.3): a cubic Bézier whose x is time and whose y is progress. */
#pragma once

#include <stdbool.h>

typedef struct mt_easing {
    double x1, y1, x2, y2; /* the control points; x from 0 to 1, y from MT_EASING_LOW to MT_EASING_HIGH */
} mt_easing;

/* The progress that a control point may have: over 1 or under 0 the motion overshoots. */
#define MT_EASING_LOW (-2.0)
#define MT_EASING_HIGH 3.0

/* linear, ease, ease-in, ease-out, ease-in-out; false for another name. */
bool mt_easing_named(const char *name, mt_easing *easing);
bool mt_easing_is_valid(const mt_easing *easing);

/* The progress after the share `time`, 0 … 1, exact at both ends. */
double mt_easing_at(const mt_easing *easing, double time);

/* The way back: as the motion would be seen from its end. */
mt_easing mt_easing_reversed(mt_easing easing);

bool mt_easing_is_linear(const mt_easing *easing);

/* A part of the motion by itself. */
typedef struct mt_easing_part {
    double start, end; /* its share of the time */
    mt_easing easing;  /* within the part */
} mt_easing_part;

/* The part from progress `from` to `to`, 0 ≤ from < to ≤ 1: a part of a Bézier curve is one. False where the progress turns back, or
 * where the part's control points leave the square from (0, 0) to (1, 1). */
bool mt_easing_cut(const mt_easing *easing, double from, double to, mt_easing_part *part);
