#include "morph/masters.h"

#include <math.h>

#include "geometry/spline.h"

typedef struct mt_weave {
    const mt_stops *stops[2];
    const mt_alignment *alignment;
} mt_weave;

static const mt_stop *stop_at(const mt_weave *w, int master, int k) {
    mt_link step = w->alignment->steps[k % w->alignment->count];
    return &w->stops[master]->stops[master == 0 ? step.a : step.b];
}

static bool waits(const mt_weave *w, int master, int k) {
    return stop_at(w, master, k + w->alignment->count) == stop_at(w, master, k + w->alignment->count - 1);
}

/* Whether the run in hand ends at step k: where a ring has a corner, or a line's end, and is not waiting
 * there on both sides. */
static bool breaks(const mt_weave *w, int k) {
    for (int master = 0; master < 2; master++)
        if (stop_at(w, master, k)->breaks && !(waits(w, master, k) && waits(w, master, k + 1))) return true;
    return false;
}

static bool is_node(const mt_weave *w, int k) {
    return stop_at(w, 0, k)->extremum && stop_at(w, 1, k)->extremum;
}

static void sample_run(const mt_weave *w, int master, int first, int count, mt_sample *samples) {
    for (int k = 0; k <= count; k++) {
        const mt_stop *stop = stop_at(w, master, first + k);
        double heading = k < count ? stop->out : stop->in;
        bool node = is_node(w, first + k) && !stop->breaks;
        samples[k] = mt_sample_at(stop->x, stop->y, heading, node);
    }
}

static mt_status fit_run(const mt_weave *w, int first, int count, double tolerance, mt_arena *arena,
                         mt_masters *m) {
    mt_sample *a = mt_arena_new(arena, (size_t)count + 1, sizeof *a);
    mt_sample *b = mt_arena_new(arena, (size_t)count + 1, sizeof *b);
    if (!a || !b) return MT_NO_MEMORY;
    sample_run(w, 0, first, count, a);
    sample_run(w, 1, first, count, b);
    const mt_sample *masters[] = {a, b};
    mt_segment *segments[] = {m->a.segments + m->a.count, m->b.segments + m->b.count};
    int made;
    mt_status status = mt_spline(masters, 2, count + 1, tolerance, arena, segments, &made);
    if (status != MT_OK) return status;
    m->a.count += made;
    m->b.count += made;
    return MT_OK;
}

/* Where to begin: at a break or, on rings that are smooth all around, at an extremum of both or where both
 * head most nearly the same way. */
static int first_step(const mt_weave *w) {
    int best = 0;
    double least = INFINITY;
    for (int k = 0; k < w->alignment->count; k++) {
        if (breaks(w, k)) return k;
        double apart = fabs(remainder(stop_at(w, 0, k)->out - stop_at(w, 1, k)->out, 2 * M_PI));
        if (is_node(w, k)) apart -= 2 * M_PI;
        if (apart >= least) continue;
        least = apart;
        best = k;
    }
    return best;
}

mt_status mt_masters_fit(const mt_stops *a, const mt_stops *b, const mt_alignment *alignment,
                         double tolerance, mt_arena *arena, mt_masters *masters) {
    mt_weave w = {{a, b}, alignment};
    int n = alignment->count, start = first_step(&w);
    mt_masters made = {.a = {0, mt_arena_new(arena, (size_t)n, sizeof(mt_segment))},
                       .b = {0, mt_arena_new(arena, (size_t)n, sizeof(mt_segment))}};
    if (!made.a.segments || !made.b.segments) return MT_NO_MEMORY;
    for (int done = 0; done < n;) {
        int count = 1;
        while (done + count < n && !breaks(&w, start + done + count)) count++;
        mt_status status = fit_run(&w, (start + done) % n, count, tolerance, arena, &made);
        if (status != MT_OK) return status;
        done += count;
    }
    *masters = made;
    return MT_OK;
}

/* How far the contour stands aside at these weights. */
static mt_point aside_at(const mt_masters *masters, mt_weights weights) {
    mt_weights share = {0, 2 * (weights.a < weights.b ? weights.a : weights.b)};
    share.a = MT_WEIGHT_ONE - share.b;
    return mt_mix(share, (mt_point){0, 0}, masters->aside);
}

static mt_point moved(mt_point p, mt_point by) {
    return (mt_point){p.x + by.x, p.y + by.y};
}

mt_status mt_masters_mix(const mt_masters *masters, mt_weights weights, mt_arena *arena,
                         mt_contour *contour) {
    mt_contour made = {masters->a.count, mt_arena_new(arena, (size_t)masters->a.count, sizeof(mt_segment))};
    if (!made.segments) return MT_NO_MEMORY;
    mt_point aside = aside_at(masters, weights);
    for (int i = 0; i < made.count; i++) {
        const mt_segment *p = &masters->a.segments[i], *q = &masters->b.segments[i];
        made.segments[i] =
            (mt_segment){.degree = p->degree,
                         .control = {moved(mt_mix(weights, p->control[0], q->control[0]), aside)},
                         .end = moved(mt_mix(weights, p->end, q->end), aside)};
    }
    *contour = made;
    return MT_OK;
}
