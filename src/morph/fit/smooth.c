/* Nodes without kinks in between, by moving them. A node k lies between two handles; where both masters are smooth there but head
 * differently, a mix of them turns at the node, unless the handles have the same ratio in both:
 *
 *     before ○───●──────○ after      A: ratio 1 : 2        mixed handles are in line for every T, since
 *             ○                      B: ratio 1 : 2        node = before + share · (after − before)
 *              ╲●╲                                         with the same share in both masters
 *                 ○
 *
 * Nodes are moved along their own tangents to a common share (the mean of both, A's, or B's: the one that costs least), where no master
 * departs from its drawing by more than the tolerance, and a handle of HANDLE_LEAST remains. Invariants: segments keep their number and
 * order, control points their places; swapping A and B swaps the result. O(ROUNDS · n). */
#include "morph/fit/smooth.h"

#include <math.h>
#include <string.h>

#include "arithmetic/angles.h"
#include "geometry/limits.h"

/* A master that turns by no more than this at a node is smooth there, degrees. */
#define SMOOTH_TURN 4.0
/* A line or a handle is left at least this long in one of the masters, 1/1000 em. */
#define HANDLE_LEAST 2.0
/* Nodes are moved in ROUNDS, since a line's end is its neighbour's handle; SAMPLES of a curve measure how far it departs, and STEPS
 * places between the masters its kink. */
enum { ROUNDS = 3, SAMPLES = 8, STEPS = 8 };
/* Chords that a node's places are held against, in three tries and two masters: the work of a move (base/memory.h). */
enum { MOVE_STEPS = 3 * 2 * 2 * (SAMPLES - 1) * 4 * SAMPLES };

/* A node of one master, and the ends of the handles on both sides. */
typedef struct mt_node_handles {
    mt_vector before, at, after;
} mt_node_handles;

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

static mt_node_handles handles_at(const mt_contour *contour, int k) {
    const mt_segment *in = segment_at(contour, k), *out = segment_at(contour, k + 1);
    mt_point before = in->degree == 2 ? in->control[0] : segment_at(contour, k - 1)->end;
    mt_point after = out->degree == 2 ? out->control[0] : out->end;
    return (mt_node_handles){place(before), place(in->end), place(after)};
}

/* The turn of the path through three places at the second, degrees; 0 where one side has no length. */
static double turn(mt_node_handles h) {
    double ax = h.at.x - h.before.x, ay = h.at.y - h.before.y, bx = h.after.x - h.at.x,
           by = h.after.y - h.at.y;
    return fabs(mt_atan2(ax * by - ay * bx, ax * bx + ay * by)) * (180 / M_PI);
}

/* ---- kinks ------------------------------------------------------------------------------ */

bool mt_is_smooth(const mt_contour *contour, int k) {
    mt_node_handles h = handles_at(contour, k);
    for (int i = 1; i < contour->count && distance(h.before, h.at) == 0; i++)
        h.before = handles_at(contour, k - i).before;
    for (int i = 1; i < contour->count && distance(h.at, h.after) == 0; i++)
        h.after = handles_at(contour, k + i).after;
    return turn(h) <= SMOOTH_TURN;
}

static double turn_between(mt_node_handles a, mt_node_handles b, double share) {
    return turn((mt_node_handles){between(a.before, b.before, share), between(a.at, b.at, share),
                                  between(a.after, b.after, share)});
}

double mt_kink(const mt_contour *const masters[2], int k) {
    if (!mt_is_smooth(masters[0], k) || !mt_is_smooth(masters[1], k)) return 0;
    mt_node_handles a = handles_at(masters[0], k), b = handles_at(masters[1], k);
    double most = 0;
    for (int i = 1; i < STEPS; i++) most = fmax(most, turn_between(a, b, (double)i / STEPS));
    return most;
}

/* ---- effect of moving a node ------------------------------------------------------------------------------ */

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

/* The distance of a place from the drawing between nodes k - 2 and k + 2. */
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

/* The largest distance of the two segments at node k from the drawing when the node is at `at`. */
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
static bool is_too_short(const mt_node_handles handles[2], const mt_vector at[2]) {
    double before = 0, after = 0;
    for (int m = 0; m < 2; m++) {
        before = fmax(before, distance(handles[m].before, at[m]));
        after = fmax(after, distance(at[m], handles[m].after));
    }
    return fmin(before, after) < mt_grid_units(HANDLE_LEAST);
}

static double share_of(mt_node_handles h) {
    double in = distance(h.before, h.at), out = distance(h.at, h.after);
    return in + out > 0 ? in / (in + out) : 0.5;
}

/* Moves node k to the share of the way between its handles' ends that departs least; not at all where every share departs too far.
 * The mean of both masters' shares comes first, so that neither master is preferred. */
static void move_node(const mt_contour *const drawn[2], mt_contour *const masters[2], int k,
                      double tolerance) {
    mt_node_handles handles[2] = {handles_at(masters[0], k), handles_at(masters[1], k)};
    double a = share_of(handles[0]), b = share_of(handles[1]), shares[3] = {(a + b) / 2, a, b};
    double least = INFINITY;
    mt_vector best[2] = {{0, 0}, {0, 0}};
    for (int i = 0; i < 3; i++) {
        mt_vector at[2];
        double worst = 0;
        for (int m = 0; m < 2; m++) {
            at[m] = between(handles[m].before, handles[m].after, shares[i]);
            worst = fmax(worst, departure(drawn[m], masters[m], k, at[m]));
        }
        if (worst > tolerance || worst >= least || is_too_short(handles, at)) continue;
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
    mt_contour drawn[2], *masters_moved[2] = {&masters->a, &masters->b};
    mt_status status = copy(&masters->a, arena, &drawn[0]);
    if (status == MT_OK) status = copy(&masters->b, arena, &drawn[1]);
    if (status != MT_OK || masters->a.count < 3) return status;
    const mt_contour *const before[2] = {&drawn[0], &drawn[1]}, *const now[2] = {&masters->a, &masters->b};
    for (int round = 0; round < ROUNDS; round++)
        for (int k = 0; k < masters->a.count; k++) {
            if (mt_kink(now, k) <= MT_KINK_TURN) continue;
            if (!mt_arena_spend(arena, MOVE_STEPS)) return MT_TOO_LARGE;
            move_node(before, masters_moved, k, tolerance);
        }
    return MT_OK;
}
