#include "morph/fit/chains.h"

#include <math.h>
#include <string.h>

#include "geometry/chain.h"
#include "morph/fit/smooth.h"

/* Kinks of no more than so many degrees are let be, and so is what heads apart by no more than that. */
#define KINK_TURN 0.5
/* So many segments more than before a chain may have. */
enum { EXTRA = 3 };

/* What a node is to the curves on its sides. */
typedef enum mt_node {
    NODE_FIXED, /* a corner in either master; or both head alike, so that what is between them cannot turn */
    NODE_LINE,  /* on one side is a line, as long as it is: the curve's handle has to follow */
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

static int around(const mt_smooth_state *b, int k) {
    int n = b->masters[0]->count;
    return (k % n + n) % n;
}

static const mt_segment *segment(const mt_smooth_state *b, int m, int k) {
    return &b->masters[m]->segments[around(b, k)];
}

static bool is_line(const mt_smooth_state *b, int k) {
    return segment(b, 0, k)->degree == 1;
}

static mt_vec vec(mt_point p) {
    return (mt_vec){p.x, p.y};
}

static mt_vec from_to(mt_point p, mt_point q) {
    return (mt_vec){(double)q.x - p.x, (double)q.y - p.y};
}

static double length(mt_vec v) {
    return hypot(v.x, v.y);
}

/* ---- nodes ----------------------------------------------------------------------------------------------- */

static mt_vec way_of(const mt_smooth_state *b, int m, int k) {
    return from_to(segment(b, m, k - 1)->end, segment(b, m, k)->end);
}

/* How a master leaves node k; where it waits, how it goes on then. */
static mt_vec leaving(const mt_smooth_state *b, int m, int k) {
    mt_point at = segment(b, m, k)->end;
    for (int i = k + 1; i <= k + b->masters[m]->count; i++) {
        const mt_segment *next = segment(b, m, i);
        if (next->degree == 2 && !mt_point_equal(next->control[0], at)) return from_to(at, next->control[0]);
        if (!mt_point_equal(next->end, at)) return from_to(at, next->end);
    }
    return (mt_vec){0};
}

static double degrees_between(mt_vec u, mt_vec v) {
    return fabs(atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y)) * (180 / M_PI);
}

static mt_node node_at(const mt_smooth_state *b, int k) {
    if (!mt_is_smooth(b->masters[0], k) || !mt_is_smooth(b->masters[1], k)) return NODE_FIXED;
    if (degrees_between(leaving(b, 0, k), leaving(b, 1, k)) <= KINK_TURN) return NODE_FIXED;
    if (is_line(b, k) && is_line(b, k + 1)) return NODE_FIXED;
    return is_line(b, k) || is_line(b, k + 1) ? NODE_LINE : NODE_INNER;
}

static bool has_kink(const mt_smooth_state *b, int k) {
    return b->nodes[around(b, k)] != NODE_FIXED && mt_kink(b->masters, around(b, k)) > KINK_TURN;
}

/* ---- a stretch as a chain -------------------------------------------------------------------------------- */

static mt_curve_run stretch_from(const mt_smooth_state *b, int first) {
    mt_curve_run s = {first, 1};
    while (b->nodes[around(b, first + s.count - 1)] == NODE_INNER) s.count++;
    return s;
}

static bool needs_mending(const mt_smooth_state *b, mt_curve_run s) {
    for (int k = s.first - 1; k < s.first + s.count; k++)
        if (has_kink(b, k)) return true;
    return false;
}

static mt_vec unit(mt_vec v) {
    double l = length(v);
    return l > 0 ? (mt_vec){v.x / l, v.y / l} : (mt_vec){1, 0};
}

/* The end of a chain at node k, with curve `beside` on the chain's side and segment `beyond` on the other. */
static mt_anchorage anchorage(const mt_smooth_state *b, int m, int k, int beside, int beyond) {
    mt_point at = segment(b, m, k)->end, control = segment(b, m, beside)->control[0];
    bool first = beside > k;
    mt_anchorage end = {.at = vec(at)};
    mt_vec line = way_of(b, m, beyond), handle = first ? from_to(at, control) : from_to(control, at);
    if (b->nodes[around(b, k)] == NODE_LINE) end.arm = length(line);
    if (end.arm > 0)
        end.along = unit(line);
    else if (length(handle) > 0)
        end.along = unit(handle);
    else {
        const mt_sample *sample = &b->track->samples[m][b->steps[around(b, k)] % b->track->count];
        end.along = (mt_vec){sample->dx, sample->dy};
    }
    return end;
}

static double share_at(const mt_smooth_state *b, int k) {
    double sum = 0;
    int count = 0;
    for (int m = 0; m < 2; m++) {
        mt_point at = segment(b, m, k)->end;
        double in = length(from_to(segment(b, m, k)->control[0], at)),
               out = length(from_to(at, segment(b, m, k + 1)->control[0]));
        if (in <= 0 || out <= 0) continue;
        sum += in / (in + out);
        count++;
    }
    return count ? sum / count : 0.5;
}

