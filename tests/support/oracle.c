#include "support/oracle.h"

#include "support/check.h"

#include <math.h>

static mt_point after(const mt_ring *ring, int i) {
    return ring->points[i + 1 < ring->count ? i + 1 : 0];
}

static int sign(mt_wide value) {
    return (value > 0) - (value < 0);
}

mt_spot mt_spot_of(mt_point point, int64_t scale) {
    return (mt_spot){point.x * scale, point.y * scale};
}

mt_wide mt_oracle_orient(mt_spot a, mt_spot b, mt_spot c) {
    return (mt_wide)(b.x - a.x) * (c.y - a.y) - (mt_wide)(b.y - a.y) * (c.x - a.x);
}

static mt_wide ring_area2(const mt_ring *ring) {
    mt_wide sum = 0;
    for (int i = 0; i < ring->count; i++) {
        mt_point p = ring->points[i], q = after(ring, i);
        sum += (mt_wide)p.x * q.y - (mt_wide)q.x * p.y;
    }
    return sum;
}

mt_wide mt_oracle_area2(const mt_rings *rings) {
    mt_wide sum = 0;
    for (int i = 0; i < rings->count; i++) sum += ring_area2(&rings->rings[i]);
    return sum;
}

mt_wide mt_oracle_shape_area2(const mt_shape *shape) {
    mt_wide sum = 0;
    for (int i = 0; i < shape->count; i++) sum += mt_oracle_area2(&shape->components[i]);
    return sum;
}

/* The determinant of rows (x, y, x² + y²) of three points seen from the fourth. */
int mt_oracle_in_circle(mt_point a, mt_point b, mt_point c, mt_point d) {
    mt_point from[3] = {a, b, c};
    mt_wide x[3], y[3], lift[3];
    for (int i = 0; i < 3; i++) {
        x[i] = (mt_wide)from[i].x - d.x;
        y[i] = (mt_wide)from[i].y - d.y;
        lift[i] = x[i] * x[i] + y[i] * y[i];
    }
    return sign(x[0] * (y[1] * lift[2] - y[2] * lift[1]) - y[0] * (x[1] * lift[2] - x[2] * lift[1]) +
                lift[0] * (x[1] * y[2] - x[2] * y[1]));
}

/* Points repeated in a row count as one; returns how many remain in `kept`, which has room for all. */
static int without_repeats(const mt_ring *ring, mt_spot *kept) {
    int count = 0;
    for (int i = 0; i < ring->count; i++)
        if (!mt_point_equal(ring->points[i], after(ring, i))) kept[count++] = mt_spot_of(ring->points[i], 1);
    return count;
}

static int half_plane(mt_spot from, mt_spot to) {
    return to.y < from.y || (to.y == from.y && to.x < from.x);
}

/* Edge directions of a polygon that turns around once change between the upper and the lower half-plane
 * twice. */
static bool turns_once(const mt_spot *spots, int n) {
    int changes = 0;
    for (int i = 0; i < n; i++) {
        mt_spot a = spots[i], b = spots[(i + 1) % n], c = spots[(i + 2) % n];
        changes += half_plane(a, b) != half_plane(b, c);
    }
    return changes == 2;
}

bool mt_oracle_is_convex(const mt_ring *ring) {
    if (ring->count < 3 || ring_area2(ring) <= 0) return false;
    mt_spot *spots = mt_test_new((size_t)ring->count, sizeof *spots);
    int n = without_repeats(ring, spots);
    bool convex = turns_once(spots, n);
    for (int i = 0; i < n; i++)
        for (int k = 0; k < n; k++)
            if (mt_oracle_orient(spots[i], spots[(i + 1) % n], spots[k]) < 0) convex = false;
    free(spots);
    return convex;
}

int mt_oracle_reflex_count(const mt_component *component) {
    int reflex = 0;
    for (int r = 0; r < component->count; r++) {
        const mt_ring *ring = &component->rings[r];
        mt_spot *spots = mt_test_new((size_t)ring->count, sizeof *spots);
        int n = without_repeats(ring, spots);
        for (int i = 0; i < n; i++)
            reflex += mt_oracle_orient(spots[i], spots[(i + 1) % n], spots[(i + 2) % n]) < 0;
        free(spots);
    }
    return reflex;
}

