#include "morph/fit/contour_pair.h"

#include <math.h>

#include "geometry/limits.h"
#include "geometry/spline.h"
#include "morph/fit/chains.h"
#include "morph/fit/lines.h"
#include "morph/fit/smooth.h"

/* Of the tolerance: what is within it of a line is that line. */
#define STRAIGHT_SHARE 0.1
/* Where both rings have a line of so much length, 1/1000 em, it stays one. */
#define LINE_LEAST 30.0

/* An extremum of the one master goes with one of the other's that is so many steps further, at most, and heads alike within so
 * many radians. */
enum { REACH = 6 };
#define SAME_HEADING 0.5

typedef struct mt_fit_state {
    const mt_ring_samples *samples[2];
    const mt_alignment *alignment;
    bool *breaks; /* at each step: whether the run in hand ends there */
} mt_fit_state;

static const mt_ring_sample *sample_at(const mt_fit_state *w, int master, int k) {
    mt_link step = w->alignment->steps[k % w->alignment->count];
    return &w->samples[master]->samples[master == 0 ? step.a : step.b];
}

static bool waits(const mt_fit_state *w, int master, int k) {
    return sample_at(w, master, k) == sample_at(w, master, k + 1);
}

/* ---- extrema ----------------------------------------------------------------------------------------------- */

