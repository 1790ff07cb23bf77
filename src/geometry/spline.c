/* The fewest quadratics that follow a run of samples, by dynamic programming over the samples: best[j] is the
 * least cost of a spline from the first sample to sample j, where a segment costs 1 and a little for its
 * error.
 *
 * One segment between two samples has no freedom: its control point is where the two tangents meet. Invariants: segments join with a
 * common direction; both masters have as many, ending at the same samples. O(n²) segments tried for n samples, each O(n), at worst;
 * GIVE_UP keeps it near O(n) segments.
 *
 *            c              the tangents meet ahead of the one and behind the other, and the whole turns
 *          /   \            by less than MT_SEGMENT_TURN_MAX: otherwise no single quadratic joins them
 *        a       b
 */
#include "geometry/spline.h"

#include <assert.h>
#include <math.h>

#include "arithmetic/angles.h"

#define ERROR_SHARE 0.5    /* cost of an error as large as the tolerance; a segment costs 1 */
#define STRAIGHT_SHARE 0.1 /* of the tolerance: a run within it of a line is one */
#define HEADINGS_APART 6.0 /* degrees between the headings of two masters at a shared node … */
#define APART_COST 0.25    /* … that cost this much; more with the square of the angle */
enum { HELD_STEPS = 4 };   /* work of a sample held against an arc (base/memory.h) */
#define GIVE_UP 4.0 /* tolerances: past this error, longer segments from the same start are not tried */

typedef struct mt_arc {
    bool line;
    mt_vec control;
    double error; /* grid units; INFINITY when no segment joins the two samples */
} mt_arc;

mt_sample mt_sample_at(double x, double y, double heading, bool node) {
    if (node) heading = round(heading / (M_PI / 2)) * (M_PI / 2);
    return (mt_sample){x, y, mt_cos(heading), mt_sin(heading), node};
}

static mt_vec place(const mt_sample *s) {
    return (mt_vec){s->x, s->y};
}

static double cross(double ax, double ay, double bx, double by) {
    return ax * by - ay * bx;
}

/* ---- distance of a sample from a segment --------------------------------------------------------------- */

static double within_unit(double t) {
    return t < 0 ? 0 : t > 1 ? 1 : t;
}

static double distance_to_line(mt_vec p, mt_vec a, mt_vec b) {
    double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    double t = length2 > 0 ? within_unit(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2) : 0;
    double x = p.x - a.x - t * dx, y = p.y - a.y - t * dy;
    return sqrt(x * x + y * y);
}

/* The parabola through a and b with control point c, as the zeros of v² - 4uw, where u, v and w are the barycentric coordinates in
 * the triangle a, c, b, each times the triangle's doubled area. */
typedef struct mt_parabola {
    mt_vec a, c, b;
    mt_vec du, dv, dw; /* how u, v and w change with the place */
    double area2;
} mt_parabola;

static mt_parabola parabola(mt_vec a, mt_vec c, mt_vec b) {
    return (mt_parabola){.a = a,
                         .c = c,
                         .b = b,
                         .du = {c.y - b.y, b.x - c.x},
                         .dv = {b.y - a.y, a.x - b.x},
                         .dw = {a.y - c.y, c.x - a.x},
                         .area2 = cross(c.x - a.x, c.y - a.y, b.x - a.x, b.y - a.y)};
}

/* To first order: the value over its gradient. On the far side of the
 * chord the parabola goes on, but not the curve. */
static double distance_to_parabola(mt_vec p, const mt_parabola *q) {
    double u = (p.x - q->b.x) * q->du.x + (p.y - q->b.y) * q->du.y;
    double v = (p.x - q->a.x) * q->dv.x + (p.y - q->a.y) * q->dv.y;
    double w = (p.x - q->c.x) * q->dw.x + (p.y - q->c.y) * q->dw.y;
    double gx = 2 * v * q->dv.x - 4 * (u * q->dw.x + w * q->du.x);
    double gy = 2 * v * q->dv.y - 4 * (u * q->dw.y + w * q->du.y);
    double distance = fabs(v * v - 4 * u * w) / sqrt(gx * gx + gy * gy);
    return v * q->area2 >= 0 ? distance : fmax(distance, distance_to_line(p, q->a, q->b));
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
        *t = within_unit(*t - (off.x * d.x + off.y * d.y) / slope);
    }
    return sqrt(off.x * off.x + off.y * off.y);
}

