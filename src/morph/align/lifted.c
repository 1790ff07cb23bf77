/* Views and weights of a ring's samples. A sample that turns by more than FAN_STEP has 2 + turn / FAN_STEP views at its place, whose
 * headings lead evenly from in to out; any other has one. The stretch between two views has the lifted length
 * LENGTH_SHARE · length / ring's length + (1 − LENGTH_SHARE) · turning / 2π. Invariant: the weights sum to 1. O(n). */
#include "morph/align/lifted.h"

#include <math.h>

#include "arithmetic/angles.h"

/* Radians: what a sample turns by to be seen as a fan, and how far the views of a fan are apart, at most. */
#define FAN_STEP (M_PI / 5)
#define LENGTH_SHARE 0.5 /* of the lifted length that is length; the rest is turning */

static double turn_of(const mt_ring_sample *sample) {
    return remainder(sample->out - sample->in, 2 * M_PI);
}

/* How many views there are of a sample beside its first. */
static int more_views(const mt_ring_sample *sample) {
    double turn = fabs(turn_of(sample));
    return turn > FAN_STEP ? 1 + (int)(turn / FAN_STEP) : 0;
}

/* How far a corner turns as its frame shows it: the same way round as in the drawing. */
static double turn_seen(const mt_sample_view *view, double drawn) {
    double turn = mt_atan2(view->in_x * view->out_y - view->in_y * view->out_x,
                           view->in_x * view->out_x + view->in_y * view->out_y);
    return turn * drawn >= 0 ? turn : turn + (drawn > 0 ? 2 : -2) * M_PI;
}

static void add_views(const mt_ring_samples *samples, int i, const mt_frame *frame, mt_lifted_ring *lifted) {
    const mt_ring_sample *sample = &samples->samples[i];
    mt_sample_view whole = mt_sample_view_of(sample, frame);
    int more = more_views(sample);
    double in = mt_atan2(whole.in_y, whole.in_x), turn = more > 0 ? turn_seen(&whole, turn_of(sample)) : 0;
    for (int k = 0; k <= more; k++) {
        mt_sample_view view = whole;
        if (more > 0) {
            view.in_x = view.out_x = mt_cos(in + turn * k / more);
            view.in_y = view.out_y = mt_sin(in + turn * k / more);
        }
        lifted->of[lifted->count] = i;
        lifted->views[lifted->count++] = view;
    }
}

static double ring_length(const mt_ring_samples *samples) {
    double length = 0;
    for (int i = 0; i < samples->count; i++) {
        const mt_ring_sample *p = &samples->samples[i], *q = &samples->samples[(i + 1) % samples->count];
        length += mt_hypot(q->x - p->x, q->y - p->y);
    }
    return length;
}

static double turn_between(const mt_sample_view *p, const mt_sample_view *q) {
    return fabs(mt_atan2(p->out_x * q->in_y - p->out_y * q->in_x, p->out_x * q->in_x + p->out_y * q->in_y));
}

/* The stretch from each view to the next weighs half for the one and half for the other. */
static void weigh(const mt_ring_samples *samples, mt_lifted_ring *lifted) {
    double whole = ring_length(samples), sum = 0;
    for (int i = 0; i < lifted->count; i++) {
        int next = (i + 1) % lifted->count;
        const mt_ring_sample *p = &samples->samples[lifted->of[i]], *q = &samples->samples[lifted->of[next]];
        double length = mt_hypot(q->x - p->x, q->y - p->y) / whole,
               turn = turn_between(&lifted->views[i], &lifted->views[next]) / (2 * M_PI);
        double half = (LENGTH_SHARE * length + (1 - LENGTH_SHARE) * turn) / 2;
        lifted->weight[i] += (float)half;
        lifted->weight[next] += (float)half;
    }
    for (int i = 0; i < lifted->count; i++) sum += lifted->weight[i];
    for (int i = 0; i < lifted->count; i++) lifted->weight[i] /= (float)sum;
}

mt_status mt_lift_ring(const mt_ring_samples *samples, const mt_frame *frame, mt_arena *arena,
                       mt_lifted_ring *lifted) {
    size_t room = 0;
    for (int i = 0; i < samples->count; i++) room += 1 + (size_t)more_views(&samples->samples[i]);
    mt_lifted_ring made = {.views = mt_arena_new(arena, room, sizeof *made.views),
                           .of = mt_arena_new(arena, room, sizeof *made.of),
                           .weight = mt_arena_new(arena, room, sizeof *made.weight)};
    if (!made.views || !made.of || !made.weight) return MT_NO_MEMORY;
    for (int i = 0; i < samples->count; i++) add_views(samples, i, frame, &made);
    weigh(samples, &made);
    *lifted = made;
    return MT_OK;
}
