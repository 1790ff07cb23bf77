/* Measures of rings: areas as sums of triangles from the first point, exact; boxes, centres, lengths and distances; convexity by the turns
 * at all vertices and one change of direction each way; hulls by A. M. Andrew's monotone chain. O(n), O(n log n) for a hull, O(n m) for
 * the gap between rings. */
#include "geometry/ring.h"

#include <math.h>
#include <stdlib.h>

#include "geometry/limits.h"

mt_status mt_ring_new(mt_arena *arena, int count, mt_ring *ring) {
    if (count > MT_POINTS_MAX) return MT_TOO_LARGE;
    mt_ring made = {count, mt_arena_new(arena, (size_t)count, sizeof(mt_point)), NULL};
    made.marks = mt_arena_new(arena, (size_t)count, sizeof(uint8_t));
    if (!made.points || !made.marks) return MT_NO_MEMORY;
    *ring = made;
    return MT_OK;
}

int mt_shape_ring_count(const mt_shape *shape) {
    int count = 0;
    for (int k = 0; k < shape->count; k++) count += shape->components[k].count;
    return count;
}

mt_status mt_shape_rings(const mt_shape *shape, mt_arena *arena, mt_rings *rings) {
    mt_rings made = {0, mt_arena_new(arena, (size_t)mt_shape_ring_count(shape), sizeof(mt_ring))};
    if (!made.rings) return MT_NO_MEMORY;
    for (int k = 0; k < shape->count; k++)
        for (int i = 0; i < shape->components[k].count; i++)
            made.rings[made.count++] = shape->components[k].rings[i];
    *rings = made;
    return MT_OK;
}

/* ---- areas and lengths --------------------------------------------------------------------------------- */

int64_t mt_ring_area2(const mt_ring *ring) {
    mt_wide sum = 0; /* a ring that winds many times may pass 64 bits on the way */
    for (int i = 1; i + 1 < ring->count; i++)
        sum += mt_orient(ring->points[0], ring->points[i], ring->points[i + 1]);
    return (int64_t)sum;
}

int64_t mt_rings_corners(const mt_rings *rings) {
    int64_t corners = 0;
    for (int i = 0; i < rings->count; i++) corners += rings->rings[i].count;
    return corners;
}

int64_t mt_component_area2(const mt_component *component) {
    int64_t sum = 0;
    for (int i = 0; i < component->count; i++) sum += mt_ring_area2(&component->rings[i]);
    return sum;
}

int64_t mt_shape_area2(const mt_shape *shape) {
    int64_t sum = 0;
    for (int i = 0; i < shape->count; i++) sum += mt_component_area2(&shape->components[i]);
    return sum;
}

double mt_ring_length(const mt_ring *ring) {
    double sum = 0;
    for (int i = 0; i < ring->count; i++)
        sum += sqrt((double)mt_distance2(ring->points[i], ring->points[(i + 1) % ring->count]));
    return sum;
}

double mt_rings_length(const mt_rings *rings) {
    double length = 0;
    for (int i = 0; i < rings->count; i++) length += mt_ring_length(&rings->rings[i]);
    return length;
}

/* ---- boxes and centres --------------------------------------------------------------------------------- */

static void extend_box(mt_box *box, mt_point p) {
    if (p.x < box->min.x) box->min.x = p.x;
    if (p.y < box->min.y) box->min.y = p.y;
    if (p.x > box->max.x) box->max.x = p.x;
    if (p.y > box->max.y) box->max.y = p.y;
}

mt_box mt_ring_box(const mt_ring *ring) {
    if (ring->count == 0) return (mt_box){0};
    mt_box box = {ring->points[0], ring->points[0]};
    for (int i = 1; i < ring->count; i++) extend_box(&box, ring->points[i]);
    return box;
}

mt_box mt_box_around(mt_box p, mt_box q) {
    extend_box(&p, q.min);
    extend_box(&p, q.max);
    return p;
}

mt_box mt_shape_box(const mt_shape *shape) {
    if (shape->count == 0) return (mt_box){0};
    mt_box all = mt_ring_box(&shape->components[0].rings[0]);
    for (int i = 1; i < shape->count; i++)
        all = mt_box_around(all, mt_ring_box(&shape->components[i].rings[0]));
    return all;
}

double mt_box_width(mt_box box) {
    return fmax(1, (double)box.max.x - box.min.x);
}

double mt_box_height(mt_box box) {
    return fmax(1, (double)box.max.y - box.min.y);
}

void mt_ring_centre(const mt_ring *ring, double *x, double *y) {
    mt_point o = ring->count ? ring->points[0] : (mt_point){0};
    double area = 0, sx = 0, sy = 0;
    for (int i = 1; i + 1 < ring->count; i++) {
        mt_point p = ring->points[i], q = ring->points[i + 1];
        double w = (double)mt_orient(o, p, q);
        area += w;
        sx += w * ((double)p.x - o.x + ((double)q.x - o.x));
        sy += w * ((double)p.y - o.y + ((double)q.y - o.y));
    }
    if (mt_ring_area2(ring) != 0) {
        *x = o.x + sx / (3 * area);
        *y = o.y + sy / (3 * area);
        return;
    }
    mt_box box = mt_ring_box(ring);
    *x = ((double)box.min.x + box.max.x) / 2;
    *y = ((double)box.min.y + box.max.y) / 2;
}

