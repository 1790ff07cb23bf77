/* A chain of quadratics fitted to samples of two masters at once, by least squares (Gauss–Newton).
 *
 *     p[0]      c[1]      Nodes ● lie between neighbouring control points, at the same share s in both masters:
 *      ●╮    ╭─●─╮        q = (1 - t)² p[k] + 2 t (1 - t) c[k] + t² p[k + 1],   p[k] = (1 - s[k]) c[k - 1] + s[k] c[k]
 *       ╰─●──╯   ╰─●      so that a point is linear in the controls around it, as long as t and the shares are held.
 *     c[0] p[1]  p[2]
 *
 * Each sample asks that q lie on its tangent: one equation, in which sliding along the curve costs nothing. Unknown are, for each master,
 * the handles at both ends and the inner controls, and the shares, which both have in common. They are numbered along the chain, so that a
 * sample's are near each other: the normal equations are a band, and solved in it by Cholesky's method. Invariants: a fitted chain has no handle that points backwards and no segment that turns by more than MT_SEGMENT_TURN_MAX; it is
 * smooth in every mix. O(ROUNDS · (n + u)) for n samples and u unknowns, for each number of segments. */
#include "geometry/chain.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "arithmetic/angles.h"

enum { MASTERS = MT_MASTERS_MAX };
enum { ROUNDS = 8 };        /* of Gauss–Newton */
enum { TERMS = 8 };         /* unknowns that one sample depends on, at most … */
enum { BAND = 11 };         /* … and how far apart these are numbered */
#define DAMPING 1e-3        /* of an unknown's weight: unknowns that few samples determine stay in place */
#define EVENNESS 5e-3       /* weight of even spacing of the controls; a sample's is 1 */
#define EVENNESS_FIRST 0.1  /* … in the first round, where controls that coincide have to be spread */
#define SEGMENT_LEAST 256.0 /* grid units, 1/1000 em: shorter segments count as coinciding */
#define TINY 1e-9           /* added to the diagonal, so that the matrix is positive */
#define HANDLE_LEAST 16.0   /* grid units: a handle keeps at least this length */
#define SHARE_LEAST 0.1     /* a node is no nearer to either control than this share of the way */

typedef struct mt_foot {
    int segment;
    double t;
} mt_foot;

typedef struct mt_solver {
    const mt_run *runs;
    mt_chain *chain;
    mt_foot *feet[MASTERS]; /* of each sample */
    double evenness;
    bool even; /* the shares stay a half */
    int unknowns;
    double *
        matrix; /* of the normal equations: of each row what is up to BAND left of the diagonal, and the diagonal */
    double *right;
} mt_solver;

static double cross(mt_vec u, mt_vec v) {
    return u.x * v.y - u.y * v.x;
}

static double dot(mt_vec u, mt_vec v) {
    return u.x * v.x + u.y * v.y;
}

static mt_vec minus(mt_vec p, mt_vec q) {
    return (mt_vec){p.x - q.x, p.y - q.y};
}

static mt_vec between(mt_vec p, mt_vec q, double share) {
    return (mt_vec){p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)};
}

mt_vec mt_chain_node(const mt_chain *c, int master, int k) {
    if (k == 0) return c->start[master].at;
    if (k == c->count) return c->end[master].at;
    return between(c->control[master][k - 1], c->control[master][k], c->share[k - 1]);
}

/* ---- feet of samples on the chain ---------------------------------------------------------------------- */

static mt_vec point_at(const mt_chain *c, int master, mt_foot foot) {
    mt_vec a = mt_chain_node(c, master, foot.segment), b = mt_chain_node(c, master, foot.segment + 1);
    mt_vec control = c->control[master][foot.segment];
    return between(between(a, control, foot.t), between(control, b, foot.t), foot.t);
}

