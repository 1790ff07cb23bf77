/* A region of white is bounded by a hole and by the components that lie in it and in no smaller hole:
 *
 *     ┌───────────────┐ outer ring of a component      filled: hole and island are left out, and what lies in the island
 *     │  ┌─────────┐  │ hole: bounds a region             is inside the ink now, with its own white as it was
 *     │  │ ┌─────┐ │  │ island: bounds it too
 *     │  │ │  o  │ │  │
 *     └──┴─┴─────┴─┴──┘
 *
 * A counter's counterpart lies where it does once both glyphs lie in one box: they share a good part of what
 * either covers. Those that share most go together first. O(r² n + p m log m) for r rings of n points, and p pairs of regions whose boxes meet, of m points. */
#include "geometry/white.h"

#include <math.h>
#include <stdlib.h>

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

/* The regions of a shape. */
typedef struct mt_regions {
    mt_ring_tree tree;
    int count;
    int *holes;        /* of each, its hole in the tree */
    mt_rings *regions; /* the shape's own rings */
    mt_rings *placed;  /* the same in the common box, with the region to the left */
    bool *matched;
} mt_regions;

static mt_status region_of(const mt_ring_tree *t, int hole, mt_arena *arena, mt_rings *region) {
    *region = (mt_rings){0, mt_arena_new(arena, (size_t)t->count, sizeof(mt_ring))};
    if (!region->rings) return MT_NO_MEMORY;
    region->rings[region->count++] = *t->rings[hole];
    for (int i = 0; i < t->count; i++)
        if (t->home[i] == hole) region->rings[region->count++] = *t->rings[i];
    return MT_OK;
}

static int32_t scaled(int32_t at, int32_t from, double side, int32_t to, double to_side) {
    return to + (int32_t)lround((at - from) / fmax(1, side) * to_side);
}

/* The rings carried from one box into another, the other way around. */
static mt_status place_region(const mt_rings *region, mt_box box, mt_box into, mt_arena *arena,
                              mt_rings *placed) {
    *placed = (mt_rings){0, mt_arena_new(arena, (size_t)region->count, sizeof(mt_ring))};
    if (!placed->rings) return MT_NO_MEMORY;
    for (int r = 0; r < region->count; r++) {
        const mt_ring *ring = &region->rings[r];
        mt_ring *made = &placed->rings[placed->count++];
        mt_status status = mt_ring_new(arena, ring->count, made);
        if (status != MT_OK) return status;
        for (int i = 0; i < ring->count; i++) {
            mt_point p = ring->points[ring->count - 1 - i];
            made->points[i] =
                (mt_point){scaled(p.x, box.min.x, mt_box_width(box), into.min.x, mt_box_width(into)),
                           scaled(p.y, box.min.y, mt_box_height(box), into.min.y, mt_box_height(into))};
        }
    }
    return MT_OK;
}

static mt_status list_regions(const mt_shape *shape, mt_box into, mt_arena *arena, mt_regions *r) {
    *r = (mt_regions){0};
    mt_status status = list_rings(shape, arena, &r->tree);
    size_t room = (size_t)r->tree.count + 1;
    r->holes = mt_arena_new(arena, room, sizeof(int));
    r->regions = mt_arena_new(arena, room, sizeof(mt_rings));
    r->placed = mt_arena_new(arena, room, sizeof(mt_rings));
    r->matched = mt_arena_new(arena, room, sizeof(bool));
    if (status == MT_OK && (!r->holes || !r->regions || !r->placed || !r->matched)) status = MT_NO_MEMORY;
    for (int i = 0; status == MT_OK && i < r->tree.count; i++) {
        if (!r->tree.hole[i]) continue;
        r->holes[r->count] = i;
        status = region_of(&r->tree, i, arena, &r->regions[r->count]);
        if (status == MT_OK)
            status =
                place_region(&r->regions[r->count], mt_shape_box(shape), into, arena, &r->placed[r->count]);
        r->count++;
    }
    return status;
}

/* ---- counterparts ---------------------------------------------------------------------------------------- */

/* Counterparts share at least one part in so many of what either covers. */
#define SHARE 5

typedef struct mt_shared {
    int a, b;
    double share; /* of what either covers */
} mt_shared;

