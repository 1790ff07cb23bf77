/* Samples of a ring: its vertices, and places between them on the curve that each chord stands for.
 *
 *         b.in ↗ ●      the chord a b with the headings a.out and b.in: where they turn by less than a right angle
 *       ╭──────╯  b     and the same way, and the quadratic with these tangents keeps within twice the flatness,
 *     a ●               a sample lies on that quadratic and heads along it; otherwise on the straight edge
 *
 * Invariant: samples stand in the ring's order, and each vertex is one. O(n + length / step). */
#include "morph/align/samples.h"

#include <math.h>

#include "arithmetic/angles.h"
#include "geometry/limits.h"

static mt_ring_sample vertex_sample(const mt_trace *t, int i) {
    return (mt_ring_sample){t->ring.points[i].x,     t->ring.points[i].y, mt_trace_in(t, i),
                            mt_trace_out(t, i),      t->corner[i],        mt_trace_breaks(t, i),
                            mt_trace_extremum(t, i), t->line[i]};
}

static double angle_between(double from, double to) {
    return remainder(to - from, 2 * M_PI);
}

/* The sample at fraction s of the edge from a to b. */
static mt_ring_sample sample_between(const mt_ring_sample *a, const mt_ring_sample *b, bool line,
                                     double flatness, double s) {
    double dx = b->x - a->x, dy = b->y - a->y, heading = mt_atan2(dy, dx);
    mt_ring_sample sample = {a->x + s * dx, a->y + s * dy, heading, heading, false, false, false, line};
    double turn = angle_between(a->out, b->in), off = angle_between(a->out, heading);
    if (line || off * turn <= 0 || fabs(off) >= fabs(turn) || fabs(turn) > M_PI / 2) return sample;
    double reach = mt_hypot(dx, dy) * mt_sin(turn - off) / mt_sin(turn); /* from a to the control point */
    if (reach * fabs(mt_sin(off)) / 2 > 2 * flatness) return sample;
    double cx = reach * mt_cos(a->out), cy = reach * mt_sin(a->out);
    sample.x = a->x + 2 * s * (1 - s) * cx + s * s * dx;
    sample.y = a->y + 2 * s * (1 - s) * cy + s * s * dy;
    sample.in = sample.out = mt_atan2((1 - s) * cy + s * (dy - cy), (1 - s) * cx + s * (dx - cx));
    return sample;
}

static int parts_of(const mt_trace *t, int i, double step) {
    return 1 + (int)(t->length[i] / step);
}

mt_status mt_ring_samples_of(const mt_trace *t, double flatness, double step, mt_arena *arena,
                             mt_ring_samples *samples) {
    int64_t total = 0;
    for (int i = 0; i < t->ring.count; i++) total += parts_of(t, i, step);
    if (total > MT_POINTS_MAX) return MT_TOO_LARGE;
    mt_ring_samples made = {0, mt_arena_new(arena, (size_t)total, sizeof(mt_ring_sample))};
    if (!made.samples) return MT_NO_MEMORY;
    for (int i = 0; i < t->ring.count; i++) {
        mt_ring_sample a = vertex_sample(t, i), b = vertex_sample(t, mt_trace_after(t, i));
        int parts = parts_of(t, i, step);
        made.samples[made.count++] = a;
        for (int k = 1; k < parts; k++)
            made.samples[made.count++] = sample_between(&a, &b, t->line[i], flatness, (double)k / parts);
    }
    *samples = made;
    return MT_OK;
}

mt_status mt_ring_samples_at_least(const mt_ring *ring, double flatness, double least, mt_arena *arena,
                                   mt_ring_samples *samples) {
    mt_trace trace;
    mt_status status = mt_trace_ring(ring, flatness, arena, &trace);
    double step = fmax(1, mt_ring_length(ring) / least);
    return status == MT_OK ? mt_ring_samples_of(&trace, flatness, step, arena, samples) : status;
}
