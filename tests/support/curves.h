/* Outlines of Béziers, evaluated point by point. */
#pragma once

#include "geometry/outline.h"
#include "support/random.h"

typedef struct mt_place2 {
    double x, y;
} mt_place2;

/* The point of segment i of a closed contour at t, 0 … 1, by de Casteljau. */
mt_place2 mt_curves_at(const mt_contour *contour, int i, double t);

/* From a point to the nearest of an outline's curves, each taken as MT_CURVES_STEPS chords. With control
 * points within one em the chords are less than a twentieth of a grid unit from the curve. */
#define MT_CURVES_STEPS 1024
double mt_curves_distance(const mt_outline *outline, double x, double y);

/* A contour of lines, quadratics and cubics around the origin, some of its joins smooth; control points
 * within `extent`. */
mt_contour mt_random_contour(mt_random *random, mt_arena *arena, int count, int extent);

/* An outline of one contour. */
mt_outline mt_curves_outline(mt_arena *arena, const mt_contour *contour);
