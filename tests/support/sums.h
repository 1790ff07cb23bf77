/* Oracles for Minkowski sums that know nothing of convex pieces or of merging edges. */
#pragma once

#include "geometry/minkowski.h"
#include "support/oracle.h"

/* The convex hull of all weighted vertex sums a·p + b·q, by gift wrapping, exact, in units of 1 /
 * MT_WEIGHT_ONE. `hull` has room for p->count × q->count. Returns how many. */
int mt_sums_hull(const mt_ring *p, const mt_ring *q, mt_weights weights, mt_spot *hull);

/* How far a grid point lies from the exact sum aA ⊕ bB of two shapes, grid units; 0 inside. A point x lies
 * in the sum when aA and x - bB have a point in common: two edges meet, or a corner of one lies in the
 * other. Exact when it is 0. */
double mt_sums_distance(const mt_shape *a, const mt_shape *b, mt_weights weights, mt_point x);
