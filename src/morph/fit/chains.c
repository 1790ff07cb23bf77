/* Curves without kinks in between: a run of curves with a kink is fitted anew as a chain (geometry/chain.c), whose nodes lie at the same
 * share between their control points in both masters, so that they are smooth in every mix.
 *
 *     ■────╮ ○ ╭──○──╮           ■ FIXED: a corner in either master, or both head alike; a run ends here
 *          ╰───╯      ▲───────   ▲ LINE: a line follows, and the handle has to have the line's ratio; a run ends here
 *     one run of curves   line   ○ INNER: smooth in both masters, different headings: a kink is possible
 *
 * Where the chain needs more than EXTRA segments more, the run stays as it was. Invariants: FIXED and LINE nodes keep their places; both
 * masters have as many segments, of the same degrees. O(n) chains' fits for n segments. */
#include "morph/fit/chains.h"

#include <math.h>
#include <string.h>

#include "arithmetic/angles.h"
#include "geometry/chain.h"
#include "morph/fit/smooth.h"

/* Segments that a chain may have more than the run had. */
enum { EXTRA = 3 };

/* The kinds of nodes. */
typedef enum mt_node {
    NODE_FIXED, /* a corner in either master; or both head alike, so that no mix can have a kink */
    NODE_LINE,  /* a line on one side: its length fixes the ratio for the curve's handle */
    NODE_INNER,
} mt_node;

typedef struct mt_smooth_state {
    const mt_track *track;
    const int *steps;
    double tolerance;
    mt_arena *arena;
    const mt_contour *masters[2];
    mt_contour made[2];
    mt_node *nodes; /* at the end of each segment */
} mt_smooth_state;

/* Segments first … first + count - 1 of the masters, all of them curves. */
typedef struct mt_curve_run {
    int first, count;
} mt_curve_run;

static int around(const mt_smooth_state *c, int k) {
    int n = c->masters[0]->count;
    return (k % n + n) % n;
}

static const mt_segment *segment(const mt_smooth_state *c, int m, int k) {
    return &c->masters[m]->segments[around(c, k)];
}

static bool is_line(const mt_smooth_state *c, int k) {
    return segment(c, 0, k)->degree == 1;
}

static mt_vec vec(mt_point p) {
    return (mt_vec){p.x, p.y};
}

static mt_vec from_to(mt_point p, mt_point q) {
    return (mt_vec){(double)q.x - p.x, (double)q.y - p.y};
}

static double length(mt_vec v) {
    return mt_hypot(v.x, v.y);
}

/* ---- nodes ----------------------------------------------------------------------------------------------- */

static mt_vec chord_of(const mt_smooth_state *c, int m, int k) {
    return from_to(segment(c, m, k - 1)->end, segment(c, m, k)->end);
}

/* The direction in which a master leaves node k, past segments without length. */
static mt_vec leaving(const mt_smooth_state *c, int m, int k) {
    mt_point at = segment(c, m, k)->end;
    for (int i = k + 1; i <= k + c->masters[m]->count; i++) {
        const mt_segment *next = segment(c, m, i);
        if (next->degree == 2 && !mt_point_equal(next->control[0], at)) return from_to(at, next->control[0]);
        if (!mt_point_equal(next->end, at)) return from_to(at, next->end);
    }
    return (mt_vec){0};
}

static double degrees_between(mt_vec u, mt_vec v) {
    return fabs(mt_atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y)) * (180 / M_PI);
}

static mt_node node_at(const mt_smooth_state *c, int k) {
    if (!mt_is_smooth(c->masters[0], k) || !mt_is_smooth(c->masters[1], k)) return NODE_FIXED;
    if (degrees_between(leaving(c, 0, k), leaving(c, 1, k)) <= MT_KINK_TURN) return NODE_FIXED;
    if (is_line(c, k) && is_line(c, k + 1)) return NODE_FIXED;
    return is_line(c, k) || is_line(c, k + 1) ? NODE_LINE : NODE_INNER;
}