static bool boxes_meet(const mt_ring *p, const mt_ring *q) {
    mt_box a = mt_ring_box(p), b = mt_ring_box(q);
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

/* The share of two regions; 0 where they are no counterparts. */
static mt_status share_of(const mt_rings *a, const mt_rings *b, mt_arena *arena, double *share) {
    *share = 0;
    if (!boxes_meet(&a->rings[0], &b->rings[0])) return MT_OK;
    mt_arena_place before = mt_arena_mark(arena);
    mt_rings all = {0, mt_arena_new(arena, (size_t)(a->count + b->count), sizeof(mt_ring))};
    mt_shape either;
    if (!all.rings) return MT_NO_MEMORY;
    for (int i = 0; i < a->count; i++) all.rings[all.count++] = a->rings[i];
    for (int i = 0; i < b->count; i++) all.rings[all.count++] = b->rings[i];
    mt_status status = mt_union_unmarked(&all, MT_NONZERO, arena, &either);
    if (status == MT_OK) {
        int64_t of_either = mt_shape_area2(&either),
                both = mt_component_area2(a) + mt_component_area2(b) - of_either;
        if (SHARE * both >= of_either && both > 0) *share = (double)both / (double)of_either;
    }
    mt_arena_rewind(arena, before);
    return status;
}

/* The largest share first. */
static int compare_shares(const void *p, const void *q) {
    const mt_shared *s = p, *t = q;
    if (s->share != t->share) return s->share > t->share ? -1 : 1;
    return s->a != t->a ? s->a - t->a : s->b - t->b;
}

static mt_status match_regions(mt_regions *a, mt_regions *b, mt_arena *arena) {
    mt_shared *list = mt_arena_new(arena, (size_t)a->count * (size_t)b->count, sizeof *list);
    int count = 0;
    if (!list) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (int i = 0; status == MT_OK && i < a->count; i++)
        for (int k = 0; status == MT_OK && k < b->count; k++) {
            mt_shared *shared = &list[count];
            *shared = (mt_shared){i, k, 0};
            status = share_of(&a->placed[i], &b->placed[k], arena, &shared->share);
            count += shared->share > 0;
        }
    qsort(list, (size_t)count, sizeof *list, compare_shares);
    for (int i = 0; status == MT_OK && i < count; i++)
        if (!a->matched[list[i].a] && !b->matched[list[i].b])
            a->matched[list[i].a] = b->matched[list[i].b] = true;
    return status;
}

/* ---- white ------------------------------------------------------------------------------------------------- */

/* What has no counterpart. */
static mt_status fill(mt_regions *r, mt_arena *arena, mt_white *white) {
    mt_ring_tree *t = &r->tree;
    mt_rings rest = {0, mt_arena_new(arena, (size_t)t->count + 1, sizeof(mt_ring))};
    *white = (mt_white){.regions = mt_arena_new(arena, (size_t)r->count, sizeof(mt_rings))};
    if (!rest.rings || !white->regions) return MT_NO_MEMORY;
    for (int i = 0; i < r->count; i++) {
        if (r->matched[i]) continue;
        for (int k = 0; k < t->count; k++) t->gone[k] |= k == r->holes[i] || t->home[k] == r->holes[i];
        white->regions[white->count++] = r->regions[i];
        white->ring_count += r->regions[i].count;
    }
    for (int i = 0; i < t->count; i++)
        if (!t->gone[i]) rest.rings[rest.count++] = *t->rings[i];
    return white->count > 0 ? mt_union(&rest, MT_NONZERO, arena, &white->filled) : MT_OK;
}

mt_status mt_find_white(const mt_shape *a, const mt_shape *b, mt_arena *arena, mt_white white[2]) {
    mt_regions of_a, of_b;
    mt_status status = list_regions(a, mt_shape_box(a), arena, &of_a);
    if (status == MT_OK) status = list_regions(b, mt_shape_box(a), arena, &of_b);
    if (status == MT_OK) status = match_regions(&of_a, &of_b, arena);
    if (status == MT_OK) status = fill(&of_a, arena, &white[0]);
    return status == MT_OK ? fill(&of_b, arena, &white[1]) : status;
}
