/* Slow and plain answers to the questions that the geometry answers fast. Nothing here calls the code
 * under test. */
#pragma once

#include "geometry/ring.h"

/* A point whose unit is a fraction of the grid's: 1/2 for pixel centres, 1/3 for barycentres of triangles,
 * 2^-20 for weighted sums. Up to 2^47. */
typedef struct mt_spot {
    int64_t x, y;
} mt_spot;

mt_spot mt_spot_of(mt_point point, int64_t scale);

/* Twice the signed area of a b c in the spots' unit, exact. */
mt_wide mt_oracle_orient(mt_spot a, mt_spot b, mt_spot c);

/* Twice the signed area by the shoelace sum in 128 bits. */
mt_wide mt_oracle_area2(const mt_rings *rings);
mt_wide mt_oracle_shape_area2(const mt_shape *shape);

/* The in-circle determinant's sign by cofactors of the lifted points. */
int mt_oracle_in_circle(mt_point a, mt_point b, mt_point c, mt_point d);

/* Every vertex to the left of or on every edge's line, with area, turning around once: O(n²). */
bool mt_oracle_is_convex(const mt_ring *ring);

/* The strict turns to the right. */
int mt_oracle_reflex_count(const mt_component *component);

/* No two edges have a point in common but neighbours their shared end, repeated points counting as one:
 * O(n²). */
bool mt_oracle_is_clean(const mt_component *component);

/* No two edges cross at a point inside both: O(n²). */
bool mt_oracle_is_crossing_free(const mt_component *component);

/* Whether two open segments meet in exactly one point inside both. */
bool mt_oracle_cross(mt_spot a, mt_spot b, mt_spot c, mt_spot d);
/* Whether two closed segments have a point in common. */
bool mt_oracle_meet(mt_spot a, mt_spot b, mt_spot c, mt_spot d);

/* How often the rings, at `scale`, turn around the spot: 0 outside, 1 in the ink of a component. A spot on
 * an edge counts as on the edge's left or right by a fixed rule. */
int mt_oracle_winding(const mt_rings *rings, int64_t scale, mt_spot spot);
bool mt_oracle_in_shape(const mt_shape *shape, int64_t scale, mt_spot spot);

/* Distances to the nearest edge, in grid units; infinite without edges. */
double mt_oracle_distance(const mt_rings *rings, int64_t scale, mt_spot spot);
double mt_oracle_shape_distance(const mt_shape *shape, int64_t scale, mt_spot spot);
double mt_oracle_segment_distance(double x, double y, double ax, double ay, double bx, double by);

/* The convex hull by gift wrapping, anticlockwise, no points in line; `hull` has room for n. Returns how
 * many. */
int mt_oracle_hull(const mt_spot *spots, int n, mt_spot *hull);

/* Grid units, all rings. */
double mt_oracle_length(const mt_rings *rings);
double mt_oracle_shape_length(const mt_shape *shape);
