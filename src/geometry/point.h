/* Points on the integer grid (limits.h: MT_EM grid units an em, |x| and |y| up to MT_COORD_MAX) and the two
 * exact predicates that all of geometry rests on. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

typedef struct mt_point {
    int32_t x, y;
} mt_point;

/* A difference of places, not rounded to the grid. */
typedef struct mt_vector {
    double x, y;
} mt_vector;

/* A place between two drawings: T may be another one upwards than across, since points move on straight lines. */
typedef struct mt_at {
    double x, y; /* T of what lies across: x, advances, widths; and of what lies up: y, heights */
} mt_at;

/* The same T in both directions. */
static inline mt_at mt_at_both(double t) {
    mt_at at = {t, t};
    return at;
}

static inline bool mt_at_equal(mt_at p, mt_at q) {
    return p.x == q.x && p.y == q.y;
}

/* From p to q, so far: 0 … 1. */
static inline mt_at mt_at_between(mt_at p, mt_at q, double share) {
    mt_at at = {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)};
    return at;
}

typedef struct mt_box {
    mt_point min, max; /* both inclusive */
} mt_box;

__extension__ typedef __int128 mt_wide;

static inline bool mt_point_equal(mt_point a, mt_point b) {
    return a.x == b.x && a.y == b.y;
}

/* z of (b - a) × (d - c). */
static inline int64_t mt_cross(mt_point a, mt_point b, mt_point c, mt_point d) {
    return ((int64_t)b.x - a.x) * ((int64_t)d.y - c.y) - ((int64_t)b.y - a.y) * ((int64_t)d.x - c.x);
}

/* (b - a) · (d - c). */
static inline int64_t mt_dot(mt_point a, mt_point b, mt_point c, mt_point d) {
    return ((int64_t)b.x - a.x) * ((int64_t)d.x - c.x) + ((int64_t)b.y - a.y) * ((int64_t)d.y - c.y);
}

/* Twice the signed area of the triangle: > 0 when a, b, c turn left, 0 when they are in line. Exact. */
static inline int64_t mt_orient(mt_point a, mt_point b, mt_point c) {
    return mt_cross(a, b, a, c);
}

/* The sign of the in-circle determinant: > 0 when d is inside the circle through a, b, c (anticlockwise).
 * Exact for differences up to 2^28, 32 times
 * MT_COORD_MAX. */
int mt_in_circle(mt_point a, mt_point b, mt_point c, mt_point d);

/* Squared distance. */
static inline int64_t mt_distance2(mt_point a, mt_point b) {
    return mt_dot(a, b, a, b);
}