/* One step of Newton's method towards the foot of the perpendicular, into the next segment where it leads there. */
static void step(const mt_chain *c, int master, mt_vec p, mt_foot *foot) {
    mt_vec a = mt_chain_node(c, master, foot->segment), b = mt_chain_node(c, master, foot->segment + 1);
    mt_vec control = c->control[master][foot->segment], u = minus(control, a);
    mt_vec w = {a.x - 2 * control.x + b.x, a.y - 2 * control.y + b.y};
    mt_vec d = {2 * (u.x + foot->t * w.x), 2 * (u.y + foot->t * w.y)};
    mt_vec off = minus(point_at(c, master, *foot), p);
    double slope = dot(d, d) + 2 * dot(off, w);
    if (slope <= 0) slope = dot(d, d);
    if (slope <= 0) return;
    foot->t -= dot(off, d) / slope;
    if (foot->t < 0 && foot->segment > 0) *foot = (mt_foot){foot->segment - 1, 1};
    if (foot->t > 1 && foot->segment < c->count - 1) *foot = (mt_foot){foot->segment + 1, 0};
    foot->t = fmin(1, fmax(0, foot->t));
}

static mt_vec place_of(const mt_sample *sample) {
    return (mt_vec){sample->x, sample->y};
}

static void find_feet(mt_solver *s, int steps) {
    for (int m = 0; m < MASTERS; m++)
        for (int j = 0; j < s->runs[m].count; j++)
            for (int i = 0; i < steps; i++)
                step(s->chain, m, place_of(&s->runs[m].samples[j]), &s->feet[m][j]);
}

static double distance(mt_vec p, mt_vec q) {
    return mt_hypot(q.x - p.x, q.y - p.y);
}

/* The length of segment k's control polygon. */
static double polygon_length(const mt_chain *c, int master, int k) {
    mt_vec control = c->control[master][k];
    return distance(mt_chain_node(c, master, k), control) +
           distance(control, mt_chain_node(c, master, k + 1));
}

/* The first guess, for one master: as far along the control polygon as along the samples. */
static void spread(const mt_solver *s, int m) {
    const mt_chain *c = s->chain;
    const mt_run *run = &s->runs[m];
    double samples = 0, polygon = 0, done = 0, before = 0;
    mt_vec at = c->start[m].at;
    for (int j = 0; j < run->count; at = place_of(&run->samples[j++]))
        samples += distance(at, place_of(&run->samples[j]));
    samples += distance(at, c->end[m].at);
    for (int k = 0; k < c->count; k++) polygon += polygon_length(c, m, k);
    at = c->start[m].at;
    for (int j = 0, k = 0; j < run->count; at = place_of(&run->samples[j++])) {
        done += distance(at, place_of(&run->samples[j])) / samples * polygon;
        while (k < c->count - 1 && done > before + polygon_length(c, m, k))
            before += polygon_length(c, m, k++);
        double length = polygon_length(c, m, k);
        s->feet[m][j] = (mt_foot){k, length > 0 ? fmin(1, (done - before) / length) : 0.5};
    }
}

/* ---- the normal equations -------------------------------------------------------------------------------- */

/* The distance of a sample from the chain, and its derivatives by the unknowns. */
typedef struct mt_equation {
    int count, unknown[TERMS];
    double slope[TERMS], off;
} mt_equation;

static void add_term(mt_equation *row, int unknown, double slope) {
    for (int i = 0; i < row->count; i++)
        if (row->unknown[i] == unknown) {
            row->slope[i] += slope;
            return;
        }
    row->unknown[row->count] = unknown;
    row->slope[row->count++] = slope;
}

/* Unknowns along the chain: the handles at the start, for both masters, and the share of the first node; of each inner segment its
 * controls and the share of the node after it; the handles at the end. Where the shares stay a half they are left out. */
static int first_inner(const mt_solver *s) {
    return MASTERS + !s->even;
}

static int of_inner(const mt_solver *s, int k) {
    return first_inner(s) + (k - 1) * (2 * MASTERS + !s->even);
}

static int end_unknown(const mt_solver *s, int master, bool last) {
    return master + (last ? of_inner(s, s->chain->count - 1) : 0);
}

static int control_unknown(const mt_solver *s, int master, int k) {
    return of_inner(s, k) + 2 * master;
}

