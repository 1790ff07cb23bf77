/* The edges of both control polygons go together, one by one. Two of the headings h and h', as unit vectors in their frames, cost
 * (1 − h·h') / 2, weighed by the mean of the shares that both edges have of their sides' boundaries. An edge without length on one side,
 * which grows out of a corner or goes into one, turns nothing. */
#include "morph/check/turning.h"

#include <math.h>

#include "arithmetic/angles.h"

/* An edge of a control polygon. */
typedef struct mt_heading {
    double length, x, y; /* grid units; a unit vector in the frame, or (0, 0) */
} mt_heading;

/* Of all contours: the boundaries' lengths, then what is summed. */
typedef struct mt_turns {
    const mt_frame *a, *b;
    double length_a, length_b;
    double sum;
} mt_turns;

static mt_heading heading_of(mt_point from, mt_point to, const mt_frame *frame) {
    double x = (double)to.x - from.x, y = (double)to.y - from.y;
    double u = frame->heading[0] * x + frame->heading[1] * y,
           v = frame->heading[2] * x + frame->heading[3] * y, length = mt_hypot(u, v);
    if (length == 0) return (mt_heading){0};
    return (mt_heading){mt_hypot(x, y), u / length, v / length};
}

/* Adds to the lengths, which are not known yet, or to the sum. */
static void add_edge(mt_turns *turns, const mt_heading *p, const mt_heading *q, bool known) {
    if (!known) {
        turns->length_a += p->length;
        turns->length_b += q->length;
    } else if (p->length > 0 && q->length > 0) {
        double share = (p->length / turns->length_a + q->length / turns->length_b) / 2;
        turns->sum += share * (1 - p->x * q->x - p->y * q->y) / 2;
    }
}

static void add_contour(mt_turns *turns, const mt_contour_pair *pair, bool known) {
    const mt_contour *a = &pair->a, *b = &pair->b;
    mt_point in_a = a->segments[a->count - 1].end, in_b = b->segments[b->count - 1].end;
    for (int i = 0; i < a->count; i++) {
        const mt_segment *p = &a->segments[i], *q = &b->segments[i];
        for (int k = 0; k < p->degree; k++) {
            mt_point to_a = k + 1 < p->degree ? p->control[k] : p->end,
                     to_b = k + 1 < p->degree ? q->control[k] : q->end;
            mt_heading here = heading_of(in_a, to_a, turns->a), there = heading_of(in_b, to_b, turns->b);
            add_edge(turns, &here, &there, known);
            in_a = to_a;
            in_b = to_b;
        }
    }
}

double mt_turning(const mt_morph *morph, const mt_frame *a, const mt_frame *b) {
    mt_turns turns = {.a = a, .b = b};
    for (int i = 0; i < morph->contour_count; i++) add_contour(&turns, &morph->contours[i], false);
    for (int i = 0; i < morph->contour_count; i++) add_contour(&turns, &morph->contours[i], true);
    return turns.sum;
}
