/* Lengths and angles of vectors, to the same last bit on every machine: C libraries differ in theirs, and with it a point of a glyph here
 * and there. All code of src takes these in place of the C library's. Angles are in radians; what is no number comes back as none. */
#pragma once

#include <math.h>

/* At most 4e-16 of the result from the exact value, for angles up to 1000 either way; one beyond MT_ANGLE_MOST is taken modulo a double's
 * 2π. mt_sin(-x) is -mt_sin(x), but for the sign of zero; mt_cos(-x) is mt_cos(x). */
#define MT_ANGLE_MOST 1e6
double mt_sin(double angle);
double mt_cos(double angle);
/* At most 8e-16 of the result. */
double mt_tan(double angle);

/* -π … π, at most 4e-16 of the result from the exact value; C's rules for zeros and their signs. Exact, as far as doubles hold multiples
 * of π, for vectors along an axis or between two; alike, but for the sign, for vectors that mirror each other in the line of x. */
double mt_atan2(double y, double x);

/* The length of a vector one of whose squares is no normal double. */
double mt_hypot_scaled(double x, double y);

/* The length of a vector, at most 4e-16 of it from the exact value. */
static inline double mt_hypot(double x, double y) {
    double square = x * x + y * y;
    return square >= 1e-290 && square <= 1e290 ? sqrt(square) : mt_hypot_scaled(x, y);
}