static int share_unknown(const mt_solver *s, int k) {
    return k == 0 ? MASTERS : of_inner(s, k) + 2 * MASTERS;
}

static int count_unknowns(const mt_solver *s) {
    return of_inner(s, s->chain->count - 1) + MASTERS;
}

static double *cell(const mt_solver *s, int row, int column) {
    return &s->matrix[row * (BAND + 1) + BAND + column - row];
}

/* Handles that are tied to their arms are one unknown, in units of the arm. */
static bool is_tied(const mt_chain_end end[MASTERS]) {
    return end[0].arm > 0 && end[1].arm > 0;
}

static void add_end(const mt_solver *s, const mt_chain_end end[MASTERS], int m, bool last, mt_vec weight,
                    mt_equation *row) {
    double slope = dot(end[m].along, weight) * (last ? -1 : 1);
    if (is_tied(end))
        add_term(row, end_unknown(s, 0, last), slope * end[m].arm);
    else
        add_term(row, end_unknown(s, m, last), slope);
}

static void add_control(const mt_solver *s, int m, int k, mt_vec weight, mt_equation *row) {
    const mt_chain *c = s->chain;
    if (k == 0)
        add_end(s, c->start, m, false, weight, row);
    else if (k == c->count - 1)
        add_end(s, c->end, m, true, weight, row);
    else {
        add_term(row, control_unknown(s, m, k), weight.x);
        add_term(row, control_unknown(s, m, k) + 1, weight.y);
    }
}

/* The derivatives by the controls and share of node k, when the sample changes by `weight` with the node. */
static void add_node(const mt_solver *s, int m, int k, mt_vec weight, mt_equation *row) {
    const mt_chain *c = s->chain;
    if (k == 0 || k == c->count) return;
    double share = c->share[k - 1];
    add_control(s, m, k - 1, (mt_vec){(1 - share) * weight.x, (1 - share) * weight.y}, row);
    add_control(s, m, k, (mt_vec){share * weight.x, share * weight.y}, row);
    if (!s->even)
        add_term(row, share_unknown(s, k - 1), dot(weight, minus(c->control[m][k], c->control[m][k - 1])));
}

static mt_equation row_of(const mt_solver *s, int m, int j) {
    const mt_sample *sample = &s->runs[m].samples[j];
    mt_foot foot = s->feet[m][j];
    mt_vec normal = {-sample->dy, sample->dx};
    double t = foot.t, before = (1 - t) * (1 - t), middle = 2 * t * (1 - t), after = t * t;
    mt_equation row = {.off = dot(normal, minus(point_at(s->chain, m, foot), place_of(sample)))};
    add_node(s, m, foot.segment, (mt_vec){before * normal.x, before * normal.y}, &row);
    add_control(s, m, foot.segment, (mt_vec){middle * normal.x, middle * normal.y}, &row);
    add_node(s, m, foot.segment + 1, (mt_vec){after * normal.x, after * normal.y}, &row);
    return row;
}

/* That control k lies in the middle between its neighbours, the first and the last a third of the way from their end to the
 * next, in x or in y: settles what samples say little about. */
static mt_equation evenness(const mt_solver *s, int m, int k, mt_vec axis) {
    const mt_chain *c = s->chain;
    const mt_vec *control = c->control[m];
    bool first = k == 0, last = k == c->count - 1;
    mt_vec before = first ? c->start[m].at : control[k - 1], after = last ? c->end[m].at : control[k + 1];
    double shares[3] = {first ? 2 : 1, first || last ? -3 : -2, last ? 2 : 1};
    mt_vec weights[3];
    for (int i = 0; i < 3; i++)
        weights[i] = (mt_vec){s->evenness * shares[i] * axis.x, s->evenness * shares[i] * axis.y};
    mt_equation row = {.off = dot(weights[0], before) + dot(weights[1], control[k]) + dot(weights[2], after)};
    if (!first) add_control(s, m, k - 1, weights[0], &row);
    add_control(s, m, k, weights[1], &row);
    if (!last) add_control(s, m, k + 1, weights[2], &row);
    return row;
}

