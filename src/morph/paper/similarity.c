/* Section 2.2.1: the attributes (p, s, t) of a component's convex hull, and the similar function m(h1, h2) = w1 v1 + w2 v2 + w3 v3. As
 * printed v1 and v2 are differences, 0 for equal hulls; here all three are 1 for equal hulls (docs/paper.md, readings). Invariant: each
 * v, and so m, lies in 0 … 1. O(n log n) for the hull of n points, O(1) for a similarity. */
#include "morph/paper/similarity.h"

#include <assert.h>
#include <math.h>

/* A place relative to the rectangle, 0 … 1 on each axis. */
static void relative(mt_box box, double x, double y, double place[2]) {
    place[0] = (x - box.min.x) / mt_box_width(box);
    place[1] = (y - box.min.y) / mt_box_height(box);
}

mt_status mt_hull_of(const mt_component *component, mt_box box, mt_arena *arena, mt_hull *hull) {
    const mt_ring *outer = &component->rings[0];
    mt_arena_place before = mt_arena_mark(arena);
    mt_point *sorted = mt_arena_new(arena, (size_t)outer->count, sizeof *sorted);
    mt_ring ring = {0, mt_arena_new(arena, (size_t)outer->count + 1, sizeof(mt_point)), NULL};
    if (!sorted || !ring.points) return MT_NO_MEMORY;
    for (int i = 0; i < outer->count; i++) sorted[i] = outer->points[i];
    ring.count = mt_convex_hull(sorted, outer->count, ring.points);

    double x, y;
    mt_ring_centre(&ring, &x, &y);
    relative(box, x, y, hull->centre);
    mt_box own = mt_ring_box(&ring);
    relative(box, own.min.x, own.min.y, hull->low);
    relative(box, own.max.x, own.max.y, hull->high);
    double longer = fmax(mt_box_width(box), mt_box_height(box));
    hull->area = (double)mt_ring_area2(&ring) / (2 * longer * longer);
    mt_arena_rewind(arena, before);
    assert(mt_hull_is_valid(hull));
    return MT_OK;
}

/* v1: 1 less the squared distance of the barycentres, relative to how far from the origin they lie. The
 * quotient as printed can pass 1 only for negative coordinates, which the minimum rectangle excludes. */
static double alike_in_place(const mt_hull *h1, const mt_hull *h2) {
    double dx = h1->centre[0] - h2->centre[0], dy = h1->centre[1] - h2->centre[1];
    double far1 = h1->centre[0] + h1->centre[1], far2 = h2->centre[0] + h2->centre[1];
    double scale = far1 * far1 + far2 * far2;
    return scale > 0 ? 1 - (dx * dx + dy * dy) / scale : 1;
}

/* v2: 1 less the difference of the areas relative to the larger. */
static double alike_in_area(const mt_hull *h1, const mt_hull *h2) {
    double larger = fmax(h1->area, h2->area);
    return larger > 0 ? 1 - fabs(h1->area - h2->area) / larger : 1;
}

/* v3: 1 less the mean of d1 … d4, the differences of the four extremes. */
static double alike_in_box(const mt_hull *h1, const mt_hull *h2) {
    double sum = 0;
    for (int axis = 0; axis < 2; axis++)
        sum += fabs(h1->low[axis] - h2->low[axis]) + fabs(h1->high[axis] - h2->high[axis]);
    return 1 - sum / 4;
}

double mt_similarity(const mt_hull *h1, const mt_hull *h2, const double weights[3]) {
    return weights[0] * alike_in_place(h1, h2) + weights[1] * alike_in_area(h1, h2) +
           weights[2] * alike_in_box(h1, h2);
}

bool mt_hull_is_valid(const mt_hull *hull) {
    bool valid = hull->area >= 0;
    for (int i = 0; i < 2; i++)
        valid = valid && hull->low[i] <= hull->centre[i] && hull->centre[i] <= hull->high[i];
    return valid;
}
