/* The fewest quadratics that follow a run of samples, by dynamic programming over the samples: best[j] is the
 * least cost of a spline from the first sample to sample j, where a segment costs 1 and a little for its
 * error.
 *
 * One segment between two samples has no freedom: its control point is where the two tangents meet.
 *
 *            c              the tangents meet ahead of the one and behind the other, and the whole turns
 *          /   \            by less than MAX_TURN: otherwise no single quadratic joins them
 *        a       b
 */
#include "spline.h"

#include <math.h>

#define MAX_TURN 100.0  /* degrees; a quadratic that turns by more is too pointed to follow anything drawn */
#define ERROR_SHARE 0.5 /* what an error as large as the tolerance costs, beside 1 for a segment */
#define STRAIGHT_SHARE 0.1 /* of the tolerance: under it, a stretch is a line */
#define GIVE_UP 16.0 /* tolerances: past this error, longer segments from the same start are not tried */

typedef struct mt_vec {
    double x, y;
} mt_vec;

typedef struct mt_arc {
    bool line;
    mt_vec control;
    double error; /* grid units; INFINITY when no segment joins the two samples */
} mt_arc;

static mt_vec place(const mt_sample *s) {
    return (mt_vec){s->x, s->y};
}

static double cross(double ax, double ay, double bx, double by) {
    return ax * by - ay * bx;
}

/* ---- how far a sample is from a segment
 * --------------------------------------------------------------------- */

static double distance_to_line(mt_vec p, mt_vec a, mt_vec b) {
    double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    double t = length2 > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / length2 : 0;
    t = fmin(1, fmax(0, t));
    return hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/* Newton's method on (q(t) - p)·q'(t) = 0, from a start near enough: the samples come in order along the
 * curve. */
static double distance_to_quadratic(mt_vec p, mt_vec a, mt_vec c, mt_vec b, double *t) {
    mt_vec u = {c.x - a.x, c.y - a.y}, w = {a.x - 2 * c.x + b.x, a.y - 2 * c.y + b.y};
    mt_vec off = {0};
    for (int i = 0; i < 4; i++) {
        mt_vec q = {a.x + *t * (2 * u.x + *t * w.x), a.y + *t * (2 * u.y + *t * w.y)};
        mt_vec d = {2 * (u.x + *t * w.x), 2 * (u.y + *t * w.y)};
        off = (mt_vec){q.x - p.x, q.y - p.y};
        double slope = d.x * d.x + d.y * d.y + 2 * (off.x * w.x + off.y * w.y);
        if (i == 3 || slope <= 0) break;
        *t = fmin(1, fmax(0, *t - (off.x * d.x + off.y * d.y) / slope));
    }
    return hypot(off.x, off.y);
}

static double line_error(const mt_sample *s, int from, int to) {
    double worst = 0;
    for (int k = from + 1; k < to; k++)
        worst = fmax(worst, distance_to_line(place(&s[k]), place(&s[from]), place(&s[to])));
    return worst;
}

static double quadratic_error(const mt_sample *s, int from, int to, mt_vec control, double limit) {
    double worst = 0, t = 0;
    for (int k = from + 1; k < to && worst <= limit; k++) {
        double start = (double)(k - from) / (to - from);
        t = fmax(t, start * 0.5 + t * 0.5);
        worst = fmax(worst, distance_to_quadratic(place(&s[k]), place(&s[from]), control, place(&s[to]), &t));
    }
    return worst;
}

/* ---- one segment
 * --------------------------------------------------------------------------------------------- */

static mt_arc line_arc(const mt_sample *s, int from, int to, double tolerance) {
    double error = line_error(s, from, to);
    bool fits = to == from + 1 || error <= tolerance * STRAIGHT_SHARE;
    return (mt_arc){.line = true, .error = fits ? error : INFINITY};
}

/* How far the tangents at both ends leave the chord: under the straight share, a curve would bulge by nothing
 * visible. */
static bool is_straight(const mt_sample *a, const mt_sample *b, double tolerance) {
    double cx = b->x - a->x, cy = b->y - a->y;
    double bulge = fmax(fabs(cross(a->dx, a->dy, cx, cy)), fabs(cross(b->dx, b->dy, cx, cy))) / 4;
    return bulge <= tolerance * STRAIGHT_SHARE;
}

static mt_arc arc_between(const mt_sample *s, int from, int to, double tolerance) {
    const mt_sample *a = &s[from], *b = &s[to];
    if (is_straight(a, b, tolerance)) return line_arc(s, from, to, tolerance);
    double turn = cross(a->dx, a->dy, b->dx, b->dy), along = a->dx * b->dx + a->dy * b->dy;
    double cx = b->x - a->x, cy = b->y - a->y;
    double ahead = cross(cx, cy, b->dx, b->dy) / turn, behind = cross(a->dx, a->dy, cx, cy) / turn;
    bool meets = turn != 0 && ahead > 0 && behind > 0 && along > cos(MAX_TURN * M_PI / 180);
    if (!meets) return line_arc(s, from, to, tolerance);
    mt_vec control = {a->x + ahead * a->dx, a->y + ahead * a->dy};
    return (mt_arc){false, control, quadratic_error(s, from, to, control, tolerance * GIVE_UP)};
}

/* ---- the best spline
 * ------------------------------------------------------------------------------------------ */

typedef struct mt_step {
    double cost;
    int from;
    mt_arc arc;
} mt_step;

static void try_from(const mt_sample *s, int count, int from, double tolerance, mt_step *best) {
    for (int to = from + 1; to < count; to++) {
        mt_arc arc = arc_between(s, from, to, tolerance);
        if (arc.error <= tolerance) {
            double share = arc.error / tolerance;
            double cost = best[from].cost + 1 + ERROR_SHARE * share * share;
            if (cost < best[to].cost) best[to] = (mt_step){cost, from, arc};
        }
        bool turned_back = s[from].dx * s[to].dx + s[from].dy * s[to].dy < cos(MAX_TURN * M_PI / 180);
        if (s[to].node || turned_back) break;
        if (!arc.line && arc.error > tolerance * GIVE_UP) break;
    }
}

static mt_point rounded(mt_vec p) {
    return (mt_point){(int32_t)lround(p.x), (int32_t)lround(p.y)};
}

mt_status mt_spline(const mt_sample *samples, int count, double tolerance, mt_arena *arena,
                    mt_segment *segments, int *made) {
    mt_step *best = mt_arena_new(arena, (size_t)count, sizeof *best);
    if (!best) return MT_NO_MEMORY;
    for (int j = 1; j < count; j++) best[j].cost = INFINITY;
    for (int i = 0; i + 1 < count; i++) try_from(samples, count, i, tolerance, best);
    int total = 0;
    for (int j = count - 1; j > 0; j = best[j].from) total++;
    *made = total;
    for (int j = count - 1; j > 0; j = best[j].from) {
        mt_segment *segment = &segments[--total];
        *segment = (mt_segment){.degree = best[j].arc.line ? 1 : 2, .end = rounded(place(&samples[j]))};
        if (!best[j].arc.line) segment->control[0] = rounded(best[j].arc.control);
    }
    return MT_OK;
}