static void add_row(mt_solver *s, const mt_equation *row) {
    for (int i = 0; i < row->count; i++) {
        for (int k = 0; k < row->count; k++)
            if (row->unknown[k] <= row->unknown[i])
                *cell(s, row->unknown[i], row->unknown[k]) += row->slope[i] * row->slope[k];
        s->right[row->unknown[i]] -= row->slope[i] * row->off;
    }
}

static void set_up(mt_solver *s) {
    int n = s->unknowns;
    memset(s->matrix, 0, (size_t)n * (BAND + 1) * sizeof(double));
    memset(s->right, 0, (size_t)n * sizeof(double));
    for (int m = 0; m < MASTERS; m++) {
        for (int j = 0; j < s->runs[m].count; j++) {
            mt_equation row = row_of(s, m, j);
            add_row(s, &row);
        }
        for (int k = 0; k < s->chain->count; k++) {
            mt_equation in_x = evenness(s, m, k, (mt_vec){1, 0}), in_y = evenness(s, m, k, (mt_vec){0, 1});
            add_row(s, &in_x);
            add_row(s, &in_y);
        }
    }
    for (int i = 0; i < n; i++) *cell(s, i, i) = (1 + DAMPING) * *cell(s, i, i) + TINY;
}

/* Cholesky's method, in place and within the band; false where the matrix is not positive. */
static bool solve(mt_solver *s) {
    int n = s->unknowns;
    double *x = s->right;
    for (int i = 0; i < n; i++) {
        int first = i > BAND ? i - BAND : 0;
        for (int j = first; j <= i; j++) {
            double sum = *cell(s, i, j);
            for (int k = first; k < j; k++) sum -= *cell(s, i, k) * *cell(s, j, k);
            if (i == j && sum <= 0) return false;
            *cell(s, i, j) = i == j ? sqrt(sum) : sum / *cell(s, j, j);
        }
        for (int k = first; k < i; k++) x[i] -= *cell(s, i, k) * x[k];
        x[i] /= *cell(s, i, i);
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n && k <= i + BAND; k++) x[i] -= *cell(s, k, i) * x[k];
        x[i] /= *cell(s, i, i);
    }
    return true;
}

/* ---- moving ---------------------------------------------------------------------------------------------- */

static double handle_at(const mt_chain_end *end, mt_vec control, bool last) {
    return dot(end->along, minus(control, end->at)) * (last ? -1 : 1);
}

static mt_vec control_on(const mt_chain_end *end, double handle, bool last) {
    double along = last ? -handle : handle;
    return (mt_vec){end->at.x + along * end->along.x, end->at.y + along * end->along.y};
}

/* A handle never reverses: it keeps at least a quarter of its length. */
static double moved_handle(double handle, double by, double least) {
    double was = fmax(handle, least);
    return fmax(was / 4, handle + by);
}

static void move_end(const mt_solver *s, const mt_chain_end end[MASTERS], bool last) {
    for (int m = 0; m < MASTERS; m++) {
        mt_vec *control = &s->chain->control[m][last ? s->chain->count - 1 : 0];
        double by = s->right[end_unknown(s, is_tied(end) ? 0 : m, last)],
               unit = is_tied(end) ? end[m].arm : 1;
        double handle = handle_at(&end[m], *control, last) / unit;
        *control = control_on(&end[m], moved_handle(handle, by, HANDLE_LEAST / unit) * unit, last);
    }
}

static void move_all(mt_solver *s) {
    mt_chain *c = s->chain;
    move_end(s, c->start, false);
    move_end(s, c->end, true);
    for (int m = 0; m < MASTERS; m++)
        for (int k = 1; k < c->count - 1; k++) {
            const double *by = &s->right[control_unknown(s, m, k)];
            c->control[m][k].x += by[0];
            c->control[m][k].y += by[1];
        }
    for (int k = 0; k < c->count - 1 && !s->even; k++)
        c->share[k] = fmin(1 - SHARE_LEAST, fmax(SHARE_LEAST, c->share[k] + s->right[share_unknown(s, k)]));
}