/* Whether one master has an extremum at step k and the other the same one some steps later: how many; 0 where not. */
static int extremum_after(const mt_fit_state *w, int k, int *first) {
    *first = sample_at(w, 0, k)->extremum ? 0 : 1;
    const mt_ring_sample *here = sample_at(w, *first, k);
    if (!here->extremum || sample_at(w, 1 - *first, k)->extremum) return 0;
    for (int d = 1; d <= REACH && k + d < w->alignment->count; d++) {
        const mt_ring_sample *there = sample_at(w, 1 - *first, k + d), *along = sample_at(w, *first, k + d);
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

/* From step k to k + d with master `first` waiting until the other has come, and then the other way round. */
static void add_meeting(const mt_link *steps, int k, int d, int first, mt_alignment *made) {
    for (int i = k + 1; i <= k + d; i++)
        add_step(made, first == 0 ? (mt_link){steps[k].a, steps[i].b} : (mt_link){steps[i].a, steps[k].b});
    for (int i = k + 1; i <= k + d; i++)
        add_step(made,
                 first == 0 ? (mt_link){steps[i].a, steps[k + d].b} : (mt_link){steps[k + d].a, steps[i].b});
}

/* Lets extrema go with each other that are some steps apart. */
static mt_status meet_extrema(mt_fit_state *w, mt_arena *arena, mt_alignment *made) {
    const mt_alignment *before = w->alignment;
    size_t room = (size_t)w->samples[0]->count + (size_t)w->samples[1]->count;
    *made = (mt_alignment){0, mt_arena_new(arena, room, sizeof(mt_link)), before->cost};
    if (!made->steps) return MT_NO_MEMORY;
    for (int k = 0, d, first; k < before->count; k += d ? d + 1 : 1) {
        add_step(made, before->steps[k]);
        d = extremum_after(w, k, &first);
        if (d > 0) add_meeting(before->steps, k, d, first, made);
    }
    w->alignment = made;
    return MT_OK;
}

/* ---- where runs end ---------------------------------------------------------------------------------------- */

/* Whether the ring of the other master has a corner while this one waits at the sample of step k. */
static bool is_met(const mt_fit_state *w, int master, int k, bool *first, bool *last) {
    int n = w->alignment->count, from = k + n, to = k + n;
    while (from > k && waits(w, master, from - 1)) from--;
    while (to < k + 2 * n && waits(w, master, to)) to++;
    *first = from == k + n;
    *last = to == k + n;
    for (int i = from; i <= to; i++)
        if (sample_at(w, 1 - master, i)->corner) return true;
    return false;
}

/* Whether a ring has a corner at step k. A ring that waits there does so for the other's, if that has one meanwhile: then they
 * are one, and it is there alone. Otherwise it is where the waiting begins and where it is over. */
static bool is_corner(const mt_fit_state *w, int k) {
    bool in_a = sample_at(w, 0, k)->corner, in_b = sample_at(w, 1, k)->corner, first, last;
    if (in_a == in_b) return in_a;
    return !is_met(w, in_a ? 0 : 1, k, &first, &last) && (first || last);
}

/* Whether both rings follow a line from step k to the next. */
static bool is_line(const mt_fit_state *w, int k) {
    return (waits(w, 0, k) || sample_at(w, 0, k)->line) && (waits(w, 1, k) || sample_at(w, 1, k)->line);
}

static double length_between(const mt_fit_state *w, int master, int from, int to) {
    double length = 0;
    for (int k = from; k < to; k++) {
        const mt_ring_sample *p = sample_at(w, master, k), *q = sample_at(w, master, k + 1);
        length += hypot(q->x - p->x, q->y - p->y);
    }
    return length;
}

/* Runs end at corners, and where both rings begin or end to follow a line that is long enough to be seen. */
static mt_status find_breaks(mt_fit_state *w, mt_arena *arena) {
    int n = w->alignment->count;
    w->breaks = mt_arena_new(arena, (size_t)n, sizeof(bool));
    if (!w->breaks) return MT_NO_MEMORY;
    for (int k = 0; k < n; k++) w->breaks[k] = is_corner(w, k);
    for (int k = 0; k < n; k++) {
        if (!is_line(w, k) || (is_line(w, k + n - 1) && !is_corner(w, k))) continue;
        int end = k + 1;
        while (end < k + n && is_line(w, end) && !is_corner(w, end % n)) end++;
        double least = mt_grid_units(LINE_LEAST);
        if (length_between(w, 0, k, end) < least || length_between(w, 1, k, end) < least) continue;
        w->breaks[k] = w->breaks[end % n] = true;
    }
    return MT_OK;
}

/* ---- runs -------------------------------------------------------------------------------------------------- */

static bool breaks(const mt_fit_state *w, int k) {
    return w->breaks[k % w->alignment->count];
}

static bool is_node(const mt_fit_state *w, int k) {
    return sample_at(w, 0, k)->extremum && sample_at(w, 1, k)->extremum;
}

static void sample_run(const mt_fit_state *w, int master, int first, int count, mt_sample *samples) {
    int arrival = count; /* from here on the ring waits at the run's end */
    while (arrival > 1 && sample_at(w, master, first + arrival - 1) == sample_at(w, master, first + count))
        arrival--;
    for (int k = 0; k <= count; k++) {
        const mt_ring_sample *sample = sample_at(w, master, first + k);
        double heading = k < arrival ? sample->out : sample->in;
        bool node = is_node(w, first + k) && !sample->breaks;
        samples[k] = mt_sample_at(sample->x, sample->y, heading, node);
    }
}

static mt_status fit_run(const mt_fit_state *w, int first, int count, double tolerance, mt_arena *arena,
                         mt_contour_pair *m, int *steps) {
    mt_sample *a = mt_arena_new(arena, (size_t)count + 1, sizeof *a);
    mt_sample *b = mt_arena_new(arena, (size_t)count + 1, sizeof *b);
    if (!a || !b) return MT_NO_MEMORY;
    sample_run(w, 0, first, count, a);
    sample_run(w, 1, first, count, b);
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

/* Where to begin: at a break or, on rings that are smooth all around, at an extremum of both or where both
 * head most nearly the same way. */
static int first_step(const mt_fit_state *w) {
    int best = 0;
    double least = INFINITY;
    for (int k = 0; k < w->alignment->count; k++) {
        if (breaks(w, k)) return k;
        double apart = fabs(remainder(sample_at(w, 0, k)->out - sample_at(w, 1, k)->out, 2 * M_PI));
        if (is_node(w, k)) apart -= 2 * M_PI;
        if (apart >= least) continue;
        least = apart;
        best = k;
    }
    return best;
}

/* Every step of the alignment, in both masters, as it goes on from there. */
static mt_status track_of(const mt_fit_state *w, mt_arena *arena, mt_track *track) {
    *track = (mt_track){.count = w->alignment->count};
    for (int m = 0; m < 2; m++) {
        mt_sample *samples = mt_arena_new(arena, (size_t)track->count, sizeof *samples);
        if (!samples) return MT_NO_MEMORY;
        for (int k = 0; k < track->count; k++) {
            const mt_ring_sample *sample = sample_at(w, m, k);
            samples[k] = mt_sample_at(sample->x, sample->y, sample->out, false);
        }
        track->samples[m] = samples;
    }
    return MT_OK;
}

mt_status mt_contour_pair_fit(const mt_ring_samples *a, const mt_ring_samples *b,
                              const mt_alignment *alignment, double tolerance, mt_arena *arena,
                              mt_contour_pair *masters) {
    mt_fit_state w = {{a, b}, alignment, NULL};
    mt_alignment met;
    mt_status status = meet_extrema(&w, arena, &met);
    if (status == MT_OK) status = find_breaks(&w, arena);
    if (status != MT_OK) return status;
    int n = met.count, start = first_step(&w);
    mt_contour_pair made = {.a = {0, mt_arena_new(arena, (size_t)n, sizeof(mt_segment))},
                            .b = {0, mt_arena_new(arena, (size_t)n, sizeof(mt_segment))}};
    int *steps = mt_arena_new(arena, (size_t)n, sizeof *steps);
    if (!made.a.segments || !made.b.segments || !steps) return MT_NO_MEMORY;
    for (int done = 0; done < n;) {
        int count = 1;
        while (done + count < n && !breaks(&w, start + done + count)) count++;
        status = fit_run(&w, (start + done) % n, count, tolerance, arena, &made, steps);
        if (status != MT_OK) return status;
        done += count;
    }
    mt_track track;
    mt_contour_pair_tidy_lines(&made, steps, STRAIGHT_SHARE * tolerance);
    status = mt_contour_pair_smooth(&made, STRAIGHT_SHARE * tolerance, arena);
    if (status == MT_OK) status = track_of(&w, arena, &track);
    if (status == MT_OK) status = mt_chains_smooth(&track, steps, tolerance, arena, &made);
    if (status == MT_OK) *masters = made;
    return status;
}

/* How far the contour stands aside at these weights. */
static mt_point displacement_at(const mt_contour_pair *masters, mt_weights weights) {
    mt_weights share = {0, 2 * (weights.a < weights.b ? weights.a : weights.b)};
    share.a = MT_WEIGHT_ONE - share.b;
    return mt_mix(share, (mt_point){0, 0}, masters->displacement);
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
