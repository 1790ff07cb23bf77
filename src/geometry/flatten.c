/* From outlines to rings. Chord counts (see outline.h): with p0 … pn the control points of a curve of degree
 * n and
 *
 *     d = max |p[i] - 2 p[i+1] + p[i+2]|,   chords = ⌈√(n (n - 1) d / (8 ε))⌉
 *
 * the distance between curve and chords is at most ε: for n = 2 the bound is exact, for n = 3 it is Wang's.
 * The points lie on the curve, rounded to the grid. Invariant: no two neighbouring points are equal. O(chords). */
#include <assert.h>
#include <math.h>

#include "arithmetic/angles.h"
#include "geometry/limits.h"
#include "geometry/outline.h"

/* A Bézier of degree 1 … 3 with its first point. */
typedef struct mt_curve {
    int degree;
    mt_point p[4];
} mt_curve;

static mt_curve curve_of(mt_point start, const mt_segment *segment) {
    mt_curve curve = {segment->degree, {start}};
    for (int i = 1; i < segment->degree; i++) curve.p[i] = segment->control[i - 1];
    curve.p[segment->degree] = segment->end;
    return curve;
}

static mt_vector between(mt_point a, mt_point b) {
    return (mt_vector){(double)b.x - a.x, (double)b.y - a.y};
}

/* The angle from u to v, radians, -π … π. */
static double turn(mt_vector u, mt_vector v) {
    return mt_atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y);
}

/* The direction in which a curve leaves its start (step 1) or, reversed, its end (step -1): towards the first
 * control point that is elsewhere. */
static mt_vector direction(const mt_curve *curve, int step) {
    int from = step > 0 ? 0 : curve->degree;
    int i = from + step;
    while (i > 0 && i < curve->degree && mt_point_equal(curve->p[i], curve->p[from])) i += step;
    return step > 0 ? between(curve->p[from], curve->p[i]) : between(curve->p[i], curve->p[from]);
}

static double control_polygon_turn(const mt_curve *curve) {
    double sum = 0;
    mt_vector before = direction(curve, 1);
    for (int i = 1; i < curve->degree; i++) {
        mt_vector edge = between(curve->p[i], curve->p[i + 1]);
        if (edge.x == 0 && edge.y == 0) continue;
        sum += fabs(turn(before, edge));
        before = edge;
    }
    return sum;
}

static int chord_count(const mt_curve *curve, double tolerance) {
    int n = curve->degree;
    if (n == 1) return 1;
    double second = 0;
    for (int i = 0; i + 2 <= n; i++) {
        mt_vector u = between(curve->p[i + 1], curve->p[i]), v = between(curve->p[i + 1], curve->p[i + 2]);
        second = fmax(second, mt_hypot(u.x + v.x, u.y + v.y));
    }
    double by_error = ceil(sqrt(n * (n - 1) * second / (8 * tolerance)));
    double by_turn = ceil(control_polygon_turn(curve) * (180 / M_PI) / MT_CHORD_TURN);
    return (int)fmax(1, fmax(by_error, by_turn));
}

static mt_point point_at(const mt_curve *curve, double t) {
    mt_vector q[4];
    for (int i = 0; i <= curve->degree; i++) q[i] = (mt_vector){curve->p[i].x, curve->p[i].y};
    for (int n = curve->degree; n > 0; n--)
        for (int i = 0; i < n; i++)
            q[i] = (mt_vector){q[i].x + t * (q[i + 1].x - q[i].x), q[i].y + t * (q[i + 1].y - q[i].y)};
    return (mt_point){(int32_t)lround(q[0].x), (int32_t)lround(q[0].y)};
}

/* A curve whose control points are all in line is a line. */
static bool is_line(const mt_curve *curve) {
    for (int i = 1; i < curve->degree; i++)
        if (mt_orient(curve->p[0], curve->p[curve->degree], curve->p[i]) != 0) return false;
    return true;
}

/* Two lines always meet in a corner; where a curve takes part, see MT_SMOOTH_JOIN. */
static uint8_t join_marks(const mt_curve *in, const mt_curve *out) {
    mt_vector before = direction(in, -1), after = direction(out, 1);
    double angle = fabs(turn(before, after)) * (180 / M_PI);
    double by_rounding =
        MT_SMOOTH_ROUNDING / mt_hypot(before.x, before.y) + MT_SMOOTH_ROUNDING / mt_hypot(after.x, after.y);
    double allowed = fmin(MT_SMOOTH_JOIN + by_rounding * (180 / M_PI), MT_SMOOTH_JOIN_MOST);
    bool smooth = !(is_line(in) && is_line(out)) && angle <= allowed;
    return (uint8_t)((is_line(out) ? MT_LINE : MT_CHORD) | (smooth ? 0 : MT_CORNER));
}

static mt_curve curve_at(const mt_contour *contour, int i) {
    return curve_of(contour->segments[(i + contour->count - 1) % contour->count].end, &contour->segments[i]);
}