bool mt_oracle_cross(mt_spot a, mt_spot b, mt_spot c, mt_spot d) {
    return sign(mt_oracle_orient(a, b, c)) * sign(mt_oracle_orient(a, b, d)) < 0 &&
           sign(mt_oracle_orient(c, d, a)) * sign(mt_oracle_orient(c, d, b)) < 0;
}

static bool on_segment(mt_spot p, mt_spot a, mt_spot b) {
    return mt_oracle_orient(a, b, p) == 0 && p.x >= (a.x < b.x ? a.x : b.x) &&
           p.x <= (a.x > b.x ? a.x : b.x) && p.y >= (a.y < b.y ? a.y : b.y) && p.y <= (a.y > b.y ? a.y : b.y);
}

bool mt_oracle_meet(mt_spot a, mt_spot b, mt_spot c, mt_spot d) {
    return mt_oracle_cross(a, b, c, d) || on_segment(a, c, d) || on_segment(b, c, d) || on_segment(c, a, b) ||
           on_segment(d, a, b);
}

typedef struct edges {
    int count;
    mt_spot *from, *to;
    int *ring; /* that each edge belongs to */
} edges;

static int point_count(const mt_rings *rings) {
    int count = 0;
    for (int i = 0; i < rings->count; i++) count += rings->rings[i].count;
    return count;
}

static edges collect(const mt_rings *rings) {
    size_t room = (size_t)point_count(rings);
    edges all = {0, mt_test_new(room, sizeof(mt_spot)), mt_test_new(room, sizeof(mt_spot)),
                 mt_test_new(room, sizeof(int))};
    for (int r = 0; r < rings->count; r++) {
        const mt_ring *ring = &rings->rings[r];
        mt_spot *spots = &all.from[all.count];
        int n = without_repeats(ring, spots);
        for (int i = 0; i < n; i++) {
            all.to[all.count + i] = spots[(i + 1) % n];
            all.ring[all.count + i] = r;
        }
        all.count += n;
    }
    return all;
}

/* Whether all pairs of edges pass the test. */
static bool every_pair(const mt_rings *rings, bool (*passes)(const edges *all, int i, int k)) {
    edges all = collect(rings);
    bool pass = true;
    for (int i = 0; i < all.count && pass; i++)
        for (int k = 0; k < i && pass; k++) pass = passes(&all, i, k);
    free(all.from);
    free(all.to);
    free(all.ring);
    return pass;
}

/* Whether edge k follows edge i in their ring. */
static bool follows(const edges *all, int i, int k) {
    if (all->ring[i] != all->ring[k]) return false;
    if (k == i + 1) return true;
    bool last = i + 1 == all->count || all->ring[i + 1] != all->ring[i];
    return last && k <= i && (k == 0 || all->ring[k - 1] != all->ring[k]);
}

/* Two edges of which the second follows the first have only their shared end in common unless they fold
 * back. */
static bool folds_back(mt_spot a, mt_spot b, mt_spot c) {
    return mt_oracle_orient(a, b, c) == 0 &&
           (mt_wide)(b.x - a.x) * (c.x - b.x) + (mt_wide)(b.y - a.y) * (c.y - b.y) < 0;
}

static bool pair_is_clean(const edges *all, int i, int k) {
    if (follows(all, i, k)) return !folds_back(all->from[i], all->to[i], all->to[k]);
    if (follows(all, k, i)) return !folds_back(all->from[k], all->to[k], all->to[i]);
    return !mt_oracle_meet(all->from[i], all->to[i], all->from[k], all->to[k]);
}

bool mt_oracle_is_clean(const mt_component *component) {
    return every_pair(component, pair_is_clean);
}

static bool pair_is_crossing_free(const edges *all, int i, int k) {
    return !mt_oracle_cross(all->from[i], all->to[i], all->from[k], all->to[k]);
}

bool mt_oracle_is_crossing_free(const mt_component *component) {
    return every_pair(component, pair_is_crossing_free);
}

