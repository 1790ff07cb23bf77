/* Each layer's own rule makes rings whose ink lies to the left of them; all of these together are the shape by one nonzero union. Layers
 * come from anywhere: a union takes time and memory for each crossing, so that these are counted first. */
#include "geometry/layers.h"

#include <stdlib.h>

#include "geometry/limits.h"

/* Where the drawing's own contours cross, the resolved shape has corners of its own, like any other. */
static void crossings_are_corners(mt_shape *shape) {
    for (int k = 0; k < shape->count; k++)
        for (int i = 0; i < shape->components[k].count; i++) {
            mt_ring *ring = &shape->components[k].rings[i];
            for (int j = 0; j < ring->count; j++) {
                if (ring->marks[j] & MT_CROSSING) ring->marks[j] ^= MT_CROSSING | MT_CORNER;
            }
        }
}

/* Contours are looked at finely first, and kept so where they cross (MT_OVERLAP_CARE). */
mt_status mt_outline_shape(const mt_outline *outline, double tolerance, mt_arena *arena, mt_shape *shape) {
    bool clean, as_coarse;
    double grid = mt_grid_units(tolerance);
    mt_status status = mt_outline_resolve(outline, grid / MT_OVERLAP_CARE, arena, shape, &clean);
    if (status == MT_OK && clean) status = mt_outline_resolve(outline, grid, arena, shape, &as_coarse);
    if (status == MT_OK) crossings_are_corners(shape);
    return status;
}

/* ---- how often edges cross ------------------------------------------------------------------------------- */

typedef struct mt_edge {
    mt_point low, high; /* by y */
} mt_edge;

static int compare_edges(const void *a, const void *b) {
    const mt_edge *p = a, *q = b;
    return (p->low.y > q->low.y) - (p->low.y < q->low.y);
}

static bool boxes_meet(const mt_edge *e, const mt_edge *f) {
    int32_t e_left = e->low.x < e->high.x ? e->low.x : e->high.x, e_right = e->low.x ^ e->high.x ^ e_left;
    int32_t f_left = f->low.x < f->high.x ? f->low.x : f->high.x, f_right = f->low.x ^ f->high.x ^ f_left;
    return e_left <= f_right && f_left <= e_right;
}

static int side_of(const mt_edge *e, mt_point p) {
    int64_t cross = mt_cross(e->low, e->high, e->low, p);
    return (cross > 0) - (cross < 0);
}

static bool cross(const mt_edge *e, const mt_edge *f) {
    return boxes_meet(e, f) && side_of(e, f->low) * side_of(e, f->high) < 0 &&
           side_of(f, e->low) * side_of(f, e->high) < 0;
}

static mt_status list_edges(const mt_rings *rings, mt_arena *arena, mt_edge **edges, size_t *count) {
    size_t made = 0;
    mt_edge *list = mt_arena_new(arena, (size_t)mt_rings_corners(rings) + 1, sizeof *list);
    if (!list) return MT_NO_MEMORY;
    for (int i = 0; i < rings->count; i++) {
        const mt_ring *ring = &rings->rings[i];
        for (int k = 0; k < ring->count; k++) {
            mt_point p = ring->points[k], q = ring->points[(k + 1) % ring->count];
            list[made++] = p.y <= q.y ? (mt_edge){p, q} : (mt_edge){q, p};
        }
    }
    qsort(list, made, sizeof *list, compare_edges);
    *edges = list;
    *count = made;
    return MT_OK;
}

