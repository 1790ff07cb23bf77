#include "morph/fit/smooth.h"

#include <math.h>
#include <string.h>

#include "geometry/limits.h"

/* A master that turns by no more than so many degrees at a node runs through it smoothly. */
#define SMOOTH_TURN 4.0
/* A kink that turns by less than so many degrees half-way is let be. */
#define KINK_TURN 0.5
/* A line or a handle keeps so much of its length, in one of the masters at least, 1/1000 em. */
#define HANDLE_LEAST 2.0
/* Nodes are moved in so many rounds, since a line's end is its neighbour's handle. */
enum { ROUNDS = 3, SAMPLES = 8, STEPS = 8 };

typedef struct mt_vector {
    double x, y;
} mt_vector;

/* A node between two segments of one master: where the handle on either side of it ends. */
typedef struct mt_hinge {
    mt_vector before, at, after;
} mt_hinge;

static mt_vector place(mt_point p) {
    return (mt_vector){p.x, p.y};
}

static mt_vector between(mt_vector p, mt_vector q, double share) {
    return (mt_vector){p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)};
}

static double distance2(mt_vector p, mt_vector q) {
    return (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y);
}

static double distance(mt_vector p, mt_vector q) {
    return sqrt(distance2(p, q));
}

static mt_segment *segment_at(const mt_contour *contour, int k) {
    return &contour->segments[(k + contour->count) % contour->count];
}

static mt_hinge hinge_at(const mt_contour *contour, int k) {
    const mt_segment *in = segment_at(contour, k), *out = segment_at(contour, k + 1);
    mt_point before = in->degree == 2 ? in->control[0] : segment_at(contour, k - 1)->end;
    mt_point after = out->degree == 2 ? out->control[0] : out->end;
    return (mt_hinge){place(before), place(in->end), place(after)};
}

/* By how many degrees the path through three places turns at the second; 0 where one side has no length. */
static double turn(mt_hinge h) {
    double ax = h.at.x - h.before.x, ay = h.at.y - h.before.y, bx = h.after.x - h.at.x,
           by = h.after.y - h.at.y;
    return fabs(atan2(ax * by - ay * bx, ax * bx + ay * by)) * (180 / M_PI);
}

/* ---- whether there is a kink ------------------------------------------------------------------------------ */

/* The direction in which a master waits before or after a node is that in which it came there or will go on. */
bool mt_is_smooth(const mt_contour *contour, int k) {
    mt_hinge h = hinge_at(contour, k);
    for (int i = 1; i < contour->count && distance(h.before, h.at) == 0; i++)
        h.before = hinge_at(contour, k - i).before;
    for (int i = 1; i < contour->count && distance(h.at, h.after) == 0; i++)
        h.after = hinge_at(contour, k + i).after;
    return turn(h) <= SMOOTH_TURN;
}

static double turn_between(mt_hinge a, mt_hinge b, double share) {
    return turn((mt_hinge){between(a.before, b.before, share), between(a.at, b.at, share),
                           between(a.after, b.after, share)});
}

double mt_kink(const mt_contour *const masters[2], int k) {
    if (!mt_is_smooth(masters[0], k) || !mt_is_smooth(masters[1], k)) return 0;
    mt_hinge a = hinge_at(masters[0], k), b = hinge_at(masters[1], k);
    double most = 0;
    for (int i = 1; i < STEPS; i++) most = fmax(most, turn_between(a, b, (double)i / STEPS));
    return most;
}

/* ---- what moving a node does ------------------------------------------------------------------------------ */

static mt_vector on_segment(mt_vector start, const mt_segment *segment, double u) {
    mt_vector end = place(segment->end);
    if (segment->degree == 1) return between(start, end, u);
    mt_vector control = place(segment->control[0]);
    return between(between(start, control, u), between(control, end, u), u);
}

static double distance2_to_chord(mt_vector p, mt_vector a, mt_vector b) {
    double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    double u = length2 > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / length2 : 0;
    return distance2(p, u <= 0 ? a : u >= 1 ? b : between(a, b, u));
}

