/* Angles by sums, products, quotients and square roots alone, which IEEE 754 rounds alike everywhere; the compiler is told not to fuse
 * them. */
#include "arithmetic/angles.h"

#include <stdint.h>
#include <string.h>

/* ---- sine and cosine --------------------------------------------------------------------------------------- */

/* An angle less the nearest whole number of quarter turns, and that number modulo 4. */
typedef struct mt_reduced {
    double rest; /* -π/4 … π/4 */
    unsigned quarters;
} mt_reduced;

/* Half of π in three parts. The first two have 33 bits each, so that their multiples by 20 bits are exact. */
#define HALF_PI_1 0x1.921fb544p0
#define HALF_PI_2 0x1.0b4611a6p-34
#define HALF_PI_3 0x1.3198a2e037073p-69
/* A sum with it is a whole number, whose last bits are the double's. */
#define WHOLE 0x1.8p52

static mt_reduced reduced(double angle) {
    if (!(fabs(angle) <= MT_ANGLE_MOST)) angle = fmod(angle, 2 * M_PI);
    double sum = angle * M_2_PI + WHOLE, quarters = sum - WHOLE;
    uint64_t bits;
    memcpy(&bits, &sum, sizeof bits);
    return (mt_reduced){angle - quarters * HALF_PI_1 - quarters * HALF_PI_2 - quarters * HALF_PI_3, bits & 3};
}

/* The value of a polynomial at s, by Horner's rule; the factors begin with that of the highest power. */
static inline double polynomial(const double *factors, int count, double s) {
    double sum = factors[0];
    for (int i = 1; i < count; i++) sum = factors[i] + s * sum;
    return sum;
}

#define POLYNOMIAL(factors, s) polynomial(factors, sizeof(factors) / sizeof *(factors), s)

/* Taylor's series at 0, for |x| up to π/4; what is left out is less than 1e-19 of the result. */
static double near_sine(double x) {
    static const double factors[] = {1 / 355687428096e3, -1 / 1307674368e3, 1 / 6227020800., -1 / 39916800.,
                                     1 / 362880.,        -1 / 5040.,        1 / 120.,        -1 / 6.};
    double s = x * x;
    return x + x * s * POLYNOMIAL(factors, s);
}

/* The same, less than 4e-18. */
static double near_cosine(double x) {
    static const double factors[] = {1 / 20922789888e3, -1 / 87178291200., 1 / 479001600., -1 / 3628800.,
                                     1 / 40320.,        -1 / 720.,         1 / 24.};
    double s = x * x;
    return 1 - (s / 2 - s * s * POLYNOMIAL(factors, s));
}

/* The sine of an angle, `ahead` quarter turns further. */
static double sine(mt_reduced angle, unsigned ahead) {
    unsigned quarters = angle.quarters + ahead;
    double size = quarters & 1 ? near_cosine(angle.rest) : near_sine(angle.rest);
    return quarters & 2 ? -size : size;
}

double mt_sin(double angle) {
    return sine(reduced(angle), 0);
}

double mt_cos(double angle) {
    return sine(reduced(angle), 1);
}

double mt_tan(double angle) {
    mt_reduced at = reduced(angle);
    return sine(at, 0) / sine(at, 1);
}

/* ---- vectors ------------------------------------------------------------------------------------------------ */

/* The angle of (x, y) with 0 ≤ y ≤ x: that of the nearest sixteenth, and by a series the angle from there, of at most 1/32. */
static double arc(double y, double x) {
    static const double of_sixteenths[] = {
        0x0p0,
        0x1.ff55bb72cfdeap-5,
        0x1.fd5ba9aac2f6ep-4,
        0x1.7b97b4bce5b02p-3,
        0x1.f5b75f92c80ddp-3,
        0x1.362773707ebccp-2,
        0x1.6f61941e4def1p-2,
        0x1.a64eec3cc23fdp-2,
        0x1.dac670561bb4fp-2,
        0x1.0657e94db30d0p-1,
        0x1.1e00babdefeb4p-1,
        0x1.345f01cce37bbp-1,
        0x1.4978fa3269ee1p-1,
        0x1.5d58987169b18p-1,
        0x1.700a7c5784634p-1,
        0x1.819d0b7158a4dp-1,
        M_PI_4,
    };
    static const double factors[] = {1 / 11., -1 / 9., 1 / 7., -1 / 5., 1 / 3.};
    double ratio = 16 * (y / x);
    int near = ratio >= 0 ? (int)(ratio + 0.5) : 0; /* 0 for what is no number */
    double rest = (16 * y - near * x) / (16 * x + near * y), s = rest * rest;
    return of_sixteenths[near] + (rest - rest * s * POLYNOMIAL(factors, s));
}

double mt_atan2(double y, double x) {
    double across = fabs(y), along = fabs(x);
    if (across == 0 && along == 0) along = 1;
    double angle = across <= along ? arc(across, along) : M_PI_2 - arc(along, across);
    return copysign(signbit(x) ? M_PI - angle : angle, y);
}

double mt_hypot_scaled(double x, double y) {
    double most = fmax(fabs(x), fabs(y)), scale = most > 1 ? 0x1p-600 : 0x1p600;
    x *= scale;
    y *= scale;
    return sqrt(x * x + y * y) / scale;
}