static bool has_kink(const mt_smooth_state *c, int k) {
    return c->nodes[around(c, k)] != NODE_FIXED && mt_kink(c->masters, around(c, k)) > MT_KINK_TURN;
}

/* ---- a run as a chain -------------------------------------------------------------------------------- */

static mt_curve_run run_from(const mt_smooth_state *c, int first) {
    mt_curve_run s = {first, 1};
    while (c->nodes[around(c, first + s.count - 1)] == NODE_INNER) s.count++;
    return s;
}

static bool has_kinks(const mt_smooth_state *c, mt_curve_run s) {
    for (int k = s.first - 1; k < s.first + s.count; k++)
        if (has_kink(c, k)) return true;
    return false;
}

static mt_vec unit(mt_vec v) {
    double l = length(v);
    return l > 0 ? (mt_vec){v.x / l, v.y / l} : (mt_vec){1, 0};
}

/* The end of a chain at node k, with curve `beside` on the chain's side and segment `beyond` on the other. */
static mt_chain_end end_of_chain(const mt_smooth_state *c, int m, int k, int beside, int beyond) {
    mt_point at = segment(c, m, k)->end, control = segment(c, m, beside)->control[0];
    bool first = beside > k;
    mt_chain_end end = {.at = vec(at)};
    mt_vec line = chord_of(c, m, beyond), handle = first ? from_to(at, control) : from_to(control, at);
    if (c->nodes[around(c, k)] == NODE_LINE) end.arm = length(line);
    if (end.arm > 0)
        end.along = unit(line);
    else if (length(handle) > 0)
        end.along = unit(handle);
    else {
        const mt_sample *sample = &c->track->samples[m][c->steps[around(c, k)] % c->track->count];
        end.along = (mt_vec){sample->dx, sample->dy};
    }
    return end;
}

static double share_at(const mt_smooth_state *c, int k) {
    double sum = 0;
    int count = 0;
    for (int m = 0; m < 2; m++) {
        mt_point at = segment(c, m, k)->end;
        double in = length(from_to(segment(c, m, k)->control[0], at)),
               out = length(from_to(at, segment(c, m, k + 1)->control[0]));
        if (in <= 0 || out <= 0) continue;
        sum += in / (in + out);
        count++;
    }
    return count ? sum / count : 0.5;
}

static mt_status chain_of(const mt_smooth_state *c, mt_curve_run s, mt_chain *chain) {
    int last = s.first + s.count - 1;
    *chain = (mt_chain){.count = s.count, .room = s.count + EXTRA};
    chain->share = mt_arena_new(c->arena, (size_t)chain->room, sizeof(double));
    if (!chain->share) return MT_NO_MEMORY;
    for (int k = 0; k < s.count - 1; k++) chain->share[k] = share_at(c, s.first + k);
    for (int m = 0; m < 2; m++) {
        chain->control[m] = mt_arena_new(c->arena, (size_t)chain->room, sizeof(mt_vec));
        if (!chain->control[m]) return MT_NO_MEMORY;
        for (int k = 0; k < s.count; k++) chain->control[m][k] = vec(segment(c, m, s.first + k)->control[0]);
        chain->start[m] = end_of_chain(c, m, s.first - 1, s.first, s.first - 1);
        chain->end[m] = end_of_chain(c, m, last, last, last + 1);
    }
    return MT_OK;
}

/* The samples of one master strictly between the ends of a run, each place once. */
static mt_status samples_of(const mt_smooth_state *c, mt_curve_run s, int m, mt_run *run) {
    const mt_track *track = c->track;
    int first = c->steps[around(c, s.first - 1)] % track->count,
        count = (c->steps[around(c, s.first + s.count - 1)] - first) % track->count;
    if (count <= 0) count += track->count;
    mt_sample *samples = mt_arena_new(c->arena, (size_t)count, sizeof *samples);
    if (!samples) return MT_NO_MEMORY;
    const mt_sample *before = &track->samples[m][first],
                    *last = &track->samples[m][(first + count) % track->count];
    *run = (mt_run){0, samples};
    for (int k = 1; k < count; k++) {
        const mt_sample *next = &track->samples[m][(first + k) % track->count];
        if ((next->x == before->x && next->y == before->y) || (next->x == last->x && next->y == last->y))
            continue;
        samples[run->count++] = *next;
        before = next;
    }
    return MT_OK;
}