static double line_error(const mt_sample *s, int from, int to) {
    double worst = 0;
    for (int k = from + 1; k < to; k++)
        worst = fmax(worst, distance_to_line(place(&s[k]), place(&s[from]), place(&s[to])));
    return worst;
}

/* To first order, and no further than the limit. */
static double quadratic_error(const mt_sample *s, int from, int to, mt_vec control, double limit) {
    mt_parabola curve = parabola(place(&s[from]), control, place(&s[to]));
    double worst = 0;
    for (int k = from + 1; k < to && worst <= limit; k++)
        worst = fmax(worst, distance_to_parabola(place(&s[k]), &curve));
    return worst;
}

static double exact_error(const mt_sample *s, int from, int to, mt_vec control) {
    double worst = 0, t = 0;
    for (int k = from + 1; k < to; k++) {
        double start = (double)(k - from) / (to - from);
        t = fmax(t, start * 0.5 + t * 0.5);
        worst = fmax(worst, distance_to_quadratic(place(&s[k]), place(&s[from]), control, place(&s[to]), &t));
    }
    return worst;
}

/* ---- one segment --------------------------------------------------------------------------------------- */

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
    bool meets = turn != 0 && ahead > 0 && behind > 0 && along > mt_cos(MT_SEGMENT_TURN_MAX * M_PI / 180);
    if (!meets) return line_arc(s, from, to, tolerance);
    mt_vec control = {a->x + ahead * a->dx, a->y + ahead * a->dy};
    return (mt_arc){false, control, quadratic_error(s, from, to, control, tolerance * GIVE_UP)};
}

/* ---- one segment in every master ----------------------------------------------------------------------- */

typedef struct mt_joint_arc {
    bool line;
    mt_vec control[MT_MASTERS_MAX];
    double error;
} mt_joint_arc;

typedef struct mt_problem {
    const mt_sample *const *masters;
    int master_count, count;
    double tolerance;
} mt_problem;

static double length(mt_vec a, mt_vec b) {
    return mt_hypot(b.x - a.x, b.y - a.y);
}

/* The control point of a master that is straight here: at the same share of its chord as in a curved one. */
static mt_vec along_chord(const mt_sample *a, const mt_sample *b, double share) {
    return (mt_vec){a->x + share * (b->x - a->x), a->y + share * (b->y - a->y)};
}

static mt_joint_arc joint_arc(const mt_problem *p, int from, int to) {
    mt_arc arcs[MT_MASTERS_MAX];
    mt_joint_arc joint = {.line = true};
    double share = 0.5;
    for (int m = 0; m < p->master_count; m++) {
        arcs[m] = arc_between(p->masters[m], from, to, p->tolerance);
        joint.error = fmax(joint.error, arcs[m].error);
        if (arcs[m].line) continue;
        joint.line = false;
        double in = length(place(&p->masters[m][from]), arcs[m].control);
        share = in / (in + length(arcs[m].control, place(&p->masters[m][to])));
    }
    for (int m = 0; m < p->master_count && !joint.line; m++)
        joint.control[m] =
            arcs[m].line ? along_chord(&p->masters[m][from], &p->masters[m][to], share) : arcs[m].control;
    return joint;
}

/* The cost of different headings of two masters at a node, where curves between them may have a kink. */
static double heading_cost(const mt_problem *p, int k) {
    if (p->master_count < 2 || k == p->count - 1) return 0;
    const mt_sample *a = &p->masters[0][k], *b = &p->masters[1][k];
    double degrees =
        fabs(mt_atan2(cross(a->dx, a->dy, b->dx, b->dy), a->dx * b->dx + a->dy * b->dy)) * (180 / M_PI);
    double share = fmin(degrees / HEADINGS_APART, 4);
    return APART_COST * share * share;
}

