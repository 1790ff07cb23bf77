/* One contour for two aligned rings: the same lines and quadratics fitted to both (docs/joining.md, step 9).
 *
 *     A  ●────●╮        Steps of the alignment pair samples of A and B. Runs between breaks are fitted by mt_spline, both masters
 *        │  run ╲       at once: breaks are corners of either ring (●) and the ends of lines that both have.
 *     B  ●───●╮  ○      ○ nodes inside a run: extrema that both have, and as few others as keep within the tolerance.
 *        │ run ╲  ○
 *
 * 1. Extrema that the alignment has up to STEPS_APART steps apart are paired first: one master waits at its own (pair_extrema).
 * 2. Breaks are found, each run is fitted, lines are tidied (lines.c).
 * 3. Smooth nodes that would have a kink in between are moved (smooth.c), and then curves fitted anew (chains.c).
 * Invariant: both masters have as many segments, of the same degrees. O(n) for n steps, but for mt_spline. */
#include "morph/fit/contour_pair.h"

#include <assert.h>
#include <math.h>

#include "arithmetic/angles.h"
#include "geometry/limits.h"
#include "geometry/spline.h"
#include "morph/fit/chains.h"
#include "morph/fit/lines.h"
#include "morph/fit/smooth.h"

/* Of the tolerance: a run within it of a line is that line. */
#define STRAIGHT_SHARE 0.1
/* A line of at least this length in both rings stays a line, 1/1000 em: the eye sees it bend. */
#define LINE_LEAST 30.0
/* One ring waits at a corner while the other goes further than this: shorter, it would be a stub, 1/1000 em. */
#define WAIT_LEAST 2.0

/* An extremum of one master is paired with one of the other at most so many steps further on, whose heading differs by less than so
 * many radians. */
enum { STEPS_APART = 6 };
#define SAME_HEADING 0.5

typedef struct mt_fit_state {
    const mt_ring_samples *samples[2];
    const mt_alignment *alignment;
    bool *breaks; /* at each step: whether a run ends there */
} mt_fit_state;

static const mt_ring_sample *sample_at(const mt_fit_state *f, int master, int k) {
    mt_link step = f->alignment->steps[k % f->alignment->count];
    return &f->samples[master]->samples[master == 0 ? step.a : step.b];
}

static bool waits(const mt_fit_state *f, int master, int k) {
    return sample_at(f, master, k) == sample_at(f, master, k + 1);
}

/* ---- extrema ----------------------------------------------------------------------------------------------- */

/* The number of steps from an extremum of one master, `first`, at step k to the same one of the other; 0: none. */
static int extremum_after(const mt_fit_state *f, int k, int *first) {
    *first = sample_at(f, 0, k)->extremum ? 0 : 1;
    const mt_ring_sample *here = sample_at(f, *first, k);
    if (!here->extremum || sample_at(f, 1 - *first, k)->extremum) return 0;
    for (int d = 1; d <= STEPS_APART && k + d < f->alignment->count; d++) {
        const mt_ring_sample *there = sample_at(f, 1 - *first, k + d), *along = sample_at(f, *first, k + d);
        if (along->corner || there->corner || (along->extremum && along != here)) return 0;
        if (there->extremum)
            return along != here && fabs(remainder(there->in - here->in, 2 * M_PI)) < SAME_HEADING ? d : 0;
    }
    return 0;
}

static void add_step(mt_alignment *made, mt_link step) {
    const mt_link *last = made->count ? &made->steps[made->count - 1] : NULL;
    if (!last || last->a != step.a || last->b != step.b) made->steps[made->count++] = step;
}

/* From step k to k + d: the master without extremum goes on to its own, then the other follows. */
static void add_detour(const mt_link *steps, int k, int d, int first, mt_alignment *made) {
    for (int i = k + 1; i <= k + d; i++)
        add_step(made, first == 0 ? (mt_link){steps[k].a, steps[i].b} : (mt_link){steps[i].a, steps[k].b});
    for (int i = k + 1; i <= k + d; i++)
        add_step(made,
                 first == 0 ? (mt_link){steps[i].a, steps[k + d].b} : (mt_link){steps[k + d].a, steps[i].b});
}