/* Tied handles begin in the arms' ratio. */
static void tie(mt_chain *c, const mt_chain_end end[MASTERS], bool last) {
    if (!is_tied(end)) return;
    double ratio = 0;
    int k = last ? c->count - 1 : 0;
    for (int m = 0; m < MASTERS; m++)
        ratio += handle_at(&end[m], c->control[m][k], last) / end[m].arm / MASTERS;
    for (int m = 0; m < MASTERS; m++) c->control[m][k] = control_on(&end[m], ratio * end[m].arm, last);
}

/* ---- error of the chain --------------------------------------------------------------------------- */

/* Whether no handle points backwards and no segment turns by too much. */
static bool is_usable(const mt_chain *c) {
    for (int m = 0; m < MASTERS; m++) {
        if (handle_at(&c->start[m], c->control[m][0], false) < 0) return false;
        if (handle_at(&c->end[m], c->control[m][c->count - 1], true) < 0) return false;
        for (int k = 0; k < c->count; k++) {
            mt_vec in = minus(c->control[m][k], mt_chain_node(c, m, k)),
                   out = minus(mt_chain_node(c, m, k + 1), c->control[m][k]);
            if (fabs(mt_atan2(cross(in, out), dot(in, out))) > MT_SEGMENT_TURN_MAX * M_PI / 180) return false;
        }
    }
    return true;
}

/* The distance of a sample from the chain; beyond an end, across the sample's own direction. */
static double distance_of(const mt_solver *s, int m, int j) {
    const mt_sample *sample = &s->runs[m].samples[j];
    mt_foot foot = s->feet[m][j];
    mt_vec off = minus(point_at(s->chain, m, foot), place_of(sample));
    bool beyond = (foot.segment == 0 && foot.t == 0) || (foot.segment == s->chain->count - 1 && foot.t == 1);
    return beyond ? fabs(cross((mt_vec){sample->dx, sample->dy}, off)) : mt_hypot(off.x, off.y);
}

/* The largest distance of a sample, and the segment with it. */
static double error_of(const mt_solver *s, int *segment) {
    double worst = 0;
    *segment = 0;
    for (int m = 0; m < MASTERS; m++)
        for (int j = 0; j < s->runs[m].count; j++) {
            double off = distance_of(s, m, j);
            if (off <= worst) continue;
            worst = off;
            *segment = s->feet[m][j].segment;
        }
    return worst;
}

/* ---- one number of segments ------------------------------------------------------------------------------ */

static mt_status solver_for(const mt_run runs[MASTERS], mt_chain *chain, bool even, mt_arena *arena,
                            mt_solver *solver) {
    mt_solver made = {.runs = runs, .chain = chain, .even = even};
    made.unknowns = count_unknowns(&made);
    made.matrix = mt_arena_new(arena, (size_t)made.unknowns, (BAND + 1) * sizeof(double));
    made.right = mt_arena_new(arena, (size_t)made.unknowns, sizeof(double));
    for (int m = 0; m < MASTERS; m++) {
        made.feet[m] = mt_arena_new(arena, (size_t)runs[m].count, sizeof(mt_foot));
        if (!made.feet[m]) return MT_NO_MEMORY;
    }
    if (!made.matrix || !made.right) return MT_NO_MEMORY;
    *solver = made;
    return MT_OK;
}

/* The work of all rounds: the equations, and their solution (base/memory.h). */
static int64_t steps_of(const mt_solver *s) {
    int samples = 0;
    for (int m = 0; m < MASTERS; m++) samples += s->runs[m].count;
    return (int64_t)ROUNDS * TERMS * TERMS * ((int64_t)samples + s->unknowns);
}

/* Whether a master has a segment of almost no length. */
static bool is_uneven(const mt_chain *c) {
    for (int m = 0; m < MASTERS; m++)
        for (int k = 0; k < c->count; k++)
            if (polygon_length(c, m, k) < SEGMENT_LEAST) return true;
    return false;
}

/* Fits a chain of two segments or more as it is divided, until it is within the tolerance. *error: INFINITY where the chain is unusable;
 * *segment: the one with the largest error. */
