/* Each layer's own rule makes rings whose ink lies to the left of them; all of these together are the shape by one nonzero union. Layers
 * come from anywhere: a union takes time and memory for each crossing, so that these are counted first. */
#include "geometry/layers.h"

#include "geometry/crossings.h"
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
                         int64_t *crossings) {
    mt_crossings found = {0};
    mt_rings drawn, inked, *flat = mt_arena_new(arena, (size_t)layers->count + 1, sizeof *flat);
    if (!flat) return MT_NO_MEMORY;
    mt_status status = flatten(layers, grid, arena, flat, &drawn);
    if (status == MT_OK) status = mt_count_crossings(&drawn, MT_LAYER_CROSSINGS_MAX, arena, &found);
    *crossings = found.count;
    if (status == MT_OK) status = resolve_each(layers, flat, arena, &inked);
    return status == MT_OK ? mt_union(&inked, MT_NONZERO, arena, shape) : status;
}

mt_status mt_layers_shape(const mt_layers *layers, double tolerance, mt_arena *arena, mt_shape *shape) {
    int64_t crossings;
    double grid = mt_grid_units(tolerance);
    mt_status status = resolve(layers, grid / MT_OVERLAP_CARE, arena, shape, &crossings);
    if (status == MT_OK && crossings == 0) status = resolve(layers, grid, arena, shape, &crossings);
    if (status == MT_OK) crossings_are_corners(shape);
    return status;
}
