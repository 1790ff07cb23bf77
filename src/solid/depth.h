/* How far a part is from convex. */
#pragma once

#include "solid/cells.h"
#include "space/hull.h"

/* A place of the hull far from the part. */
typedef struct mt_depth {
    double distance;   /* grid units */
    mt_vector3 place;  /* on the hull */
    mt_vector3 normal; /* the hull's there */
} mt_depth;

/* Finds a place of the hull that is farther than `limit` from the part, or as far a place as it comes by when there is none: all of the
 * hull is then within the limit. From the hull to the part, not from the part to the hull: a hollow with thin walls is near its hull
 * everywhere. MT_NO_MEMORY. */
mt_status mt_part_depth(mt_arena *arena, const mt_part *part, const mt_polytope *hull, double limit,
                        mt_depth *depth);

/* Whether a part is convex but for the rounding to the grid: each neighbour of a triangle lies below its plane, or no more than two grid
 * units above. */
bool mt_part_is_convex(const mt_cells *cells, const mt_part *part);

/* By how many grid units the triangle over edge `e` rises over the plane of that at `e`; the edge is reflex when it is over 0. 0 also
 * where the plane of a triangle is rounding only. */
double mt_part_rise(const mt_cells *cells, const mt_part *part, int e);

/* What rounding to the grid may make of a rise, grid units. */
#define MT_RISE_ROUNDED 2.0