/* A point that falls on the last one hands on its edge, and its corner. */
static void add_point(mt_ring *ring, mt_point p, uint8_t marks) {
    int last = ring->count - 1;
    if (last >= 0 && mt_point_equal(ring->points[last], p)) {
        ring->marks[last] = (uint8_t)((ring->marks[last] & MT_POINT_MARKS) | marks);
        return;
    }
    ring->points[ring->count] = p;
    ring->marks[ring->count++] = marks;
}

/* Points of one segment after its start, the last with the mark of the join there. */
static void add_segment(mt_ring *ring, const mt_curve *curve, const mt_curve *next, double tolerance) {
    int chords = chord_count(curve, tolerance);
    uint8_t inside = is_line(curve) ? MT_LINE : MT_CHORD;
    for (int k = 1; k < chords; k++) add_point(ring, point_at(curve, (double)k / chords), inside);
    add_point(ring, curve->p[curve->degree], join_marks(curve, next));
}

static mt_status flatten_contour(const mt_contour *contour, double tolerance, mt_arena *arena,
                                 mt_ring *ring) {
    int64_t bound = 0;
    for (int i = 0; i < contour->count; i++) {
        mt_curve curve = curve_at(contour, i);
        bound += chord_count(&curve, tolerance);
    }
    if (bound > MT_POINTS_MAX) return MT_TOO_LARGE;
    mt_status status = mt_ring_new(arena, (int)bound, ring);
    if (status != MT_OK) return status;
    ring->count = 0;
    for (int i = 0; i < contour->count; i++) {
        mt_curve curve = curve_at(contour, i), next = curve_at(contour, (i + 1) % contour->count);
        add_segment(ring, &curve, &next, tolerance);
    }
    while (ring->count > 1 && mt_point_equal(ring->points[0], ring->points[ring->count - 1])) {
        ring->count--;
        ring->marks[0] |= ring->marks[ring->count] & MT_POINT_MARKS;
    }
    assert(mt_ring_is_valid(ring));
    return MT_OK;
}

mt_status mt_flatten(const mt_outline *outline, double tolerance, mt_arena *arena, mt_rings *rings) {
    mt_rings made = {0, mt_arena_new(arena, (size_t)outline->count, sizeof(mt_ring))};
    if (!made.rings) return MT_NO_MEMORY;
    for (int i = 0; i < outline->count; i++) {
        mt_ring *ring = &made.rings[made.count];
        mt_status status = flatten_contour(&outline->contours[i], tolerance, arena, ring);
        if (status != MT_OK) return status;
        made.count += ring->count >= 3;
    }
    *rings = made;
    return MT_OK;
}

/* ---- two contours alike -------------------------------------------------------------------------------------- */

/* Points of both curves at the same parameters after their starts, but those that are the last ones of both. */
static void add_alike(mt_ring *rings[2], const mt_curve curves[2], int chords) {
    for (int k = 1; k <= chords; k++) {
        double t = (double)k / chords;
        mt_point p = point_at(&curves[0], t), q = point_at(&curves[1], t);
        int last = rings[0]->count - 1;
        if (last >= 0 && mt_point_equal(rings[0]->points[last], p) &&
            mt_point_equal(rings[1]->points[last], q))
            continue;
        rings[0]->points[rings[0]->count++] = p;
        rings[1]->points[rings[1]->count++] = q;
    }
}

static void drop_last_alike(mt_ring *rings[2]) {
    int n = rings[0]->count;
    while (n > 1 && mt_point_equal(rings[0]->points[0], rings[0]->points[n - 1]) &&
           mt_point_equal(rings[1]->points[0], rings[1]->points[n - 1]))
        n--;
    rings[0]->count = rings[1]->count = n;
}

static int chords_alike(const mt_contour *contours[2], int i, double tolerance, mt_curve curves[2]) {
    for (int m = 0; m < 2; m++) curves[m] = curve_at(contours[m], i);
    int in_a = chord_count(&curves[0], tolerance), in_b = chord_count(&curves[1], tolerance);
    return in_a > in_b ? in_a : in_b;
}

mt_status mt_flatten_alike(const mt_contour *a, const mt_contour *b, double tolerance, mt_arena *arena,
                           mt_ring *in_a, mt_ring *in_b) {
    const mt_contour *contours[] = {a, b};
    mt_ring *rings[] = {in_a, in_b};
    mt_curve curves[2];
    int64_t bound = 0;
    for (int i = 0; i < a->count; i++) bound += chords_alike(contours, i, tolerance, curves);
    if (bound > MT_POINTS_MAX) return MT_TOO_LARGE;
    for (int m = 0; m < 2; m++) {
        mt_status status = mt_ring_new(arena, (int)bound, rings[m]);
        if (status != MT_OK) return status;
        rings[m]->count = 0;
    }
    for (int i = 0; i < a->count; i++) {
        int chords = chords_alike(contours, i, tolerance, curves);
        add_alike(rings, curves, chords);
    }
    drop_last_alike(rings);
    return MT_OK;
}