int mt_oracle_winding(const mt_rings *rings, int64_t scale, mt_spot spot) {
    int winding = 0;
    for (int r = 0; r < rings->count; r++) {
        const mt_ring *ring = &rings->rings[r];
        for (int i = 0; i < ring->count; i++) {
            mt_spot a = mt_spot_of(ring->points[i], scale), b = mt_spot_of(after(ring, i), scale);
            if (a.y <= spot.y && b.y > spot.y) winding += mt_oracle_orient(a, b, spot) > 0;
            if (a.y > spot.y && b.y <= spot.y) winding -= mt_oracle_orient(a, b, spot) < 0;
        }
    }
    return winding;
}

bool mt_oracle_in_shape(const mt_shape *shape, int64_t scale, mt_spot spot) {
    for (int i = 0; i < shape->count; i++)
        if (mt_oracle_winding(&shape->components[i], scale, spot)) return true;
    return false;
}

double mt_oracle_segment_distance(double x, double y, double ax, double ay, double bx, double by) {
    double dx = bx - ax, dy = by - ay, length2 = dx * dx + dy * dy;
    double t = length2 > 0 ? ((x - ax) * dx + (y - ay) * dy) / length2 : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return hypot(x - ax - t * dx, y - ay - t * dy);
}

double mt_oracle_distance(const mt_rings *rings, int64_t scale, mt_spot spot) {
    double x = (double)spot.x / (double)scale, y = (double)spot.y / (double)scale, best = INFINITY;
    for (int r = 0; r < rings->count; r++) {
        const mt_ring *ring = &rings->rings[r];
        for (int i = 0; i < ring->count; i++) {
            mt_point a = ring->points[i], b = after(ring, i);
            best = fmin(best, mt_oracle_segment_distance(x, y, a.x, a.y, b.x, b.y));
        }
    }
    return best;
}

double mt_oracle_shape_distance(const mt_shape *shape, int64_t scale, mt_spot spot) {
    double best = INFINITY;
    for (int i = 0; i < shape->count; i++)
        best = fmin(best, mt_oracle_distance(&shape->components[i], scale, spot));
    return best;
}

static bool farther(mt_spot from, mt_spot p, mt_spot q) {
    mt_wide px = p.x - from.x, py = p.y - from.y, qx = q.x - from.x, qy = q.y - from.y;
    return px * px + py * py > qx * qx + qy * qy;
}

/* The next corner after spots[at]: all other spots lie to the left of or on the line to it. */
static int wrap(const mt_spot *spots, int n, int at) {
    int best = at;
    for (int i = 0; i < n; i++) {
        if (spots[i].x == spots[at].x && spots[i].y == spots[at].y) continue;
        mt_wide turn = best == at ? -1 : mt_oracle_orient(spots[at], spots[best], spots[i]);
        if (turn < 0 || (turn == 0 && farther(spots[at], spots[i], spots[best]))) best = i;
    }
    return best;
}

int mt_oracle_hull(const mt_spot *spots, int n, mt_spot *hull) {
    int first = 0, count = 0;
    for (int i = 1; i < n; i++)
        if (spots[i].y < spots[first].y || (spots[i].y == spots[first].y && spots[i].x < spots[first].x))
            first = i;
    int at = first;
    do {
        hull[count++] = spots[at];
        at = wrap(spots, n, at);
    } while (count < n && (spots[at].x != spots[first].x || spots[at].y != spots[first].y));
    return count;
}

double mt_oracle_length(const mt_rings *rings) {
    double length = 0;
    for (int r = 0; r < rings->count; r++) {
        const mt_ring *ring = &rings->rings[r];
        for (int i = 0; i < ring->count; i++) {
            mt_point a = ring->points[i], b = after(ring, i);
            length += hypot((double)b.x - a.x, (double)b.y - a.y);
        }
    }
    return length;
}

double mt_oracle_shape_length(const mt_shape *shape) {
    double length = 0;
    for (int i = 0; i < shape->count; i++) length += mt_oracle_length(&shape->components[i]);
    return length;
}