/* ---- the new contour --------------------------------------------------------------------------------- */

static mt_point rounded(mt_vec p) {
    return (mt_point){(int32_t)lround(p.x), (int32_t)lround(p.y)};
}

static void add_chain(mt_smooth_state *c, const mt_chain *chain) {
    for (int m = 0; m < 2; m++)
        for (int k = 0; k < chain->count; k++)
            c->made[m].segments[c->made[m].count++] =
                (mt_segment){.degree = 2,
                             .control = {rounded(chain->control[m][k])},
                             .end = rounded(mt_chain_node(chain, m, k + 1))};
}

static void add_as_before(mt_smooth_state *c, mt_curve_run s) {
    for (int m = 0; m < 2; m++)
        for (int k = 0; k < s.count; k++)
            c->made[m].segments[c->made[m].count++] = *segment(c, m, s.first + k);
}

static mt_status refit(mt_smooth_state *c, mt_curve_run s) {
    mt_arena_place place = mt_arena_mark(c->arena);
    mt_chain chain;
    mt_run runs[2];
    bool fits = false;
    mt_status status = chain_of(c, s, &chain);
    for (int m = 0; m < 2 && status == MT_OK; m++) status = samples_of(c, s, m, &runs[m]);
    if (status == MT_OK) status = mt_chain_fit(runs, c->tolerance, c->arena, &chain, &fits);
    if (status == MT_OK && fits)
        add_chain(c, &chain);
    else if (status == MT_OK)
        add_as_before(c, s);
    mt_arena_rewind(c->arena, place);
    return status;
}

/* The segment after a node that is not inner; where all are, after the node at which the two headings differ least. */
static int first_segment(mt_smooth_state *c) {
    int best = 0, n = c->masters[0]->count;
    double least = INFINITY;
    for (int k = 0; k < n; k++) {
        if (c->nodes[k] != NODE_INNER) return k + 1;
        double apart = degrees_between(leaving(c, 0, k), leaving(c, 1, k));
        if (apart >= least) continue;
        least = apart;
        best = k;
    }
    c->nodes[best] = NODE_FIXED;
    return best + 1;
}

/* Kinds of all nodes, and room for the new contour. */
static mt_status start(mt_smooth_state *c) {
    size_t n = (size_t)c->masters[0]->count;
    c->nodes = mt_arena_new(c->arena, n, sizeof *c->nodes);
    if (!c->nodes) return MT_NO_MEMORY;
    for (int k = 0; k < (int)n; k++) c->nodes[k] = node_at(c, k);
    for (int m = 0; m < 2; m++) {
        c->made[m] = (mt_contour){0, mt_arena_new(c->arena, n, (1 + EXTRA) * sizeof(mt_segment))};
        if (!c->made[m].segments) return MT_NO_MEMORY;
    }
    return MT_OK;
}

mt_status mt_chains_smooth(const mt_track *track, const int *steps, double tolerance, mt_arena *arena,
                           mt_contour_pair *masters) {
    mt_smooth_state c = {track, steps, tolerance, arena, {&masters->a, &masters->b}, {{0}}, NULL};
    if (masters->a.count < 2) return MT_OK;
    mt_status status = start(&c);
    int n = masters->a.count, first = first_segment(&c);
    for (int k = first; status == MT_OK && k < first + n;) {
        mt_curve_run s = is_line(&c, k) ? (mt_curve_run){k, 1} : run_from(&c, k);
        if (!is_line(&c, k) && has_kinks(&c, s))
            status = refit(&c, s);
        else
            add_as_before(&c, s);
        k += s.count;
    }
    if (status != MT_OK) return status;
    masters->a = c.made[0];
    masters->b = c.made[1];
    return MT_OK;
}
