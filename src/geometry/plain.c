/* The ink of rings that cross, from their triangles.
 *
 *     shape ── triangles of each component: its area? ──▶ as it is
 *                └── no ── rings snapped (snap.h) ── triangles with a winding number above 0 ── joined over common edges
 *                                                       ──▶ components ── their borders, cut where they meet themselves ──▶ rings
 *
 * Invariant: snapped edges do not cross, so that the triangulation cannot fail. O(n log n) and the snapping. */
#include "geometry/plain.h"

#include <assert.h>
#include <stdlib.h>

#include "geometry/limits.h"
#include "geometry/snap.h"
#include "geometry/triangulate.h"

/* ---- whether it is plain -------------------------------------------------------------------------------------- */

static int64_t triangles_area2(const mt_half_edges *mesh) {
    int64_t area2 = 0;
    for (int e = 0; e < 3 * mesh->triangle_count; e += 3)
        area2 += mt_orient(mesh->points[mesh->start[e]], mesh->points[mesh->start[e + 1]],
                           mesh->points[mesh->start[e + 2]]);
    return area2;
}

static mt_status look(const mt_shape *shape, mt_arena *arena, bool *plain) {
    *plain = true;
    for (int k = 0; *plain && k < shape->count; k++) {
        mt_half_edges mesh;
        mt_arena_place before = mt_arena_mark(arena);
        mt_status status = mt_triangulate(&shape->components[k], arena, &mesh);
        if (status == MT_OK) *plain = triangles_area2(&mesh) == mt_component_area2(&shape->components[k]);
        if (status == MT_BAD_GEOMETRY) *plain = false;
        mt_arena_rewind(arena, before);
        if (status == MT_NO_MEMORY) return status;
    }
    return MT_OK;
}

/* ---- triangles joined over common edges ------------------------------------------------------------------------- */

typedef struct mt_seam {
    int low, high; /* the vertices of an edge, in order */
    int edge;
} mt_seam;

static int by_vertices(const void *a, const void *b) {
    const mt_seam *p = a, *q = b;
    if (p->low != q->low) return p->low < q->low ? -1 : 1;
    if (p->high != q->high) return p->high < q->high ? -1 : 1;
    return (p->edge > q->edge) - (p->edge < q->edge);
}

static int end_of(const mt_half_edges *mesh, int e) {
    return mesh->start[mt_mesh_after(e)];
}

/* A ring edge with ink on both sides is no border. */
static mt_status join_over_rings(mt_half_edges *mesh, mt_arena *arena) {
    int edges = 3 * mesh->triangle_count, count = 0;
    mt_seam *seams = mt_arena_new(arena, (size_t)edges + 1, sizeof *seams);
    if (!seams) return MT_NO_MEMORY;
    for (int e = 0; e < edges; e++) {
        int p = mesh->start[e], q = end_of(mesh, e);
        if (mesh->twin[e] < 0) seams[count++] = (mt_seam){p < q ? p : q, p < q ? q : p, e};
    }
    qsort(seams, (size_t)count, sizeof *seams, by_vertices);
    for (int i = 0; i + 1 < count; i++) {
        if (seams[i].low != seams[i + 1].low || seams[i].high != seams[i + 1].high) continue;
        mesh->twin[seams[i].edge] = seams[i + 1].edge;
        mesh->twin[seams[i + 1].edge] = seams[i].edge;
    }
    return MT_OK;
}

