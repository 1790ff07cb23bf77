/* The sum of two pieces as one mesh for all r. */
#pragma once

#include "solid/piece.h"

/* Points and triangles: point i is at r · (x's point of_x[i]) + (1 - r) · (y's point of_y[i]). */
typedef struct mt_sum {
    int n_points, n_triangles;
    int *of_x, *of_y;
    mt_triangle *triangles;
} mt_sum;

/* Both are convex: the boundary of r x ⊕ (1 - r) y, exactly. Otherwise the boundary of the sum of both hulls, with what x's and y's
 * surfaces have under each facet in that facet's place: at r = 1 it is x's surface, at r = 0 y's, and the dents of both stay. Closed and
 * oriented for every r. MT_BAD_GEOMETRY, MT_NO_MEMORY. */
mt_status mt_sum_of(mt_arena *arena, const mt_piece *x, const mt_piece *y, mt_sum *sum);
