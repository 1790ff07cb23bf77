/* Convex hulls of points in space, by Qhull. */
#pragma once

#include "base/memory.h"
#include "morphotype.h"

/* A flat side of a hull. Its corners are points by number, anticlockwise as seen from outside. */
typedef struct mt_hull_facet {
    int n_corners;
    int *corners;
    mt_vector3 normal; /* outward, of length 1 */
    double offset;     /* normal · p of its points */
} mt_hull_facet;

typedef struct mt_polytope {
    int n_facets, n_corners; /* n_corners: of all facets together */
    mt_hull_facet *facets;   /* no two coplanar */
    double volume;
} mt_polytope;

/* The hull of n points. Qhull decides in floating point: what it takes to be in a plane may leave it by the rounding of the points'
 * coordinates. Whatever it gives is checked to be closed. Qhull allocates by malloc, and all of that is given back here.
 * MT_BAD_GEOMETRY when the points lie in a plane, MT_NO_MEMORY. */
mt_status mt_polytope_around(mt_arena *arena, const mt_vector3 *points, int n, mt_polytope *hull);

/* The volume of the hull; 0 for points in a plane. MT_NO_MEMORY. */
mt_status mt_hull_volume(const mt_vector3 *points, int n, double *volume);