/* How far a place is from the drawing between nodes k - 2 and k + 2. */
static double distance_to_drawing(const mt_contour *drawn, int k, mt_vector p) {
    double least = INFINITY;
    for (int i = k - 1; i <= k + 2; i++) {
        mt_vector start = place(segment_at(drawn, i - 1)->end), last = start;
        for (int s = 1; s <= SAMPLES; s++) {
            mt_vector next = on_segment(start, segment_at(drawn, i), (double)s / SAMPLES);
            double here = distance2_to_chord(p, last, next);
            if (here < least) least = here;
            last = next;
        }
    }
    return sqrt(least);
}

/* How far the two segments at node k depart from the drawing when the node stands at `at`. */
static double departure(const mt_contour *drawn, const mt_contour *contour, int k, mt_vector at) {
    mt_segment in = *segment_at(contour, k), out = *segment_at(contour, k + 1);
    mt_vector start = place(segment_at(contour, k - 1)->end);
    double worst = 0;
    in.end = (mt_point){(int32_t)lround(at.x), (int32_t)lround(at.y)};
    for (int s = 1; s < SAMPLES; s++) {
        double u = (double)s / SAMPLES;
        worst = fmax(worst, distance_to_drawing(drawn, k, on_segment(start, &in, u)));
        worst = fmax(worst, distance_to_drawing(drawn, k, on_segment(place(in.end), &out, u)));
    }
    return worst;
}

/* ---- moving ----------------------------------------------------------------------------------------------- */

/* Whether a handle at a node would be shorter than HANDLE_LEAST in both masters, with the node at `at`. */
static bool is_used_up(const mt_hinge hinges[2], const mt_vector at[2]) {
    double before = 0, after = 0;
    for (int m = 0; m < 2; m++) {
        before = fmax(before, distance(hinges[m].before, at[m]));
        after = fmax(after, distance(at[m], hinges[m].after));
    }
    return fmin(before, after) < mt_grid_units(HANDLE_LEAST);
}

static double share_of(mt_hinge h) {
    double in = distance(h.before, h.at), out = distance(h.at, h.after);
    return in + out > 0 ? in / (in + out) : 0.5;
}

/* Moves node k to the share of the way between its handles' ends that costs the least departure; nowhere, where all
 * are too much. The mean of both masters' shares comes first, so that neither master is preferred. */
static void move_node(const mt_contour *const drawn[2], mt_contour *const masters[2], int k,
                      double tolerance) {
    mt_hinge hinges[2] = {hinge_at(masters[0], k), hinge_at(masters[1], k)};
    double a = share_of(hinges[0]), b = share_of(hinges[1]), shares[3] = {(a + b) / 2, a, b};
    double least = INFINITY;
    mt_vector best[2];
    for (int i = 0; i < 3; i++) {
        mt_vector at[2];
        double worst = 0;
        for (int m = 0; m < 2; m++) {
            at[m] = between(hinges[m].before, hinges[m].after, shares[i]);
            worst = fmax(worst, departure(drawn[m], masters[m], k, at[m]));
        }
        if (worst > tolerance || worst >= least || is_used_up(hinges, at)) continue;
        least = worst;
        memcpy(best, at, sizeof best);
    }
    for (int m = 0; m < 2 && least < INFINITY; m++)
        segment_at(masters[m], k)->end = (mt_point){(int32_t)lround(best[m].x), (int32_t)lround(best[m].y)};
}

static mt_status copy(const mt_contour *contour, mt_arena *arena, mt_contour *made) {
    *made = (mt_contour){contour->count, mt_arena_new(arena, (size_t)contour->count, sizeof *made->segments)};
    if (!made->segments) return MT_NO_MEMORY;
    memcpy(made->segments, contour->segments, (size_t)contour->count * sizeof *made->segments);
    return MT_OK;
}

mt_status mt_contour_pair_smooth(mt_contour_pair *masters, double tolerance, mt_arena *arena) {
    mt_contour drawn[2], *moved[2] = {&masters->a, &masters->b};
    mt_status status = copy(&masters->a, arena, &drawn[0]);
    if (status == MT_OK) status = copy(&masters->b, arena, &drawn[1]);
    if (status != MT_OK || masters->a.count < 3) return status;
    const mt_contour *const before[2] = {&drawn[0], &drawn[1]}, *const now[2] = {&masters->a, &masters->b};
    for (int round = 0; round < ROUNDS; round++)
        for (int k = 0; k < masters->a.count; k++)
            if (mt_kink(now, k) > KINK_TURN) move_node(before, moved, k, tolerance);
    return MT_OK;
}
