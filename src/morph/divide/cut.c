/* Cutting a triangulated component along diagonals. Cuts have no width.
 *
 *     ┌─────────┐       ┌────┬┬────┐         ┌─────────┐        ┌─────────┐
 *     │         ┊  ──▶  │    ││    │         │  ┌──┐┈┈┈│  ──▶   │  ┌──┐───│
 *     └─────────┘       └────┴┴────┘         │  └──┘   │        │  └──┘───│   (one ring, there and back)
 *     a ring to itself: two parts            └─────────┘        └─────────┘   a hole to another ring: one ring less
 *
 * Triangles that share an uncut edge are one part (flood fill). The border of a part consists of half-edges without a twin or along a
 * cut; turning around the end of each, through the ink, finds the next. Invariants: every border half-edge is in one ring; the outer
 * ring alone of a part runs anticlockwise. O(t) for t triangles, and O(t) more for each part. */
#include "morph/divide/cut.h"

#include <assert.h>

typedef struct mt_cutting {
    const mt_cut_plan *plan;
    mt_arena *arena;
    int *part_of;
    bool *end;    /* of each vertex: whether a cut ends there */
    bool *traced; /* of each half-edge: whether a ring has it */
} mt_cutting;

/* Whether a half-edge bounds its part: beyond it lies no ink, or a cut. */
static bool is_border(const mt_cutting *k, int e) {
    return k->plan->mesh->twin[e] < 0 || k->plan->cut[e];
}

static mt_status flood(mt_cutting *k, int *count) {
    const mt_half_edges *mesh = k->plan->mesh;
    int *stack = mt_arena_new(k->arena, (size_t)mesh->triangle_count, sizeof *stack);
    if (!stack) return MT_NO_MEMORY;
    for (int t = 0; t < mesh->triangle_count; t++) k->part_of[t] = -1;
    *count = 0;
    for (int t = 0; t < mesh->triangle_count; t++) {
        if (k->part_of[t] >= 0) continue;
        int depth = 0;
        stack[depth++] = t;
        k->part_of[t] = *count;
        while (depth > 0) {
            int u = stack[--depth];
            for (int e = 3 * u; e < 3 * u + 3; e++) {
                if (is_border(k, e) || k->part_of[mesh->twin[e] / 3] >= 0) continue;
                k->part_of[mesh->twin[e] / 3] = *count;
                stack[depth++] = mesh->twin[e] / 3;
            }
        }
        ++*count;
    }
    return MT_OK;
}

/* The next half-edge of the border: around the end of this one, through the ink. */
static int next_on_border(const mt_cutting *k, int e) {
    e = mt_mesh_after(e);
    while (!is_border(k, e)) e = mt_mesh_after(k->plan->mesh->twin[e]);
    return e;
}

/* The border from half-edge `first` on: all of its vertices, or those that were drawn or end a cut. */
static mt_status trace_vertices(mt_cutting *k, int first, bool all, mt_ring *ring) {
    const mt_half_edges *mesh = k->plan->mesh;
    int count = 0, e = first;
    do {
        k->traced[e] = true;
        count += all || k->plan->drawn[mesh->start[e]] || k->end[mesh->start[e]];
        e = next_on_border(k, e);
    } while (e != first);
    mt_status status = mt_ring_new(k->arena, count, ring);
    if (status != MT_OK) return status;
    int made = 0;
    do {
        int v = mesh->start[e];
        if (all || k->plan->drawn[v] || k->end[v]) {
            uint8_t marks = k->plan->cut[e] ? MT_LINE : mesh->marks[e];
            ring->points[made] = mesh->points[v];
            ring->marks[made++] = k->end[v] ? marks | MT_CORNER : marks;
        }
        e = next_on_border(k, e);
    } while (e != first);
    return MT_OK;
}

/* A vertex that divides a long edge lies beside that edge by rounding, so that a sliver may consist of such vertices alone: where the
 * drawn ones do not run around the same side, all are taken. */
static mt_status trace_border(mt_cutting *k, int first, mt_ring *ring) {
    mt_ring whole;
    mt_status status = trace_vertices(k, first, true, &whole);
    if (status == MT_OK) status = trace_vertices(k, first, false, ring);
    if (status != MT_OK) return status;
    int64_t area2 = mt_ring_area2(ring);
    if (area2 == 0 || (area2 > 0) != (mt_ring_area2(&whole) > 0)) *ring = whole;
    return MT_OK;
}

/* All rings of one part; the outer one, which alone runs anticlockwise, comes first. */
static mt_status take_part(mt_cutting *k, int number, mt_component *part) {
    const mt_half_edges *mesh = k->plan->mesh;
    int edges = 3 * mesh->triangle_count;
    *part = (mt_component){0, mt_arena_new(k->arena, (size_t)mesh->vertex_count, sizeof(mt_ring))};
    if (!part->rings) return MT_NO_MEMORY;
    for (int e = 0; e < edges; e++) {
        if (k->part_of[e / 3] != number || !is_border(k, e) || k->traced[e]) continue;
        mt_ring ring;
        mt_status status = trace_border(k, e, &ring);
        if (status != MT_OK) return status;
        part->rings[part->count++] = ring;
        if (mt_ring_area2(&ring) <= mt_ring_area2(&part->rings[0])) continue;
        part->rings[part->count - 1] = part->rings[0];
        part->rings[0] = ring;
    }
    return MT_OK;
}

mt_status mt_cut(const mt_cut_plan *plan, mt_arena *arena, mt_shape *parts, int *part_of) {
    const mt_half_edges *mesh = plan->mesh;
    size_t edges = 3 * (size_t)mesh->triangle_count;
    mt_cutting k = {.plan = plan, .arena = arena, .part_of = part_of};
    k.end = mt_arena_new(arena, (size_t)mesh->vertex_count, sizeof *k.end);
    k.traced = mt_arena_new(arena, edges, sizeof *k.traced);
    if (!k.end || !k.traced) return MT_NO_MEMORY;
    for (size_t e = 0; e < edges; e++) k.end[mesh->start[e]] |= plan->cut[e];
    mt_shape made = {0};
    mt_status status = flood(&k, &made.count);
    if (status != MT_OK) return status;
    made.components = mt_arena_new(arena, (size_t)made.count, sizeof(mt_component));
    if (!made.components) return MT_NO_MEMORY;
    for (int i = 0; status == MT_OK && i < made.count; i++) status = take_part(&k, i, &made.components[i]);
    assert(status != MT_OK || mt_shape_is_valid(&made));
    if (status == MT_OK) *parts = made;
    return status;
}
