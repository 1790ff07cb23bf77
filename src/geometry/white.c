/* A region of white is bounded by a hole and by the components that lie in it and in no smaller hole:
 *
 *     ┌───────────────┐ outer ring of a component      filled: hole and island are left out, and what lies in the island
 *     │  ┌─────────┐  │ hole: bounds a region             is inside the ink now, with its own white as it was
 *     │  │ ┌─────┐ │  │ island: bounds it too
 *     │  │ │  o  │ │  │
 *     └──┴─┴─────┴─┴──┘
 *
 * A counter lies on the other's counter, and what lies on its ink has no counterpart there. O(r (r n + m log m)) for r rings of n points
 * and ink of m. */
#include "geometry/white.h"

#include <math.h>

#include "geometry/inside.h"
#include "geometry/union.h"

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

/* The rings with ink to the left of them, or where `white` with white there. */
static mt_status add_rings(const mt_rings *rings, bool white, mt_arena *arena, mt_rings *all) {
    for (int i = 0; i < rings->count; i++) {
        mt_ring *ring = &all->rings[all->count];
        mt_status status = mt_ring_new(arena, rings->rings[i].count, ring);
        if (status != MT_OK) return status;
        for (int k = 0; k < ring->count; k++)
            ring->points[k] = rings->rings[i].points[white ? ring->count - 1 - k : k];
        all->count++;
    }
    return MT_OK;
}

/* Whether more than half of a region lies on ink. */
static mt_status lies_on_ink(const mt_rings *region, const mt_rings *ink, int64_t ink_area2, mt_arena *arena,
                             bool *lies) {
    mt_arena_place before = mt_arena_mark(arena);
    mt_shape both;
    mt_rings all = {0, mt_arena_new(arena, (size_t)(region->count + ink->count), sizeof(mt_ring))};
    if (!all.rings) return MT_NO_MEMORY;
    mt_status status = add_rings(region, true, arena, &all);
    if (status == MT_OK) status = add_rings(ink, false, arena, &all);
    if (status == MT_OK) status = mt_union_unmarked(&all, MT_NONZERO, arena, &both);
    int64_t white = -mt_component_area2(region);
    if (status == MT_OK) *lies = 2 * (white + ink_area2 - mt_shape_area2(&both)) > white;
    mt_arena_rewind(arena, before);
    return status;
}

static mt_status region_of(const mt_ring_tree *t, int hole, mt_arena *arena, mt_rings *region) {
    *region = (mt_rings){0, mt_arena_new(arena, (size_t)t->count, sizeof(mt_ring))};
    if (!region->rings) return MT_NO_MEMORY;
    region->rings[region->count++] = *t->rings[hole];
    for (int i = 0; i < t->count; i++)
        if (t->home[i] == hole) region->rings[region->count++] = *t->rings[i];
    return MT_OK;
}

static void take(mt_ring_tree *t, int hole, const mt_rings *region, mt_white *white) {
    for (int i = 0; i < t->count; i++) t->gone[i] |= i == hole || t->home[i] == hole;
    white->regions[white->count++] = *region;
    white->ring_count += region->count;
}

static mt_status find_regions(mt_ring_tree *t, const mt_rings *ink, mt_arena *arena, mt_white *white) {
    int64_t ink_area2 = 0;
    mt_status status = MT_OK;
    for (int i = 0; i < ink->count; i++) ink_area2 += mt_ring_area2(&ink->rings[i]);
    for (int i = 0; status == MT_OK && i < t->count; i++) {
        mt_rings region;
        bool lies = false;
        if (!t->hole[i]) continue;
        status = region_of(t, i, arena, &region);
        if (status == MT_OK) status = lies_on_ink(&region, ink, ink_area2, arena, &lies);
        if (status == MT_OK && lies) take(t, i, &region, white);
    }
    return status;
}

/* The rings of `shape`, scaled from its box into another. */
static mt_status scaled_rings(const mt_shape *shape, mt_box into, mt_arena *arena, mt_rings *rings) {
    mt_box box = mt_shape_box(shape);
    double width = fmax(1, mt_box_width(box)), height = fmax(1, mt_box_height(box));
    mt_rings own;
    mt_status status = mt_shape_rings(shape, arena, &own);
    *rings = (mt_rings){0, mt_arena_new(arena, (size_t)own.count, sizeof(mt_ring))};
    if (status == MT_OK && !rings->rings) status = MT_NO_MEMORY;
    if (status == MT_OK) status = add_rings(&own, false, arena, rings);
    for (int i = 0; status == MT_OK && i < rings->count; i++)
        for (int k = 0; k < rings->rings[i].count; k++) {
            mt_point *p = &rings->rings[i].points[k];
            p->x = into.min.x + (int32_t)lround((p->x - box.min.x) / width * mt_box_width(into));
            p->y = into.min.y + (int32_t)lround((p->y - box.min.y) / height * mt_box_height(into));
        }
    return status;
}

mt_status mt_find_white(const mt_shape *shape, const mt_shape *ink, mt_arena *arena, mt_white *white) {
    mt_ring_tree t;
    mt_rings on;
    *white = (mt_white){0};
    mt_status status = list_rings(shape, arena, &t);
    if (status == MT_OK) status = scaled_rings(ink, mt_shape_box(shape), arena, &on);
    if (status != MT_OK) return status;
    mt_rings rest = {0, mt_arena_new(arena, (size_t)t.count + 1, sizeof(mt_ring))};
    white->regions = mt_arena_new(arena, (size_t)t.count + 1, sizeof(mt_rings));
    if (!rest.rings || !white->regions) return MT_NO_MEMORY;
    status = find_regions(&t, &on, arena, white);
    for (int i = 0; i < t.count; i++)
        if (!t.gone[i]) rest.rings[rest.count++] = *t.rings[i];
    return status == MT_OK && white->count > 0 ? mt_union(&rest, MT_NONZERO, arena, &white->filled) : status;
}