/* Pairs extrema that are some steps apart. */
static mt_status pair_extrema(mt_fit_state *f, mt_arena *arena, mt_alignment *made) {
    const mt_alignment *before = f->alignment;
    size_t room = (size_t)f->samples[0]->count + (size_t)f->samples[1]->count;
    *made = (mt_alignment){0, mt_arena_new(arena, room, sizeof(mt_link)), before->cost};
    if (!made->steps) return MT_NO_MEMORY;
    for (int k = 0, d, first; k < before->count; k += d ? d + 1 : 1) {
        add_step(made, before->steps[k]);
        d = extremum_after(f, k, &first);
        if (d > 0) add_detour(before->steps, k, d, first, made);
    }
    f->alignment = made;
    return MT_OK;
}

/* ---- ends of runs ---------------------------------------------------------------------------------------- */

static double length_between(const mt_fit_state *f, int master, int from, int to) {
    double length = 0;
    for (int k = from; k < to; k++) {
        const mt_ring_sample *p = sample_at(f, master, k), *q = sample_at(f, master, k + 1);
        length += mt_hypot(q->x - p->x, q->y - p->y);
    }
    return length;
}

/* Whether the other master has a corner at a step at which this one is at the sample of step k, the first or last of these steps; if the
 * other goes hardly anywhere meanwhile, only the first is. */
static bool partner_has_corner(const mt_fit_state *f, int master, int k, bool *first, bool *last) {
    int n = f->alignment->count, from = k + n, to = k + n;
    while (from > k && waits(f, master, from - 1)) from--;
    while (to < k + 2 * n && waits(f, master, to)) to++;
    *first = from == k + n;
    *last = to == k + n && length_between(f, 1 - master, from, to) >= mt_grid_units(WAIT_LEAST);
    for (int i = from; i <= to; i++)
        if (sample_at(f, 1 - master, i)->corner) return true;
    return false;
}

/* Whether step k is a corner of the contour. Where one ring waits at its corner until the other reaches one, only the step with both
 * is; where the other has none meanwhile, the first and the last step of waiting are. */
static bool is_corner(const mt_fit_state *f, int k) {
    bool in_a = sample_at(f, 0, k)->corner, in_b = sample_at(f, 1, k)->corner, first, last;
    if (in_a == in_b) return in_a;
    return !partner_has_corner(f, in_a ? 0 : 1, k, &first, &last) && (first || last);
}

/* Whether both rings follow a line from step k to the next. */
static bool is_line(const mt_fit_state *f, int k) {
    return (waits(f, 0, k) || sample_at(f, 0, k)->line) && (waits(f, 1, k) || sample_at(f, 1, k)->line);
}

/* Runs end at corners, and at both ends of a line that both rings follow for LINE_LEAST. */
static mt_status find_breaks(mt_fit_state *f, mt_arena *arena) {
    int n = f->alignment->count;
    f->breaks = mt_arena_new(arena, (size_t)n, sizeof(bool));
    if (!f->breaks) return MT_NO_MEMORY;
    for (int k = 0; k < n; k++) f->breaks[k] = is_corner(f, k);
    for (int k = 0; k < n; k++) {
        if (!is_line(f, k) || (is_line(f, k + n - 1) && !is_corner(f, k))) continue;
        int end = k + 1;
        while (end < k + n && is_line(f, end) && !is_corner(f, end % n)) end++;
        double least = mt_grid_units(LINE_LEAST);
        if (length_between(f, 0, k, end) < least || length_between(f, 1, k, end) < least) continue;
        f->breaks[k] = f->breaks[end % n] = true;
    }
    return MT_OK;
}

/* ---- runs -------------------------------------------------------------------------------------------------- */

static bool breaks(const mt_fit_state *f, int k) {
    return f->breaks[k % f->alignment->count];
}