static mt_status chain_of(const mt_smooth_state *b, mt_curve_run s, mt_chain *chain) {
    int last = s.first + s.count - 1;
    *chain = (mt_chain){.count = s.count, .room = s.count + EXTRA};
    chain->share = mt_arena_new(b->arena, (size_t)chain->room, sizeof(double));
    if (!chain->share) return MT_NO_MEMORY;
    for (int k = 0; k < s.count - 1; k++) chain->share[k] = share_at(b, s.first + k);
    for (int m = 0; m < 2; m++) {
        chain->control[m] = mt_arena_new(b->arena, (size_t)chain->room, sizeof(mt_vec));
        if (!chain->control[m]) return MT_NO_MEMORY;
        for (int k = 0; k < s.count; k++) chain->control[m][k] = vec(segment(b, m, s.first + k)->control[0]);
        chain->start[m] = anchorage(b, m, s.first - 1, s.first, s.first - 1);
        chain->end[m] = anchorage(b, m, last, last, last + 1);
    }
    return MT_OK;
}

/* The samples of one master strictly between the ends of a stretch, each place once. */
static mt_status run_of(const mt_smooth_state *b, mt_curve_run s, int m, mt_run *run) {
    const mt_track *track = b->track;
    int first = b->steps[around(b, s.first - 1)] % track->count,
        count = (b->steps[around(b, s.first + s.count - 1)] - first) % track->count;
    if (count <= 0) count += track->count;
    mt_sample *samples = mt_arena_new(b->arena, (size_t)count, sizeof *samples);
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

/* ---- putting it together --------------------------------------------------------------------------------- */

static mt_point rounded(mt_vec p) {
    return (mt_point){(int32_t)lround(p.x), (int32_t)lround(p.y)};
}

static void add_chain(mt_smooth_state *b, const mt_chain *chain) {
    for (int m = 0; m < 2; m++)
        for (int k = 0; k < chain->count; k++)
            b->made[m].segments[b->made[m].count++] =
                (mt_segment){.degree = 2,
                             .control = {rounded(chain->control[m][k])},
                             .end = rounded(mt_chain_node(chain, m, k + 1))};
}

static void add_stretch(mt_smooth_state *b, mt_curve_run s) {
    for (int m = 0; m < 2; m++)
        for (int k = 0; k < s.count; k++)
            b->made[m].segments[b->made[m].count++] = *segment(b, m, s.first + k);
}

static mt_status mend(mt_smooth_state *b, mt_curve_run s) {
    mt_arena_place place = mt_arena_mark(b->arena);
    mt_chain chain;
    mt_run runs[2];
    bool fits = false;
    mt_status status = chain_of(b, s, &chain);
    for (int m = 0; m < 2 && status == MT_OK; m++) status = run_of(b, s, m, &runs[m]);
    if (status == MT_OK) status = mt_chain_fit(runs, b->tolerance, b->arena, &chain, &fits);
    if (status == MT_OK && fits)
        add_chain(b, &chain);
    else if (status == MT_OK)
        add_stretch(b, s);
    mt_arena_rewind(b->arena, place);
    return status;
}

/* The segment after a node that is not inner. Where all are, that after the one that heads most nearly the same way in both. */
static int first_segment(mt_smooth_state *b) {
    int best = 0, n = b->masters[0]->count;
    double least = INFINITY;
    for (int k = 0; k < n; k++) {
        if (b->nodes[k] != NODE_INNER) return k + 1;
        double apart = degrees_between(leaving(b, 0, k), leaving(b, 1, k));
        if (apart >= least) continue;
        least = apart;
        best = k;
    }
    b->nodes[best] = NODE_FIXED;
    return best + 1;
}

/* Room for what each curve may become. */
static mt_status start(mt_smooth_state *b) {
    size_t n = (size_t)b->masters[0]->count;
    b->nodes = mt_arena_new(b->arena, n, sizeof *b->nodes);
    if (!b->nodes) return MT_NO_MEMORY;
    for (int k = 0; k < (int)n; k++) b->nodes[k] = node_at(b, k);
    for (int m = 0; m < 2; m++) {
        b->made[m] = (mt_contour){0, mt_arena_new(b->arena, n, (1 + EXTRA) * sizeof(mt_segment))};
        if (!b->made[m].segments) return MT_NO_MEMORY;
    }
    return MT_OK;
}

mt_status mt_chains_smooth(const mt_track *track, const int *steps, double tolerance, mt_arena *arena,
                           mt_contour_pair *masters) {
    mt_smooth_state b = {track, steps, tolerance, arena, {&masters->a, &masters->b}, {{0}}, NULL};
    if (masters->a.count < 2) return MT_OK;
    mt_status status = start(&b);
    int n = masters->a.count, first = first_segment(&b);
    for (int k = first; status == MT_OK && k < first + n;) {
        mt_curve_run s = is_line(&b, k) ? (mt_curve_run){k, 1} : stretch_from(&b, k);
        if (!is_line(&b, k) && needs_mending(&b, s))
            status = mend(&b, s);
        else
            add_stretch(&b, s);
        k += s.count;
    }
    if (status != MT_OK) return status;
    masters->a = b.made[0];
    masters->b = b.made[1];
    return MT_OK;
}