/* Numbers the parts that hang together by edges: part[t] of triangle t. */
static mt_status number_parts(const mt_half_edges *mesh, mt_arena *arena, int **part, int *part_count) {
    size_t triangles = (size_t)mesh->triangle_count;
    int *made = mt_arena_new(arena, triangles + 1, sizeof *made), count = 0, waiting = 0;
    int *stack = mt_arena_new(arena, triangles + 1, sizeof *stack);
    if (!made || !stack) return MT_NO_MEMORY;
    for (size_t t = 0; t < triangles; t++) made[t] = -1;
    for (int t = 0; t < mesh->triangle_count; t++) {
        if (made[t] >= 0) continue;
        made[t] = count++;
        for (stack[waiting++] = t; waiting > 0;) {
            int at = stack[--waiting];
            for (int e = 3 * at; e < 3 * at + 3; e++) {
                int twin = mesh->twin[e];
                if (twin < 0 || made[twin / 3] >= 0) continue;
                made[twin / 3] = made[at];
                stack[waiting++] = twin / 3;
            }
        }
    }
    *part = made;
    *part_count = count;
    return MT_OK;
}

/* ---- borders ---------------------------------------------------------------------------------------------------- */

typedef struct mt_border {
    const mt_half_edges *mesh;
    mt_arena *arena;
    bool *taken; /* each edge of the border */
    int *path;   /* edges that are no ring yet, end to start */
    int path_count;
    int *on_path; /* of each vertex: 1 + where the path leaves it, or 0 */
} mt_border;

/* The border edge after `e`, around its end and through the ink there. */
static int border_after(const mt_half_edges *mesh, int e) {
    int next = mt_mesh_after(e);
    while (mesh->twin[next] >= 0) next = mt_mesh_after(mesh->twin[next]);
    return next;
}

static bool is_straight_on(mt_point p, mt_point q, mt_point r) {
    return mt_orient(p, q, r) == 0 && mt_dot(p, q, q, r) > 0;
}

/* A ring of `count` border edges, without points in line, from its lowest point on, of these the leftmost. */
static mt_status take_ring(const mt_border *border, const int *edges, int count, mt_ring *ring) {
    const mt_half_edges *mesh = border->mesh;
    mt_ring made;
    int first = 0, kept = 0;
    for (int i = 1; i < count; i++) {
        mt_point p = mesh->points[mesh->start[edges[i]]], q = mesh->points[mesh->start[edges[first]]];
        if (p.y < q.y || (p.y == q.y && p.x < q.x)) first = i;
    }
    mt_status status = mt_ring_new(border->arena, count, &made);
    if (status != MT_OK) return status;
    for (int i = 0; i < count; i++) {
        int e = edges[(first + i) % count], before = edges[(first + i + count - 1) % count];
        mt_point p = mesh->points[mesh->start[e]];
        if (is_straight_on(mesh->points[mesh->start[before]], p, mesh->points[end_of(mesh, e)])) continue;
        made.points[kept] = p;
        made.marks[kept++] = mesh->marks[e];
    }
    made.count = kept;
    *ring = made;
    return MT_OK;
}

/* Takes the rest of the path from `from` on, which is closed, as a ring of its component. */
static mt_status close_ring(mt_border *border, int from, mt_component *component) {
    for (int i = from; i < border->path_count; i++) border->on_path[border->mesh->start[border->path[i]]] = 0;
    mt_status status = take_ring(border, border->path + from, border->path_count - from,
                                 &component->rings[component->count++]);
    border->path_count = from;
    return status;
}

/* Follows a border once around; where it meets itself, a ring is closed, so that none has a point twice. */
static mt_status follow(mt_border *border, int start, mt_component *component) {
    int e = start;
    do {
        border->taken[e] = true;
        border->on_path[border->mesh->start[e]] = ++border->path_count;
        border->path[border->path_count - 1] = e;
        int met = border->on_path[end_of(border->mesh, e)];
        mt_status status = met > 0 ? close_ring(border, met - 1, component) : MT_OK;
        if (status != MT_OK) return status;
        e = border_after(border->mesh, e);
    } while (e != start);
    assert(border->path_count == 0);
    return MT_OK;
}

static int compare_rings(const void *a, const void *b) {
    mt_point p = ((const mt_ring *)a)->points[0], q = ((const mt_ring *)b)->points[0];
    return p.y != q.y ? (p.y > q.y) - (p.y < q.y) : (p.x > q.x) - (p.x < q.x);
}