static bool is_node(const mt_fit_state *f, int k) {
    return sample_at(f, 0, k)->extremum && sample_at(f, 1, k)->extremum;
}

static void sample_run(const mt_fit_state *f, int master, int first, int count, mt_sample *samples) {
    int arrival = count; /* from here on the ring waits at the run's end */
    while (arrival > 1 && sample_at(f, master, first + arrival - 1) == sample_at(f, master, first + count))
        arrival--;
    for (int k = 0; k <= count; k++) {
        const mt_ring_sample *sample = sample_at(f, master, first + k);
        double heading = k < arrival ? sample->out : sample->in;
        bool node = is_node(f, first + k) && !sample->breaks;
        samples[k] = mt_sample_at(sample->x, sample->y, heading, node);
    }
}

static mt_status fit_run(const mt_fit_state *f, int first, int count, double tolerance, mt_arena *arena,
                         mt_contour_pair *m, int *steps) {
    mt_sample *a = mt_arena_new(arena, (size_t)count + 1, sizeof *a);
    mt_sample *b = mt_arena_new(arena, (size_t)count + 1, sizeof *b);
    if (!a || !b) return MT_NO_MEMORY;
    sample_run(f, 0, first, count, a);
    sample_run(f, 1, first, count, b);
    const mt_sample *masters[] = {a, b};
    mt_segment *segments[] = {m->a.segments + m->a.count, m->b.segments + m->b.count};
    int made, *ends = steps + m->a.count;
    mt_status status = mt_spline(masters, 2, count + 1, tolerance, arena, segments, ends, &made);
    if (status != MT_OK) return status;
    for (int i = 0; i < made; i++) ends[i] += first;
    m->a.count += made;
    m->b.count += made;
    return MT_OK;
}

/* The step to begin at: a break or, on rings that are smooth all around, an extremum of both or the step at which the two headings
 * differ least. */
static int first_step(const mt_fit_state *f) {
    int best = 0;
    double least = INFINITY;
    for (int k = 0; k < f->alignment->count; k++) {
        if (breaks(f, k)) return k;
        double apart = fabs(remainder(sample_at(f, 0, k)->out - sample_at(f, 1, k)->out, 2 * M_PI));
        if (is_node(f, k)) apart -= 2 * M_PI;
        if (apart >= least) continue;
        least = apart;
        best = k;
    }
    return best;
}

/* The sample and the heading out of it at every step of the alignment, in both masters. */
static mt_status track_of(const mt_fit_state *f, mt_arena *arena, mt_track *track) {
    *track = (mt_track){.count = f->alignment->count};
    for (int m = 0; m < 2; m++) {
        mt_sample *samples = mt_arena_new(arena, (size_t)track->count, sizeof *samples);
        if (!samples) return MT_NO_MEMORY;
        for (int k = 0; k < track->count; k++) {
            const mt_ring_sample *sample = sample_at(f, m, k);
            samples[k] = mt_sample_at(sample->x, sample->y, sample->out, false);
        }
        track->samples[m] = samples;
    }
    return MT_OK;
}

/* ---- the work ----------------------------------------------------------------------------------------------- */

/* What a node costs that is passed over where nodes stand on one another, in steps of the arena. */
enum { STANDING_STEPS = 8 };

/* The sum of the squares of how many nodes stand on one another, in either master: looking for a neighbour passes over them. */
static int64_t standing2(const mt_contour_pair *masters) {
    int64_t sum = 0, run[2] = {1, 1};
    for (int i = 1; i < masters->a.count; i++)
        for (int m = 0; m < 2; m++) {
            const mt_segment *s = m ? masters->b.segments : masters->a.segments;
            run[m] = mt_point_equal(s[i - 1].end, s[i].end) ? run[m] + 1 : 1;
            sum += 2 * run[m] - 1;
        }
    return sum;
}

