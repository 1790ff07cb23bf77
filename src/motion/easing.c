#include "motion/easing.h"

#include <math.h>
#include <string.h>

/* Halvings of an interval from 0 to 1: down to the last bit. */
#define HALVINGS 60

/* The part of a control point outside of its square that is rounding alone. */
#define ROUNDING 1e-9

bool mt_easing_named(const char *name, mt_easing *easing) {
    static const struct {
        const char *name;
        mt_easing easing;
    } known[] = {
        {"linear", {0, 0, 1, 1}},      {"ease", {0.25, 0.1, 0.25, 1}},      {"ease-in", {0.42, 0, 1, 1}},
        {"ease-out", {0, 0, 0.58, 1}}, {"ease-in-out", {0.42, 0, 0.58, 1}},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        if (strcmp(name, known[i].name) != 0) continue;
        *easing = known[i].easing;
        return true;
    }
    return false;
}

static bool within(double value, double low, double high) {
    return value >= low && value <= high; /* false for a NaN */
}

bool mt_easing_is_valid(const mt_easing *e) {
    return within(e->x1, 0, 1) && within(e->x2, 0, 1) && within(e->y1, MT_EASING_LOW, MT_EASING_HIGH) &&
           within(e->y2, MT_EASING_LOW, MT_EASING_HIGH);
}

/* A coordinate of the curve at `s`: the Bézier of 0, p, q and 1. */
static double curve_at(double p, double q, double s) {
    double rest = 1 - s;
    return 3 * rest * rest * s * p + 3 * rest * s * s * q + s * s * s;
}

/* Where a coordinate that never falls has the value. */
static double solve(double p, double q, double value) {
    double low = 0, high = 1;
    if (value <= 0) return 0;
    if (value >= 1) return 1;
    for (int i = 0; i < HALVINGS; i++) {
        double middle = (low + high) / 2;
        if (curve_at(p, q, middle) < value)
            low = middle;
        else
            high = middle;
    }
    return high;
}

bool mt_easing_is_linear(const mt_easing *e) {
    return fabs(e->x1 - e->y1) < ROUNDING && fabs(e->x2 - e->y2) < ROUNDING;
}

double mt_easing_at(const mt_easing *e, double time) {
    if (time <= 0) return 0;
    if (time >= 1) return 1;
    return mt_easing_is_linear(e) ? time : curve_at(e->y1, e->y2, solve(e->x1, e->x2, time));
}

mt_easing mt_easing_reversed(mt_easing e) {
    return (mt_easing){1 - e.x2, 1 - e.y2, 1 - e.x1, 1 - e.y1};
}

/* ---- parts --------------------------------------------------------------------------------------------- */

/* The control points of a coordinate's curve from s to t: its polar form at (s, s, t) and (s, t, t). */
static void cut_coordinate(double p, double q, double s, double t, double control[2]) {
    const double ends[2][3] = {{s, s, t}, {s, t, t}};
    for (int i = 0; i < 2; i++) {
        double a = ends[i][0], b = ends[i][1], c = ends[i][2];
        double one = a * (1 - b) * (1 - c) + b * (1 - a) * (1 - c) + c * (1 - a) * (1 - b);
        double two = a * b * (1 - c) + a * c * (1 - b) + b * c * (1 - a);
        control[i] = one * p + two * q + a * b * c;
    }
}

/* The value as a share of the way from `from` to `to`; what rounding put outside is put back. */
static double share(double value, double from, double to) {
    double s = (value - from) / (to - from);
    if (s < 0 && s > -ROUNDING) return 0;
    return s > 1 && s < 1 + ROUNDING ? 1 : s;
}

static bool in_square(const mt_easing *e) {
    return within(e->x1, 0, 1) && within(e->x2, 0, 1) && within(e->y1, 0, 1) && within(e->y2, 0, 1);
}

bool mt_easing_cut(const mt_easing *e, double from, double to, mt_easing_part *part) {
    double x[2], y[2];
    if (!in_square(e)) return false;
    double s = solve(e->y1, e->y2, from), t = solve(e->y1, e->y2, to);
    mt_easing_part made = {.start = curve_at(e->x1, e->x2, s), .end = curve_at(e->x1, e->x2, t)};
    cut_coordinate(e->x1, e->x2, s, t, x);
    cut_coordinate(e->y1, e->y2, s, t, y);
    made.easing = (mt_easing){share(x[0], made.start, made.end), share(y[0], from, to),
                              share(x[1], made.start, made.end), share(y[1], from, to)};
    if (!in_square(&made.easing)) return false;
    *part = made;
    return true;
}
