/* Arithmetic of vectors in space, for measures: what decides is in place.h. */
#pragma once

#include "morphotype.h"

#include <math.h>

static inline mt_vector3 mt_minus3(mt_vector3 p, mt_vector3 q) {
    return (mt_vector3){p.x - q.x, p.y - q.y, p.z - q.z};
}

static inline mt_vector3 mt_plus3(mt_vector3 p, mt_vector3 q) {
    return (mt_vector3){p.x + q.x, p.y + q.y, p.z + q.z};
}

static inline mt_vector3 mt_times3(double s, mt_vector3 p) {
    return (mt_vector3){s * p.x, s * p.y, s * p.z};
}

static inline double mt_dot3(mt_vector3 p, mt_vector3 q) {
    return p.x * q.x + p.y * q.y + p.z * q.z;
}

static inline mt_vector3 mt_cross3(mt_vector3 p, mt_vector3 q) {
    return (mt_vector3){p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

static inline double mt_length3(mt_vector3 p) {
    return sqrt(mt_dot3(p, p));
}

/* p + s (q - p). */
static inline mt_vector3 mt_between3(mt_vector3 p, mt_vector3 q, double s) {
    return mt_plus3(p, mt_times3(s, mt_minus3(q, p)));
}
