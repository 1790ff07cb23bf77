/* Lines that a fit leaves in pieces, or takes for lines wrongly. In both masters alike:
 *
 *     ●──●────●────●   ──▶  ●────────────●     nodes within the tolerance of one line are dropped, and segments without length
 *     ╭─●─●─╮          ──▶  ╭─●~●─╮            a line shorter than CURVE_LINE_MOST between curves, with a kink at an end in
 *                                              between, becomes a quadratic with its control point in the middle
 * Invariant: both masters keep as many segments, of the same degrees. O(n) for n segments, O(n²) for one line of n. */
#include "morph/fit/lines.h"

#include <math.h>

#include "geometry/limits.h"
#include "morph/fit/smooth.h"

/* A line between two smooth nodes that is shorter in either master is part of a curve where it has a kink, 1/1000 em. */
#define CURVE_LINE_MOST 10.0

static mt_contour *master(mt_contour_pair *masters, int m) {
    return m == 0 ? &masters->a : &masters->b;
}

/* ---- one line in several segments ------------------------------------------------------------------------ */

/* Whether p lies between a and b, within `tolerance` of the line that joins them. */
static bool is_on_way(mt_point a, mt_point p, mt_point b, double tolerance) {
    if (mt_dot(a, p, p, b) < 0) return false;
    return fabs((double)mt_orient(a, p, b)) <= tolerance * sqrt((double)mt_distance2(a, b));
}

/* Whether segments first … last are one line from node first - 1 on. */
static bool is_one_line(mt_contour_pair *masters, int first, int last, double tolerance) {
    int n = masters->a.count;
    for (int m = 0; m < 2; m++) {
        const mt_segment *s = master(masters, m)->segments;
        mt_point start = s[(first + n - 1) % n].end;
        for (int k = first; k < last; k++)
            if (!is_on_way(start, s[k].end, s[last].end, tolerance)) return false;
    }
    return masters->a.segments[last].degree == 1;
}

/* Whether segments first … last, which are one line, have a length in either master. */
static bool has_length(mt_contour_pair *masters, int first, int last) {
    int n = masters->a.count;
    for (int m = 0; m < 2; m++) {
        const mt_segment *s = master(masters, m)->segments;
        if (!mt_point_equal(s[(first + n - 1) % n].end, s[last].end)) return true;
    }
    return false;
}

static void keep(mt_contour_pair *masters, int *steps, int from, int to) {
    masters->a.segments[to] = masters->a.segments[from];
    masters->b.segments[to] = masters->b.segments[from];
    steps[to] = steps[from];
}

static void join_lines(mt_contour_pair *masters, int *steps, double tolerance) {
    int made = 0, n = masters->a.count;
    for (int first = 0, last; first < n; first = last + 1) {
        bool line = masters->a.segments[first].degree == 1;
        for (last = first; line && last + 1 < n && is_one_line(masters, first, last + 1, tolerance);) last++;
        if (!line || has_length(masters, first, last)) keep(masters, steps, last, made++);
    }
    masters->a.count = masters->b.count = made;
}

/* ---- lines within curves --------------------------------------------------------------------------------- */

static bool is_short(mt_contour_pair *masters, int k) {
    int n = masters->a.count;
    for (int m = 0; m < 2; m++) {
        const mt_segment *s = master(masters, m)->segments;
        double length = sqrt((double)mt_distance2(s[(k + n - 1) % n].end, s[k].end));
        if (length < mt_grid_units(CURVE_LINE_MOST)) return true;
    }
    return false;
}

/* Whether a line has a kink at an end, and a corner at neither. */
static bool is_kinked(mt_contour_pair *masters, int k) {
    const mt_contour *const both[2] = {&masters->a, &masters->b};
    int before = (k + masters->a.count - 1) % masters->a.count;
    for (int m = 0; m < 2; m++)
        if (!mt_is_smooth(both[m], k) || !mt_is_smooth(both[m], before)) return false;
    return fmax(mt_kink(both, k), mt_kink(both, before)) > MT_KINK_TURN;
}

static void bend(mt_contour_pair *masters, int k) {
    int n = masters->a.count;
    for (int m = 0; m < 2; m++) {
        mt_segment *s = master(masters, m)->segments;
        mt_point start = s[(k + n - 1) % n].end, end = s[k].end;
        s[k].degree = 2;
        s[k].control[0] = (mt_point){(start.x + end.x) / 2, (start.y + end.y) / 2};
    }
}

void mt_contour_pair_tidy_lines(mt_contour_pair *masters, int *steps, double tolerance) {
    join_lines(masters, steps, tolerance);
    for (int k = 0; k < masters->a.count; k++)
        if (masters->a.segments[k].degree == 1 && is_short(masters, k) && is_kinked(masters, k))
            bend(masters, k);
}
