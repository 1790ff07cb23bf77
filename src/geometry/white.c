/* A region of white is bounded by a hole and by the components that lie in it and in no smaller hole:
 *
 *     ┌───────────────┐ outer ring of a component      filled: hole and island are left out, and what lies in the island
 *     │  ┌─────────┐  │ hole: bounds a region             is inside the ink now, with its own white as it was
 *     │  │ ┌─────┐ │  │ island: bounds it too
 *     │  │ │  o  │ │  │
 *     └──┴─┴─────┴─┴──┘
 *
 * Its mean width is twice its area over the length of its border. O(r² n) for r rings of n points, to find which hole a component is in. */
#include "geometry/white.h"

#include <math.h>
#include <stdlib.h>

#include "geometry/inside.h"
#include "geometry/limits.h"
#include "geometry/union.h"

#define WHITE_MOST                                                                                           \
    60.0 /* 1/1000 em: an inline is 20 to 40 wide, a counter of a black face 50 and more at its narrowest */

/* All rings of a shape. */
typedef struct mt_ring_tree {
    int count;
    const mt_ring **rings;
    int *home;  /* of an outer ring: the smallest hole around it; -1: none, or the ring is a hole itself */
    bool *hole; /* the ring is one */
    bool *gone; /* it bounds white that is filled */
} mt_ring_tree;

static bool is_in_ring(const mt_ring *ring, mt_point place) {
    mt_component only = {1, (mt_ring *)ring};
    return mt_is_in_ink(&(mt_shape){1, &only}, place);
}

static void find_home(mt_ring_tree *t, int outer) {
    const mt_ring *ring = t->rings[outer];
    int64_t least = INT64_MAX;
    t->home[outer] = -1;
    for (int h = 0; h < t->count && !t->hole[outer]; h++) {
        int64_t area = -mt_ring_area2(t->rings[h]);
        if (!t->hole[h] || area >= least || area <= mt_ring_area2(ring)) continue;
        if (!is_in_ring(t->rings[h], ring->points[0])) continue;
        least = area;
        t->home[outer] = h;
    }
}

static mt_status list_rings(const mt_shape *shape, mt_arena *arena, mt_ring_tree *t) {
    size_t room = (size_t)mt_shape_ring_count(shape) + 1;
    *t = (mt_ring_tree){0, mt_arena_new(arena, room, sizeof(mt_ring *)),
                        mt_arena_new(arena, room, sizeof(int)), mt_arena_new(arena, room, sizeof(bool)),
                        mt_arena_new(arena, room, sizeof(bool))};
    if (!t->rings || !t->home || !t->hole || !t->gone) return MT_NO_MEMORY;
    for (int k = 0; k < shape->count; k++)
        for (int i = 0; i < shape->components[k].count; i++) {
            t->hole[t->count] = i > 0;
            t->rings[t->count++] = &shape->components[k].rings[i];
        }
    for (int i = 0; i < t->count; i++) find_home(t, i);
    return MT_OK;
}

static double mean_width(const mt_rings *region) {
    return fabs((double)mt_component_area2(region)) / mt_rings_length(region);
}

/* A region, and how wide it is. */
typedef struct mt_width {
    mt_rings region;
    int hole;
    double width; /* grid units */
} mt_width;

static mt_status region_of(const mt_ring_tree *t, int hole, mt_arena *arena, mt_width *made) {
    *made = (mt_width){{0, mt_arena_new(arena, (size_t)t->count, sizeof(mt_ring))}, hole, 0};
    if (!made->region.rings) return MT_NO_MEMORY;
    made->region.rings[made->region.count++] = *t->rings[hole];
    for (int i = 0; i < t->count; i++)
        if (t->home[i] == hole) made->region.rings[made->region.count++] = *t->rings[i];
    made->width = mean_width(&made->region);
    return MT_OK;
}

/* The narrowest first, of equal ones the first. */
static int compare_widths(const void *p, const void *q) {
    const mt_width *a = p, *b = q;
    return a->width != b->width ? (a->width > b->width) - (a->width < b->width) : a->hole - b->hole;
}

static void take(mt_ring_tree *t, const mt_width *narrow, mt_white *white) {
    for (int i = 0; i < t->count; i++) t->gone[i] |= i == narrow->hole || t->home[i] == narrow->hole;
    white->regions[white->count++] = narrow->region;
    white->ring_count += narrow->region.count;
}

static mt_status find_white(const mt_shape *shape, int most, mt_arena *arena, mt_white *white) {
    mt_ring_tree t;
    mt_status status = list_rings(shape, arena, &t);
    if (status != MT_OK) return status;
    int holes = 0;
    mt_rings rest = {0, mt_arena_new(arena, (size_t)t.count + 1, sizeof(mt_ring))};
    mt_width *widths = mt_arena_new(arena, (size_t)t.count + 1, sizeof *widths);
    white->regions = mt_arena_new(arena, (size_t)t.count + 1, sizeof(mt_rings));
    if (!rest.rings || !widths || !white->regions) return MT_NO_MEMORY;
    for (int i = 0; status == MT_OK && i < t.count; i++)
        if (t.hole[i]) status = region_of(&t, i, arena, &widths[holes++]);
    if (status != MT_OK) return status;
    qsort(widths, (size_t)holes, sizeof *widths, compare_widths);
    for (int i = 0; i < holes && i < most && widths[i].width <= mt_grid_units(WHITE_MOST); i++)
        take(&t, &widths[i], white);
    for (int i = 0; i < t.count; i++)
        if (!t.gone[i]) rest.rings[rest.count++] = *t.rings[i];
    return white->count > 0 ? mt_union(&rest, MT_NONZERO, arena, &white->filled) : MT_OK;
}

static int hole_count(const mt_shape *shape) {
    return mt_shape_ring_count(shape) - shape->count;
}

mt_status mt_find_white(const mt_shape *a, const mt_shape *b, mt_arena *arena, mt_white *white) {
    int more = hole_count(a) - hole_count(b);
    *white = (mt_white){.in_a = more > 0};
    return more != 0 ? find_white(more > 0 ? a : b, abs(more), arena, white) : MT_OK;
}