static void iterate(mt_solver *s, double tolerance, double *error, int *segment) {
    tie(s->chain, s->chain->start, false);
    tie(s->chain, s->chain->end, true);
    for (int m = 0; m < MASTERS; m++) spread(s, m);
    find_feet(s, 4);
    *error = INFINITY;
    for (int i = 0; i<ROUNDS && * error> tolerance; i++) {
        s->evenness = i == 0 && is_uneven(s->chain) ? EVENNESS_FIRST : EVENNESS;
        set_up(s);
        if (!solve(s)) return;
        move_all(s);
        find_feet(s, 2);
        *error = is_usable(s->chain) ? error_of(s, segment) : INFINITY;
    }
}

/* ---- more segments --------------------------------------------------------------------------------------- */

/* Divides segment k in the middle of its parameter; its neighbours keep their nodes. */
static void divide(mt_chain *c, int k) {
    double before = k > 0 ? c->share[k - 1] : 0, after = k < c->count - 1 ? c->share[k] : 1;
    for (int m = 0; m < MASTERS; m++) {
        mt_vec *control = c->control[m], at = control[k];
        mt_vec a = mt_chain_node(c, m, k), b = mt_chain_node(c, m, k + 1);
        memmove(&control[k + 1], &control[k], (size_t)(c->count - k) * sizeof *control);
        control[k] = between(a, at, 0.5);
        control[k + 1] = between(at, b, 0.5);
    }
    memmove(&c->share[k + 1], &c->share[k], (size_t)(c->count - 1 - k) * sizeof *c->share);
    c->share[k] = 0.5;
    c->count++;
    /* the handles beside it are half as long as they were */
    if (k > 0) c->share[k - 1] = before / (before + (1 - before) / 2);
    if (k < c->count - 2) c->share[k + 1] = after / 2 / (after / 2 + 1 - after);
}

static mt_status new_copy(const mt_chain *chain, mt_arena *arena, mt_chain *copy) {
    *copy = *chain;
    copy->share = mt_arena_new(arena, (size_t)chain->room, sizeof(double));
    if (!copy->share) return MT_NO_MEMORY;
    for (int m = 0; m < MASTERS; m++) {
        copy->control[m] = mt_arena_new(arena, (size_t)chain->room, sizeof(mt_vec));
        if (!copy->control[m]) return MT_NO_MEMORY;
    }
    return MT_OK;
}

static void copy_chain(const mt_chain *from, mt_chain *to) {
    to->count = from->count;
    memcpy(to->share, from->share, (size_t)(from->count - 1) * sizeof(double));
    for (int m = 0; m < MASTERS; m++)
        memcpy(to->control[m], from->control[m], (size_t)from->count * sizeof(mt_vec));
}

mt_status mt_chain_fit(const mt_run runs[MASTERS], double tolerance, mt_arena *arena, mt_chain *chain,
                       bool *fits) {
    mt_chain trial;
    double error = INFINITY;
    int worst = 0;
    assert(chain->count >= 1 && chain->count <= chain->room);
    mt_status status = new_copy(chain, arena, &trial);
    if (chain->count == 1 && chain->room > 1) divide(chain, 0);
    while (status == MT_OK && chain->count > 1) {
        for (int even = 1; status == MT_OK && even >= 0 && error > tolerance; even--) {
            mt_solver solver;
            mt_arena_place place = mt_arena_mark(arena);
            copy_chain(chain, &trial);
            for (int k = 0; k < trial.count - 1 && even; k++) trial.share[k] = 0.5;
            status = solver_for(runs, &trial, even, arena, &solver);
            if (status == MT_OK && !mt_arena_spend(arena, steps_of(&solver))) status = MT_TOO_LARGE;
            if (status == MT_OK) iterate(&solver, tolerance, &error, &worst);
            mt_arena_rewind(arena, place);
        }
        if (status != MT_OK || error <= tolerance || chain->count == chain->room) break;
        divide(chain, worst);
    }
    *fits = error <= tolerance;
    if (status == MT_OK && *fits) copy_chain(&trial, chain);
    return status;
}