/* How many pairs of edges cross; MT_TOO_LARGE over MT_LAYER_CROSSINGS_MAX. O(n log n) where edges are short, O(n²) at the worst. */
static mt_status count_crossings(const mt_rings *rings, mt_arena *arena, size_t *crossings) {
    mt_edge *edges;
    size_t count, active_count = 0, met = 0;
    mt_status status = list_edges(rings, arena, &edges, &count);
    if (status != MT_OK) return status;
    const mt_edge **active = mt_arena_new(arena, count + 1, sizeof *active);
    if (!active) return MT_NO_MEMORY;
    for (size_t i = 0; i < count; i++) {
        size_t kept = 0;
        for (size_t k = 0; k < active_count; k++) {
            if (active[k]->high.y < edges[i].low.y) continue;
            active[kept++] = active[k];
            met += cross(active[k], &edges[i]);
        }
        active[kept] = &edges[i];
        active_count = kept + 1;
        if (met > MT_LAYER_CROSSINGS_MAX) return MT_TOO_LARGE;
    }
    *crossings = met;
    return MT_OK;
}

/* ---- layers ---------------------------------------------------------------------------------------------- */

static mt_status flatten(const mt_layers *layers, double grid, mt_arena *arena, mt_rings *flat,
                         mt_rings *all) {
    int64_t points = 0;
    size_t count = 0;
    for (int i = 0; i < layers->count; i++) {
        mt_status status = mt_flatten(&layers->list[i].outline, grid, arena, &flat[i]);
        if (status != MT_OK) return status;
        points += mt_rings_corners(&flat[i]);
        count += (size_t)flat[i].count;
        if (points > MT_POINTS_MAX) return MT_TOO_LARGE;
    }
    *all = (mt_rings){0, mt_arena_new(arena, count + 1, sizeof *all->rings)};
    if (!all->rings) return MT_NO_MEMORY;
    for (int i = 0; i < layers->count; i++)
        for (int k = 0; k < flat[i].count; k++) all->rings[all->count++] = flat[i].rings[k];
    return MT_OK;
}

/* The rings of all layers, each resolved by its own rule. */
static mt_status resolve_each(const mt_layers *layers, const mt_rings *flat, mt_arena *arena, mt_rings *all) {
    mt_rings *resolved = mt_arena_new(arena, (size_t)layers->count + 1, sizeof *resolved);
    size_t count = 0;
    if (!resolved) return MT_NO_MEMORY;
    for (int i = 0; i < layers->count; i++) {
        mt_shape own;
        mt_status status = mt_union(&flat[i], layers->list[i].rule, arena, &own);
        if (status == MT_OK) crossings_are_corners(&own);
        if (status == MT_OK) status = mt_shape_rings(&own, arena, &resolved[i]);
        if (status != MT_OK) return status;
        count += (size_t)resolved[i].count;
    }
    *all = (mt_rings){0, mt_arena_new(arena, count + 1, sizeof *all->rings)};
    if (!all->rings) return MT_NO_MEMORY;
    for (int i = 0; i < layers->count; i++)
        for (int k = 0; k < resolved[i].count; k++) all->rings[all->count++] = resolved[i].rings[k];
    return MT_OK;
}

/* The shape of chords within `grid` units, and how many of these cross. */
static mt_status resolve(const mt_layers *layers, double grid, mt_arena *arena, mt_shape *shape,
                         size_t *crossings) {
    mt_rings drawn, inked, *flat = mt_arena_new(arena, (size_t)layers->count + 1, sizeof *flat);
    if (!flat) return MT_NO_MEMORY;
    mt_status status = flatten(layers, grid, arena, flat, &drawn);
    if (status == MT_OK) status = count_crossings(&drawn, arena, crossings);
    if (status == MT_OK) status = resolve_each(layers, flat, arena, &inked);
    return status == MT_OK ? mt_union(&inked, MT_NONZERO, arena, shape) : status;
}

mt_status mt_layers_shape(const mt_layers *layers, double tolerance, mt_arena *arena, mt_shape *shape) {
    size_t crossings;
    double grid = mt_grid_units(tolerance);
    mt_status status = resolve(layers, grid / MT_OVERLAP_CARE, arena, shape, &crossings);
    if (status == MT_OK && crossings == 0) status = resolve(layers, grid, arena, shape, &crossings);
    if (status == MT_OK) crossings_are_corners(shape);
    return status;
}
