/* The weighted Minkowski sum of two convex pieces: rA ⊕ (1 - r)B, section 2.3 of the paper. */
#pragma once

#include "geometry/ring.h"

/* The paper's r and 1 - r as integers that add up to MT_WEIGHT_ONE, so that sums are exact before they are
 * rounded. */
#define MT_WEIGHT_ONE (1 << 20)
typedef struct mt_weights {
    int32_t a, b;
    int32_t up; /* y has so much more of b, and so much less of a, than x has */
} mt_weights;

/* Weights for T = t, -1 … 2: a = 1 - t, b = t, to the nearest 2^-20; sums want 0 … 1, in both directions. */
mt_weights mt_weights_at(double t);
mt_weights mt_weights_of(mt_at at);

/* (a·p + b·q) / MT_WEIGHT_ONE, to the nearest grid point, halves up. Gives p back when p and q are equal. */
mt_point mt_mix(mt_weights weights, mt_point p, mt_point q);

/* The sum of two convex pieces by merging their edges in order of angle, O(n + m), into `sum`, which has room
 * for p->count + q->count points and marks; sets sum->count. Corners are rounded to the grid; equal
 * neighbours fall together. */
void mt_minkowski(const mt_ring *p, const mt_ring *q, mt_weights weights, mt_ring *sum);

/* A corner of the sum, the same for all 0 < r < 1: a vertex of p and one of q. */
typedef struct mt_corner {
    int p, q;
} mt_corner;

/* All of them where both directions have one r, anticlockwise, into room for p->count + q->count; returns their number. From one to the next the vertex of p advances by
 * one, or that of q, or both. */
int mt_minkowski_corners(const mt_ring *p, const mt_ring *q, mt_corner *corners);