/* ---- distances ----------------------------------------------------------------------------------------- */

double mt_way_to_edge(mt_point from, mt_point a, mt_point b, double way[2]) {
    double length2 = (double)mt_distance2(a, b),
           along = length2 > 0 ? (double)mt_dot(a, b, a, from) / length2 : 0;
    double t = fmin(1, fmax(0, along));
    way[0] = a.x + t * ((double)b.x - a.x) - from.x;
    way[1] = a.y + t * ((double)b.y - a.y) - from.y;
    return sqrt(way[0] * way[0] + way[1] * way[1]);
}

/* From the points of one ring to the other's edges, if that is less than `least`. */
static double gap_one_way(const mt_ring *from, const mt_ring *to, double least, double way[2]) {
    for (int i = 0; i < from->count; i++)
        for (int k = 0; k < to->count; k++) {
            double here[2],
                gap = mt_way_to_edge(from->points[i], to->points[k], to->points[(k + 1) % to->count], here);
            if (gap >= least) continue;
            least = gap;
            way[0] = here[0];
            way[1] = here[1];
        }
    return least;
}

double mt_ring_gap(const mt_ring *p, const mt_ring *q, mt_point *way) {
    double there[2] = {0, 0}, back[2] = {0, 0};
    double gap = gap_one_way(p, q, INFINITY, there), nearer = gap_one_way(q, p, gap, back);
    double x = nearer < gap ? -back[0] : there[0], y = nearer < gap ? -back[1] : there[1];
    *way = (mt_point){(int32_t)lround(x), (int32_t)lround(y)};
    return nearer;
}

/* ---- convexity ----------------------------------------------------------------------------------------- */

static bool points_right(mt_point a, mt_point b) {
    return b.x > a.x || (b.x == a.x && b.y > a.y);
}

bool mt_ring_is_convex(const mt_ring *ring) {
    if (ring->count < 3 || mt_ring_area2(ring) <= 0) return false;
    int changes = 0; /* of going right to going left and back: two once around, more for a star */
    for (int i = 0; i < ring->count; i++) {
        mt_point a = ring->points[i], b = ring->points[(i + 1) % ring->count],
                 c = ring->points[(i + 2) % ring->count];
        int64_t turn = mt_orient(a, b, c);
        bool folds_back = turn == 0 && mt_dot(a, b, b, c) <= 0;
        if (turn < 0 || folds_back) return false;
        changes += points_right(a, b) != points_right(b, c);
    }
    return changes == 2;
}

static int by_x_then_y(const void *p, const void *q) {
    const mt_point *a = p, *b = q;
    if (a->x != b->x) return a->x < b->x ? -1 : 1;
    return (a->y > b->y) - (a->y < b->y);
}

int mt_convex_hull(mt_point *points, int n, mt_point *hull) {
    qsort(points, (size_t)n, sizeof *points, by_x_then_y);
    int count = 0;
    for (int i = 0; i < n; i++) { /* the lower chain, left to right */
        while (count >= 2 && mt_orient(hull[count - 2], hull[count - 1], points[i]) <= 0) count--;
        if (count == 0 || !mt_point_equal(hull[count - 1], points[i])) hull[count++] = points[i];
    }
    int lower = count + 1;
    for (int i = n - 2; i >= 0; i--) { /* the upper chain, right to left */
        while (count >= lower && mt_orient(hull[count - 2], hull[count - 1], points[i]) <= 0) count--;
        if (!mt_point_equal(hull[count - 1], points[i])) hull[count++] = points[i];
    }
    return count > 1 ? count - 1 : count;
}

/* ---- invariants ---------------------------------------------------------------------------------------- */

bool mt_ring_is_valid(const mt_ring *ring) {
    bool valid = ring->count >= 0 && (ring->count == 0 || (ring->points && ring->marks));
    for (int i = 0; valid && i < ring->count; i++) {
        mt_point p = ring->points[i];
        valid = abs(p.x) <= 4 * MT_COORD_MAX && abs(p.y) <= 4 * MT_COORD_MAX &&
                !(ring->marks[i] & ~(MT_POINT_MARKS | MT_EDGE_MARKS));
    }
    return valid;
}

bool mt_component_is_valid(const mt_component *component) {
    bool valid = component->count >= 1;
    for (int i = 0; valid && i < component->count; i++) {
        const mt_ring *ring = &component->rings[i];
        valid = ring->count >= 3 && mt_ring_is_valid(ring) && (mt_ring_area2(ring) > 0) == (i == 0) &&
                mt_ring_area2(ring) != 0;
    }
    return valid;
}

bool mt_shape_is_valid(const mt_shape *shape) {
    bool valid = shape->count >= 0;
    for (int k = 0; valid && k < shape->count; k++) valid = mt_component_is_valid(&shape->components[k]);
    return valid;
}

bool mt_pieces_is_valid(const mt_pieces *pieces) {
    bool valid = pieces->count >= 0;
    for (int i = 0; valid && i < pieces->count; i++)
        valid = mt_ring_is_valid(&pieces->rings[i]) && mt_ring_is_convex(&pieces->rings[i]);
    return valid;
}