/* ---- the best spline ----------------------------------------------------------------------------------- */

typedef struct mt_step {
    double cost;
    int from;
    mt_joint_arc arc;
} mt_step;

static bool is_node(const mt_problem *p, int k) {
    for (int m = 0; m < p->master_count; m++)
        if (p->masters[m][k].node) return true;
    return false;
}

static bool turned_back(const mt_problem *p, int from, int to) {
    for (int m = 0; m < p->master_count; m++) {
        const mt_sample *a = &p->masters[m][from], *b = &p->masters[m][to];
        if (a->dx * b->dx + a->dy * b->dy < mt_cos(MT_SEGMENT_TURN_MAX * M_PI / 180)) return true;
    }
    return false;
}

static double cost_of(const mt_problem *p, const mt_joint_arc *arc, int to) {
    double share = arc->error / p->tolerance;
    return 1 + ERROR_SHARE * share * share + heading_cost(p, to);
}

/* Takes an arc that costs less than the best way so far, once it is sure that it fits. */
static void take_if_better(const mt_problem *p, int from, int to, mt_joint_arc arc, mt_step *best) {
    if (best[from].cost + cost_of(p, &arc, to) >= best[to].cost) return;
    for (int m = 0; m < p->master_count && !arc.line; m++)
        arc.error = fmax(arc.error, exact_error(p->masters[m], from, to, arc.control[m]));
    double cost = best[from].cost + cost_of(p, &arc, to);
    if (arc.error <= p->tolerance && cost < best[to].cost) best[to] = (mt_step){cost, from, arc};
}

/* Gives how many samples were held against arcs. */
static int64_t try_from(const mt_problem *p, int from, mt_step *best) {
    int64_t held = 0;
    for (int to = from + 1; to < p->count; to++) {
        mt_joint_arc arc = joint_arc(p, from, to);
        held += (int64_t)p->master_count * (to - from);
        if (arc.error <= p->tolerance) take_if_better(p, from, to, arc, best);
        if (is_node(p, to) || turned_back(p, from, to)) break;
        if (!arc.line && arc.error > p->tolerance * GIVE_UP) break;
    }
    return held;
}

static mt_point rounded(mt_vec p) {
    return (mt_point){(int32_t)lround(p.x), (int32_t)lround(p.y)};
}

static void write_segments(const mt_problem *p, const mt_step *best, int total, mt_segment *const *segments,
                           int *ends) {
    for (int j = p->count - 1; j > 0; j = best[j].from) {
        total--;
        ends[total] = j;
        for (int m = 0; m < p->master_count; m++) {
            mt_segment *segment = &segments[m][total];
            *segment =
                (mt_segment){.degree = best[j].arc.line ? 1 : 2, .end = rounded(place(&p->masters[m][j]))};
            if (!best[j].arc.line) segment->control[0] = rounded(best[j].arc.control[m]);
        }
    }
}

mt_status mt_spline(const mt_sample *const *masters, int master_count, int count, double tolerance,
                    mt_arena *arena, mt_segment *const *segments, int *ends, int *made) {
    mt_problem problem = {masters, master_count, count, tolerance};
    mt_step *best = mt_arena_new(arena, (size_t)count, sizeof *best);
    if (!best) return MT_NO_MEMORY;
    for (int j = 1; j < count; j++) best[j].cost = INFINITY;
    mt_joint_arc whole = joint_arc(&problem, 0, count - 1);
    if (whole.line && whole.error <= tolerance)
        best[count - 1] = (mt_step){1, 0, whole}; /* nothing beats one line */
    else
        for (int i = 0; i + 1 < count; i++)
            if (!mt_arena_spend(arena, HELD_STEPS * try_from(&problem, i, best))) return MT_TOO_LARGE;
    assert(best[count - 1].cost < INFINITY); /* neighbours are always joined */
    int total = 0;
    for (int j = count - 1; j > 0; j = best[j].from) total++;
    write_segments(&problem, best, total, segments, ends);
    *made = total;
    return MT_OK;
}