static int compare_components(const void *a, const void *b) {
    return compare_rings(((const mt_component *)a)->rings, ((const mt_component *)b)->rings);
}

/* The outer ring first, then holes in their order. */
static void order(mt_component *component) {
    mt_ring *rings = component->rings;
    for (int i = 1; i < component->count; i++) {
        if (mt_ring_area2(&rings[i]) < 0) continue;
        mt_ring outer = rings[i];
        rings[i] = rings[0];
        rings[0] = outer;
    }
    qsort(rings + 1, (size_t)component->count - 1, sizeof *rings, compare_rings);
}

/* Room for a ring of each part's border edges in threes. */
static mt_status make_room(const mt_half_edges *mesh, const int *part, mt_arena *arena, mt_shape *made) {
    int *edges = mt_arena_new(arena, (size_t)made->count + 1, sizeof *edges);
    made->components = mt_arena_new(arena, (size_t)made->count + 1, sizeof *made->components);
    if (!edges || !made->components) return MT_NO_MEMORY;
    for (int e = 0; e < 3 * mesh->triangle_count; e++) edges[part[e / 3]] += mesh->twin[e] < 0;
    for (int k = 0; k < made->count; k++) {
        made->components[k].rings = mt_arena_new(arena, (size_t)edges[k] / 3 + 1, sizeof(mt_ring));
        if (!made->components[k].rings) return MT_NO_MEMORY;
    }
    return MT_OK;
}

static mt_status take_borders(const mt_half_edges *mesh, const int *part, mt_arena *arena, mt_shape *made) {
    size_t edges = 3 * (size_t)mesh->triangle_count;
    mt_border border = {.mesh = mesh,
                        .arena = arena,
                        .taken = mt_arena_new(arena, edges + 1, sizeof *border.taken),
                        .path = mt_arena_new(arena, edges + 1, sizeof *border.path),
                        .on_path =
                            mt_arena_new(arena, (size_t)mesh->vertex_count + 1, sizeof *border.on_path)};
    if (!border.taken || !border.path || !border.on_path) return MT_NO_MEMORY;
    mt_status status = make_room(mesh, part, arena, made);
    for (int e = 0; status == MT_OK && e < (int)edges; e++)
        if (mesh->twin[e] < 0 && !border.taken[e])
            status = follow(&border, e, &made->components[part[e / 3]]);
    if (status != MT_OK) return status;
    for (int k = 0; k < made->count; k++) order(&made->components[k]);
    qsort(made->components, (size_t)made->count, sizeof *made->components, compare_components);
    return MT_OK;
}

/* ---- all of it ---------------------------------------------------------------------------------------------------- */

static mt_status make_anew(const mt_shape *given, mt_arena *arena, mt_shape *shape) {
    mt_rings rings, snapped;
    mt_half_edges mesh;
    mt_shape made = {0};
    int *part;
    mt_status status = mt_shape_rings(given, arena, &rings);
    if (status == MT_OK) status = mt_snap_rings(&rings, arena, &snapped);
    if (status == MT_OK) status = mt_triangulate(&snapped, arena, &mesh);
    if (status == MT_OK) status = join_over_rings(&mesh, arena);
    if (status == MT_OK) status = number_parts(&mesh, arena, &part, &made.count);
    if (status == MT_OK) status = take_borders(&mesh, part, arena, &made);
    assert(status != MT_OK || mt_shape_is_valid(&made));
    if (status == MT_OK) *shape = made;
    return status;
}

mt_status mt_shape_make_plain(const mt_shape *given, mt_arena *arena, mt_shape *shape) {
    bool plain;
    mt_status status = look(given, arena, &plain);
    if (status == MT_OK && !plain) return make_anew(given, arena, shape);
    if (status == MT_OK) *shape = *given;
    return status;
}
