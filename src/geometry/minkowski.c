/* rA ⊕ (1 - r)B of two convex pieces. The edges of a convex ring come in order of angle; those of the sum are
 * the edges of both, merged by angle (P. K. Ghosh, "A unified computational framework for Minkowski
 * operations", 1993). Scaling by a positive weight turns no edge, so that the order is decided on the pieces'
 * own integer edges, exactly.
 *
 * Where y has other weights than x, pieces are stretched, which turns edges: then the stretched ones are compared, as exactly.
 *
 *     P ◺ has edges → ↖ ↓, Q □ has → ↑ ← ↓, and the sum → ↑ ↖ ← ↓: equal directions become one edge.
 *
 * For 0 < r < 1 the corners of the sum are r·a + (1 - r)·b for the same pairs (a, b): each moves on a
 * straight line. Invariant: the sum is convex, but for rounding to the grid. O(n + m). */
#include "geometry/minkowski.h"

#include <assert.h>
#include <math.h>

mt_weights mt_weights_at(double t) {
    return mt_weights_of(mt_at_both(t));
}

mt_weights mt_weights_of(mt_at at) {
    int32_t x = (int32_t)lround(at.x * MT_WEIGHT_ONE), y = (int32_t)lround(at.y * MT_WEIGHT_ONE);
    return (mt_weights){MT_WEIGHT_ONE - x, x, y - x};
}

static int32_t mix(int32_t a, int32_t b, int32_t p, int32_t q) {
    int64_t sum = (int64_t)a * p + (int64_t)b * q + MT_WEIGHT_ONE / 2;
    int64_t down = sum >= 0 ? sum / MT_WEIGHT_ONE : -((-sum + MT_WEIGHT_ONE - 1) / MT_WEIGHT_ONE);
    return (int32_t)down;
}

mt_point mt_mix(mt_weights weights, mt_point p, mt_point q) {
    return (mt_point){mix(weights.a, weights.b, p.x, q.x),
                      mix(weights.a - weights.up, weights.b + weights.up, p.y, q.y)};
}

/* ---- the merge ----------------------------------------------------------------------------------------- */

static int lowest(const mt_ring *ring) {
    int low = 0;
    for (int i = 1; i < ring->count; i++) {
        mt_point p = ring->points[i], q = ring->points[low];
        if (p.y < q.y || (p.y == q.y && p.x < q.x)) low = i;
    }
    return low;
}

static int after(const mt_ring *ring, int i) {
    return i + 1 == ring->count ? 0 : i + 1;
}

/* The marks of the corner made of p's vertex and q's, and of the edge that follows: p's (first > 0), q's (<
 * 0) or the two in one. When one vertex is smooth, the other's sharp corner is rounded by its curve, and the
 * sum is smooth here. At either end of the blend only that end's own vertex counts. */
static uint8_t joint_marks(mt_weights weights, uint8_t p, uint8_t q, int64_t first) {
    bool only_p = weights.b == 0 && weights.up == 0, only_q = weights.a == 0 && weights.up == 0;
    uint8_t point = only_p ? p : only_q ? q : p & q;
    uint8_t edge = (uint8_t)((first >= 0 && !only_q ? p : 0) | (first <= 0 && !only_p ? q : 0));
    if (edge & MT_LINE) edge = MT_LINE; /* a line with a chord along it is a longer line */
    return (uint8_t)((point & MT_CORNER) | (edge & MT_EDGE_MARKS));
}

/* A corner that falls on the last one hands on the edge that follows. */
static void add(mt_ring *sum, mt_point point, uint8_t marks) {
    int last = sum->count - 1;
    if (last >= 0 && mt_point_equal(sum->points[last], point)) {
        sum->marks[last] = (uint8_t)((sum->marks[last] & MT_POINT_MARKS) | marks);
        return;
    }
    sum->points[sum->count] = point;
    sum->marks[sum->count++] = marks;
}

/* As mt_cross of the edges, weighted: one number over, under or equal to 0. Coordinates fit 45 bits, their products 90. */
static int64_t turn(mt_weights w, mt_point a, mt_point b, mt_point c, mt_point d) {
    mt_wide px = (mt_wide)w.a * (b.x - a.x), py = (mt_wide)(w.a - w.up) * (b.y - a.y);
    mt_wide qx = (mt_wide)w.b * (d.x - c.x), qy = (mt_wide)(w.b + w.up) * (d.y - c.y);
    mt_wide cross = px * qy - py * qx;
    return cross > 0 ? 1 : cross < 0 ? -1 : 0;
}

/* The next edge by angle: > 0 p's, < 0 q's, 0 both at once. Merging starts at both pieces' lowest
 * points, and when one piece has gone once around, only the other's edges are left. */
static int64_t which(mt_weights weights, const mt_ring *p, int i, int p_left, const mt_ring *q, int j,
                     int q_left) {
    if (p_left == 0) return -1;
    if (q_left == 0) return 1;
    mt_point a = p->points[i], b = p->points[after(p, i)], c = q->points[j], d = q->points[after(q, j)];
    bool p_down = b.y < a.y || (b.y == a.y && b.x < a.x), q_down = d.y < c.y || (d.y == c.y && d.x < c.x);
    if (p_down != q_down) return p_down ? -1 : 1;
    return weights.up == 0 ? mt_cross(a, b, c, d) : turn(weights, a, b, c, d);
}

/* The state of the merge: vertex i of p and j of q, and the edges left of each. */
typedef struct mt_merge {
    const mt_ring *p, *q;
    mt_weights weights;
    int i, j, p_left, q_left;
} mt_merge;

static mt_merge begin_merge(const mt_ring *p, const mt_ring *q, mt_weights weights) {
    return (mt_merge){p, q, weights, lowest(p), lowest(q), p->count, q->count};
}

static bool is_merging(const mt_merge *m) {
    return m->p_left > 0 || m->q_left > 0;
}

static int64_t next_edge(const mt_merge *m) {
    return which(m->weights, m->p, m->i, m->p_left, m->q, m->j, m->q_left);
}

static void pass_edge(mt_merge *m, int64_t first) {
    if (first >= 0) {
        m->i = after(m->p, m->i);
        m->p_left--;
    }
    if (first <= 0) {
        m->j = after(m->q, m->j);
        m->q_left--;
    }
}

void mt_minkowski(const mt_ring *p, const mt_ring *q, mt_weights weights, mt_ring *sum) {
    sum->count = 0;
    for (mt_merge m = begin_merge(p, q, weights); is_merging(&m);) {
        int64_t first = next_edge(&m);
        add(sum, mt_mix(weights, p->points[m.i], q->points[m.j]),
            joint_marks(weights, p->marks[m.i], q->marks[m.j], first));
        pass_edge(&m, first);
    }
    while (sum->count > 1 && mt_point_equal(sum->points[0], sum->points[sum->count - 1])) {
        sum->count--;
        sum->marks[0] |= sum->marks[sum->count] & MT_POINT_MARKS;
    }
    assert(mt_ring_is_valid(sum));
}

int mt_minkowski_corners(const mt_ring *p, const mt_ring *q, mt_corner *corners) {
    const mt_weights half = mt_weights_at(0.5);
    int count = 0;
    for (mt_merge m = begin_merge(p, q, half); is_merging(&m); pass_edge(&m, next_edge(&m)))
        corners[count++] = (mt_corner){m.i, m.j};
    return count;
}