mt_status mt_contour_pair_fit(const mt_ring_samples *a, const mt_ring_samples *b,
                              const mt_alignment *alignment, double tolerance, mt_arena *arena,
                              mt_contour_pair *masters) {
    mt_fit_state f = {{a, b}, alignment, NULL};
    mt_alignment met;
    mt_status status = pair_extrema(&f, arena, &met);
    if (status == MT_OK) status = find_breaks(&f, arena);
    if (status != MT_OK) return status;
    int n = met.count, start = first_step(&f);
    mt_contour_pair made = {.a = {0, mt_arena_new(arena, (size_t)n, sizeof(mt_segment))},
                            .b = {0, mt_arena_new(arena, (size_t)n, sizeof(mt_segment))}};
    int *steps = mt_arena_new(arena, (size_t)n, sizeof *steps);
    if (!made.a.segments || !made.b.segments || !steps) return MT_NO_MEMORY;
    for (int done = 0; done < n;) {
        int count = 1;
        while (done + count < n && !breaks(&f, start + done + count)) count++;
        status = fit_run(&f, (start + done) % n, count, tolerance, arena, &made, steps);
        if (status != MT_OK) return status;
        done += count;
    }
    mt_track track;
    if (!mt_arena_spend(arena, STANDING_STEPS * standing2(&made))) return MT_TOO_LARGE;
    mt_contour_pair_tidy_lines(&made, steps, STRAIGHT_SHARE * tolerance);
    status = mt_contour_pair_smooth(&made, STRAIGHT_SHARE * tolerance, arena);
    if (status == MT_OK) status = track_of(&f, arena, &track);
    if (status == MT_OK) status = mt_chains_smooth(&track, steps, tolerance, arena, &made);
    assert(status != MT_OK || mt_contour_pair_is_valid(&made));
    if (status == MT_OK) *masters = made;
    return status;
}

/* How much of a displacement there is at weights of a and b; none past the ends. */
static int32_t displaced_by(int32_t a, int32_t b) {
    int32_t nearer = a < b ? a : b;
    return nearer > 0 ? 2 * nearer : 0;
}

static mt_point displacement_at(const mt_contour_pair *masters, mt_weights weights) {
    int32_t across = displaced_by(weights.a, weights.b),
            up = displaced_by(weights.a - weights.up, weights.b + weights.up);
    return mt_mix((mt_weights){MT_WEIGHT_ONE - across, across, up - across}, (mt_point){0, 0},
                  masters->displacement);
}

static mt_point moved(mt_point p, mt_point by) {
    return (mt_point){p.x + by.x, p.y + by.y};
}

mt_status mt_contour_pair_mix(const mt_contour_pair *masters, mt_weights weights, mt_arena *arena,
                              mt_contour *contour) {
    mt_contour made = {masters->a.count, mt_arena_new(arena, (size_t)masters->a.count, sizeof(mt_segment))};
    if (!made.segments) return MT_NO_MEMORY;
    mt_point displacement = displacement_at(masters, weights);
    for (int i = 0; i < made.count; i++) {
        const mt_segment *p = &masters->a.segments[i], *q = &masters->b.segments[i];
        made.segments[i] =
            (mt_segment){.degree = p->degree,
                         .control = {moved(mt_mix(weights, p->control[0], q->control[0]), displacement)},
                         .end = moved(mt_mix(weights, p->end, q->end), displacement)};
    }
    *contour = made;
    return MT_OK;
}

double mt_contour_pair_area(const mt_contour_pair *m) {
    double area = 0;
    for (int i = 0; i < m->a.count; i++) {
        const mt_segment *s = &m->a.segments[i], *t = &m->b.segments[i],
                         *u = &m->a.segments[(i + 1) % m->a.count], *v = &m->b.segments[(i + 1) % m->a.count];
        double px = s->end.x / 2.0 + t->end.x / 2.0, py = s->end.y / 2.0 + t->end.y / 2.0,
               qx = u->end.x / 2.0 + v->end.x / 2.0, qy = u->end.y / 2.0 + v->end.y / 2.0;
        area += (px * qy - py * qx) / 2;
    }
    return area;
}
