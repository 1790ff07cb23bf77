/* Constrained Delaunay triangulation, exact and near O(n log n).
 *
 *   1. Insert the vertices one by one along a Hilbert curve into a triangle around everything; each is found
 * by walking from the one before it, and edges that fail the in-circle test are flipped (C. L. Lawson,
 * "Software for C1 surface interpolation", 1977).
 *   2. Force each ring edge: flip the edges that cross it until none does (S. W. Sloan, "A fast algorithm for
 * generating constrained Delaunay triangulations", 1993). A vertex that lies on a ring edge splits it.
 *   3. Flip what is not locally Delaunay any more, ring edges excepted.
 *   4. Count windings inwards from the outside across ring edges, and keep the triangles that are ink.
 *
 * Invariants after each step: every triangle is anticlockwise with area; twin[twin[e]] = e; the two sides of
 * a diagonal start where the other ends; out[v] starts at v. Equal points are one vertex, the first of them
 * inserted. O(n²) at worst for n vertices. The figure of a flip is below. */
#include "geometry/triangulate.h"

#include <assert.h>
#include <stdlib.h>

#include "geometry/limits.h"

typedef struct mt_edge {
    int start, twin;
    int net; /* ring edges that run along it less those that run against it: the winding gained on its left */
    bool fixed;    /* some ring edge runs here */
    uint8_t marks; /* of the point where the ring edge along it starts */
} mt_edge;

typedef struct mt_triangulation {
    int vertex_count; /* without the three of the triangle around */
    mt_point *points;
    uint8_t *marks; /* of each point */
    mt_edge *edges;
    int edge_count;
    int *same; /* the vertex that stands for each */
    int *out;  /* a half-edge that starts at each */
    int *stack;
    int stack_count, stack_room;
    mt_arena *arena;
} mt_triangulation;

/* ---- half-edges ---------------------------------------------------------------------------------------- */

static int next(int e) {
    return e % 3 == 2 ? e - 2 : e + 1;
}

static int prev(int e) {
    return e % 3 == 0 ? e + 2 : e - 1;
}

static int start_of(const mt_triangulation *w, int e) {
    return w->edges[e].start;
}

static int end_of(const mt_triangulation *w, int e) {
    return w->edges[next(e)].start;
}

static mt_point at(const mt_triangulation *w, int e) {
    return w->points[w->edges[e].start];
}

/* Puts an edge into a slot, and tells its twin and its vertex where it is now. */
static void put(mt_triangulation *w, int slot, mt_edge edge) {
    w->edges[slot] = edge;
    if (edge.twin >= 0) w->edges[edge.twin].twin = slot;
    w->out[edge.start] = slot;
}

static void put_diagonal(mt_triangulation *w, int e, int start, int f, int end) {
    w->edges[f] = (mt_edge){.start = end, .twin = e};
    put(w, e, (mt_edge){.start = start, .twin = f});
    w->out[end] = f;
}

static bool push(mt_triangulation *w, int e) {
    if (w->stack_count == w->stack_room) {
        int room = 2 * w->stack_room;
        int *stack = mt_arena_new(w->arena, (size_t)room, sizeof *stack);
        if (!stack) return false;
        for (int i = 0; i < w->stack_count; i++) stack[i] = w->stack[i];
        w->stack = stack;
        w->stack_room = room;
    }
    w->stack[w->stack_count++] = e;
    return true;
}

/*         x                      x
 *       / | \                  /   \
 *      u--e--v  with  e   →   u     v  with e = y→x
 *       \ | /   u→v            \   /   in the left triangle
 *         y                      y                              The diagonal u–v becomes x–y. */
static void flip(mt_triangulation *w, int e) {
    int f = w->edges[e].twin;
    int e1 = next(e), e2 = prev(e), f1 = next(f), f2 = prev(f);
    mt_edge vx = w->edges[e1], xu = w->edges[e2], uy = w->edges[f1], yv = w->edges[f2];
    put(w, e1, xu);
    put(w, e2, uy);
    put(w, f1, yv);
    put(w, f2, vx);
    put_diagonal(w, e, yv.start, f, xu.start);
}

static bool is_delaunay(const mt_triangulation *w, int e) {
    int f = w->edges[e].twin;
    if (f < 0 || w->edges[e].fixed) return true;
    return mt_in_circle(at(w, e), at(w, next(e)), at(w, prev(e)), at(w, prev(f))) <= 0;
}

/* Flips what is on the stack, and what those flips disturb, until all of it is locally Delaunay. */
static mt_status legalise(mt_triangulation *w) {
    while (w->stack_count > 0) {
        int e = w->stack[--w->stack_count];
        if (is_delaunay(w, e)) continue;
        int f = w->edges[e].twin;
        flip(w, e);
        if (!push(w, next(e)) || !push(w, prev(e)) || !push(w, next(f)) || !push(w, prev(f)))
            return MT_NO_MEMORY;
    }
    return MT_OK;
}

/* ---- 1: the vertices ----------------------------------------------------------------------------------- */

/* Place along a Hilbert curve through a square of side 2^16 (the usual quadrant-by-quadrant descent). */
static uint32_t hilbert(uint32_t x, uint32_t y) {
    uint32_t place = 0;
    for (uint32_t s = 1u << 15; s > 0; s >>= 1) {
        uint32_t right = (x & s) != 0, upper = (y & s) != 0;
        place += s * s * ((3 * right) ^ upper);
        if (upper) continue;
        if (right) {
            x = ~x;
            y = ~y;
        }
        uint32_t swap = x;
        x = y;
        y = swap;
    }
    return place;
}

typedef struct mt_hilbert_key {
    uint32_t place;
    int vertex;
} mt_hilbert_key;

static int by_place(const void *p, const void *q) {
    const mt_hilbert_key *a = p, *b = q;
    if (a->place != b->place) return a->place < b->place ? -1 : 1;
    return (a->vertex > b->vertex) - (a->vertex < b->vertex);
}

/* The longer side of the points' box, at least 1. All that the insertion depends on is taken relative to the box's corner and
 * this side, so that a moved or scaled component is triangulated alike, ties included. */
static int64_t longer_side(mt_box box) {
    int64_t width = (int64_t)box.max.x - box.min.x, height = (int64_t)box.max.y - box.min.y;
    int64_t side = width > height ? width : height;
    return side > 0 ? side : 1;
}

static mt_hilbert_key *insertion_order(const mt_triangulation *w, mt_box box) {
    mt_hilbert_key *keys = mt_arena_new(w->arena, (size_t)w->vertex_count, sizeof *keys);
    if (!keys) return NULL;
    int64_t side = longer_side(box);
    for (int i = 0; i < w->vertex_count; i++) {
        uint32_t x = (uint32_t)(((int64_t)w->points[i].x - box.min.x) * 65535 / side);
        uint32_t y = (uint32_t)(((int64_t)w->points[i].y - box.min.y) * 65535 / side);
        keys[i] = (mt_hilbert_key){hilbert(x, y), i};
    }
    qsort(keys, (size_t)w->vertex_count, sizeof *keys, by_place);
    return keys;
}

/* A triangle that holds p, found by walking from half-edge e across edges that have p on their right. In a
 * Delaunay triangulation such a walk cannot go round in circles. */
static int locate(const mt_triangulation *w, int e, mt_point p) {
    for (int tried = 0; tried < 3; tried++, e = next(e)) {
        while (mt_orient(at(w, e), at(w, next(e)), p) < 0) {
            e = next(w->edges[e].twin);
            tried = 0;
        }
    }
    return e;
}

/* Fills slots e, e + 1, e + 2 with the triangle under `base` with apex p; the sides to p are left without
 * twins. */
static void put_fan(mt_triangulation *w, int e, mt_edge base, int end, int p) {
    w->edges[e + 1] = (mt_edge){.start = end, .twin = -1};
    put(w, e, base);
    put(w, e + 2, (mt_edge){.start = p, .twin = -1});
}

static void glue(mt_triangulation *w, int e, int f) {
    w->edges[e].twin = f;
    w->edges[f].twin = e;
}

/* Vertex p strictly inside the triangle of e: three triangles. */
static bool split_triangle(mt_triangulation *w, int e, int p) {
    int base[3] = {e - e % 3, w->edge_count, w->edge_count + 3};
    mt_edge side[3];
    for (int i = 0; i < 3; i++) side[i] = w->edges[base[0] + i];
    w->edge_count += 6;
    for (int i = 0; i < 3; i++) put_fan(w, base[i], side[i], side[(i + 1) % 3].start, p);
    for (int i = 0; i < 3; i++) glue(w, base[i] + 1, base[(i + 1) % 3] + 2);
    return push(w, base[0]) && push(w, base[1]) && push(w, base[2]);
}

/* Vertex p strictly inside edge e: four triangles around it, over the far sides of e's two triangles. */
static bool split_edge(mt_triangulation *w, int e, int p) {
    int f = w->edges[e].twin;
    mt_edge side[4] = {w->edges[next(e)], w->edges[prev(e)], w->edges[next(f)], w->edges[prev(f)]};
    int base[4] = {e - e % 3, w->edge_count, f - f % 3, w->edge_count + 3};
    w->edge_count += 6;
    for (int i = 0; i < 4; i++) put_fan(w, base[i], side[i], side[(i + 1) % 4].start, p);
    for (int i = 0; i < 4; i++) glue(w, base[i] + 1, base[(i + 1) % 4] + 2);
    return push(w, base[0]) && push(w, base[1]) && push(w, base[2]) && push(w, base[3]);
}

static mt_status insert(mt_triangulation *w, int vertex, int *near) {
    mt_point p = w->points[vertex];
    int e = locate(w, *near, p);
    w->same[vertex] = vertex;
    *near = e;
    for (int i = 0; i < 3; i++, e = next(e)) {
        if (!mt_point_equal(at(w, e), p)) continue;
        w->same[vertex] = start_of(w, e);
        return MT_OK;
    }
    bool room = false, on_edge = false;
    for (int i = 0; i < 3 && !on_edge; i++, e = next(e)) {
        on_edge = mt_orient(at(w, e), at(w, next(e)), p) == 0;
        if (on_edge) room = split_edge(w, e, vertex);
    }
    if (!on_edge) room = split_triangle(w, e, vertex);
    return room ? legalise(w) : MT_NO_MEMORY;
}

static mt_status insert_vertices(mt_triangulation *w) {
    int n = w->vertex_count;
    mt_ring all = {n, w->points, NULL};
    mt_box box = mt_ring_box(&all);
    int32_t far = (int32_t)(4 * longer_side(box)); /* the triangle around: four sides away, 16 long */
    w->points[n] = (mt_point){box.min.x - far, box.min.y - far};
    w->points[n + 1] = (mt_point){box.min.x + 3 * far, box.min.y - far};
    w->points[n + 2] = (mt_point){box.min.x - far, box.min.y + 3 * far};
    for (int i = 0; i < 3; i++) put(w, i, (mt_edge){.start = n + i, .twin = -1});
    w->edge_count = 3;
    mt_hilbert_key *keys = insertion_order(w, box);
    if (!keys) return MT_NO_MEMORY;
    int near = 0;
    for (int i = 0; i < n; i++) {
        mt_status status = insert(w, keys[i].vertex, &near);
        if (status != MT_OK) return status;
    }
    return MT_OK;
}

/* ---- 2: the ring edges --------------------------------------------------------------------------------- */

static void fix(mt_triangulation *w, int e, uint8_t marks) {
    int f = w->edges[e].twin;
    w->edges[e].fixed = w->edges[f].fixed = true;
    w->edges[e].marks = marks;
    w->edges[e].net++;
    w->edges[f].net--;
}

/* The half-edge at u along which, or the triangle at u through which, the segment to v leaves: either the edge
 * u→w with w on the segment, or the edge u→x such that the segment passes between x and the triangle's third corner. */
static int leave_towards(const mt_triangulation *w, int u, int v, bool *along) {
    mt_point p = w->points[u], q = w->points[v];
    int e = w->out[u];
    for (;;) {
        mt_point x = at(w, next(e)), y = at(w, prev(e));
        int64_t right = mt_orient(p, q, x), left = mt_orient(p, q, y);
        *along = right == 0 && mt_dot(p, x, p, q) > 0;
        if (*along || (right < 0 && left > 0)) return e;
        e = w->edges[prev(e)].twin; /* anticlockwise around u */
        assert(e != w->out[u]);
    }
}

/* Collects on the stack the ends of the edges between u's triangle e and the first vertex on the segment to v,
 * which becomes *reached. Ends, because slots move when edges are flipped. MT_BAD_GEOMETRY when a ring edge
 * crosses it. */
static mt_status collect_crossed(mt_triangulation *w, int e, int u, int v, int *reached) {
    mt_point p = w->points[u], q = w->points[v];
    e = next(e); /* across the triangle at u */
    for (;;) {
        if (w->edges[e].fixed) return MT_BAD_GEOMETRY;
        if (!push(w, start_of(w, e)) || !push(w, end_of(w, e))) return MT_NO_MEMORY;
        int f = w->edges[e].twin;
        int64_t side = mt_orient(p, q, at(w, prev(f)));
        if (side == 0) {
            *reached = start_of(w, prev(f));
            return MT_OK;
        }
        e = side > 0 ? next(f) : prev(f);
    }
}

/* The half-edge u→v, which is there: found by going around whichever end is no corner of the triangle around, since one
 * cannot go all around those. */
static int find_edge(const mt_triangulation *w, int u, int v) {
    int hub = u < w->vertex_count ? u : v, rim = hub == u ? v : u;
    int e = w->out[hub];
    while (end_of(w, e) != rim) e = w->edges[prev(e)].twin;
    return hub == u ? e : w->edges[e].twin;
}

/* Whether the two triangles beside e make a strictly convex quadrangle, so that e can be flipped. */
static bool can_flip(const mt_triangulation *w, int e) {
    int f = w->edges[e].twin;
    mt_point x = at(w, prev(e)), y = at(w, prev(f));
    return mt_orient(y, at(w, next(e)), x) > 0 && mt_orient(x, at(w, e), y) > 0;
}

/* One pass over the crossing edges in pairs[0 … 2 × count): flips each that can be. Those that cross u→v
 * still, or again, stay in pairs, in order, and their count is returned; those that do not any more go to the
 * front of the stack. */
static int flip_pass(mt_triangulation *w, int u, int v, int *pairs, int count, int *clear) {
    mt_point p = w->points[u], q = w->points[v];
    int kept = 0;
    *clear = 0;
    for (int i = 0; i < count; i++) {
        int e = find_edge(w, pairs[2 * i], pairs[2 * i + 1]);
        bool crosses = true;
        if (can_flip(w, e)) {
            flip(w, e);
            int64_t s = mt_orient(p, q, at(w, e)), t = mt_orient(p, q, at(w, next(e)));
            crosses = (s > 0 && t < 0) || (s < 0 && t > 0);
        }
        int *to = crosses ? &pairs[2 * kept++] : &w->stack[2 * (*clear)++];
        to[0] = start_of(w, e);
        to[1] = end_of(w, e);
    }
    return kept;
}

/* Flips away every edge whose ends are on the stack; leaves there, as half-edges, the new edges but u→v. */
static mt_status flip_crossed(mt_triangulation *w, int u, int v) {
    int all = w->stack_count / 2, count = all, clear_count = 0;
    int *pairs = mt_arena_new(w->arena, 2 * (size_t)all, sizeof *pairs);
    int *clear = mt_arena_new(w->arena, 2 * (size_t)all, sizeof *clear);
    if (!pairs || !clear) return MT_NO_MEMORY;
    for (int i = 0; i < 2 * all; i++) pairs[i] = w->stack[i];
    for (int pass = 0; count > 0; pass++) {
        if (pass > 2 * all + 16) return MT_BAD_GEOMETRY;
        int more;
        count = flip_pass(w, u, v, pairs, count, &more);
        for (int i = 0; i < 2 * more; i++) clear[2 * clear_count + i] = w->stack[i];
        clear_count += more;
    }
    for (int i = 0; i < clear_count; i++) w->stack[i] = find_edge(w, clear[2 * i], clear[2 * i + 1]);
    w->stack_count = clear_count;
    return MT_OK;
}

/* Makes the ring edge u→v an edge of the triangulation, in parts where vertices lie on it. */
static mt_status force_edge(mt_triangulation *w, int u, int v, uint8_t marks) {
    while (u != v) {
        bool along;
        int e = leave_towards(w, u, v, &along);
        int reached = end_of(w, e);
        if (!along) {
            mt_status status = collect_crossed(w, e, u, v, &reached);
            if (status == MT_OK) status = flip_crossed(w, u, reached);
            if (status != MT_OK) return status;
            e = find_edge(w, u, reached);
        }
        fix(w, e, marks);
        mt_status status = legalise(w); /* step 3, for what this edge disturbed */
        if (status != MT_OK) return status;
        marks = (uint8_t)(MT_CORNER | (marks & MT_EDGE_MARKS));
        u = reached;
    }
    return MT_OK;
}

static mt_status force_ring(mt_triangulation *w, int first, int count) {
    for (int i = 0; i < count; i++) {
        int u = w->same[first + i], v = w->same[first + (i + 1) % count];
        mt_status status = force_edge(w, u, v, w->marks[first + i]);
        if (status != MT_OK) return status;
    }
    return MT_OK;
}

/* ---- 4: the ink ---------------------------------------------------------------------------------------- */

enum { UNKNOWN = INT32_MIN };

/* The winding number of each triangle, from the outside inwards. */
static mt_status count_windings(mt_triangulation *w, int *winding) {
    for (int i = 0; i < w->edge_count / 3; i++) winding[i] = UNKNOWN;
    int outside = w->out[w->vertex_count] / 3;
    winding[outside] = 0;
    if (!push(w, outside)) return MT_NO_MEMORY;
    while (w->stack_count > 0) {
        int triangle = w->stack[--w->stack_count];
        for (int e = 3 * triangle; e < 3 * triangle + 3; e++) {
            int twin = w->edges[e].twin;
            if (twin < 0 || winding[twin / 3] != UNKNOWN) continue;
            winding[twin / 3] = winding[triangle] - w->edges[e].net;
            if (!push(w, twin / 3)) return MT_NO_MEMORY;
        }
    }
    return MT_OK;
}

static mt_status keep_ink(mt_triangulation *w, mt_half_edges *mesh) {
    int triangles = w->edge_count / 3;
    int *winding = mt_arena_new(w->arena, (size_t)triangles, sizeof *winding);
    int *place = mt_arena_new(w->arena, (size_t)triangles, sizeof *place);
    if (!winding || !place) return MT_NO_MEMORY;
    mt_status status = count_windings(w, winding);
    if (status != MT_OK) return status;
    int kept = 0;
    for (int i = 0; i < triangles; i++) place[i] = winding[i] > 0 ? kept++ : -1;
    mesh->triangle_count = kept;
    mesh->start = mt_arena_new(w->arena, 3 * (size_t)kept, sizeof(int));
    mesh->twin = mt_arena_new(w->arena, 3 * (size_t)kept, sizeof(int));
    mesh->marks = mt_arena_new(w->arena, 3 * (size_t)kept, sizeof(uint8_t));
    if (!mesh->start || !mesh->twin || !mesh->marks) return MT_NO_MEMORY;
    for (int e = 0; e < w->edge_count; e++) {
        if (place[e / 3] < 0) continue;
        int slot = 3 * place[e / 3] + e % 3, twin = w->edges[e].twin;
        bool diagonal = !w->edges[e].fixed && twin >= 0 && place[twin / 3] >= 0;
        uint8_t at_start = w->marks[w->edges[e].start] & MT_CORNER;
        mesh->marks[slot] = w->edges[e].fixed ? w->edges[e].marks : (uint8_t)(at_start | MT_LINE);
        mesh->start[slot] = w->edges[e].start;
        mesh->twin[slot] = diagonal ? 3 * place[twin / 3] + twin % 3 : -1;
    }
    return MT_OK;
}

/* ---- all of it ----------------------------------------------------------------------------------------- */

static mt_status gather(const mt_component *component, mt_triangulation *w, mt_half_edges *mesh) {
    int64_t total = 0;
    for (int i = 0; i < component->count; i++) total += component->rings[i].count;
    if (total > MT_POINTS_MAX) return MT_TOO_LARGE;
    size_t n = (size_t)total;
    w->vertex_count = (int)total;
    w->points = mt_arena_new(w->arena, n + 3, sizeof *w->points);
    w->edges = mt_arena_new(w->arena, 3 * (2 * n + 1), sizeof *w->edges);
    w->same = mt_arena_new(w->arena, n + 3, sizeof *w->same);
    w->out = mt_arena_new(w->arena, n + 3, sizeof *w->out);
    w->stack_room = 64;
    w->stack = mt_arena_new(w->arena, 64, sizeof *w->stack);
    w->marks = mt_arena_new(w->arena, n, sizeof *w->marks);
    if (!w->points || !w->edges || !w->same || !w->out || !w->stack || !w->marks) return MT_NO_MEMORY;
    int v = 0;
    for (int i = 0; i < component->count; i++) {
        const mt_ring *ring = &component->rings[i];
        for (int k = 0; k < ring->count; k++, v++) {
            mt_point p = ring->points[k];
            bool fits =
                p.x >= -MT_COORD_MAX && p.x <= MT_COORD_MAX && p.y >= -MT_COORD_MAX && p.y <= MT_COORD_MAX;
            if (!fits) return MT_TOO_LARGE;
            w->points[v] = p;
            w->marks[v] = ring->marks[k];
        }
    }
    mesh->points = w->points;
    mesh->vertex_count = w->vertex_count;
    return MT_OK;
}

mt_status mt_triangulate(const mt_component *component, mt_arena *arena, mt_half_edges *mesh) {
    mt_triangulation w = {.arena = arena};
    mt_half_edges made = {0};
    mt_status status = gather(component, &w, &made);
    if (status == MT_OK) status = insert_vertices(&w);
    for (int i = 0, first = 0; status == MT_OK && i < component->count; first += component->rings[i++].count)
        status = force_ring(&w, first, component->rings[i].count);
    if (status == MT_OK) status = keep_ink(&w, &made);
    assert(status != MT_OK || mt_half_edges_is_valid(&made));
    if (status == MT_OK) *mesh = made;
    return status;
}

bool mt_half_edges_is_valid(const mt_half_edges *mesh) {
    bool valid = mesh->triangle_count >= 0;
    for (int e = 0; valid && e < 3 * mesh->triangle_count; e++)
        valid = mesh->start[e] >= 0 && mesh->start[e] < mesh->vertex_count;
    for (int e = 0; valid && e < 3 * mesh->triangle_count; e++) {
        int after = mt_mesh_after(e), twin = mesh->twin[e];
        valid = mt_orient(mesh->points[mesh->start[e]], mesh->points[mesh->start[after]],
                          mesh->points[mesh->start[mt_mesh_after(after)]]) > 0;
        if (twin < 0) continue;
        valid = valid && twin < 3 * mesh->triangle_count && mesh->twin[twin] == e &&
                mesh->start[twin] == mesh->start[after] && mesh->start[mt_mesh_after(twin)] == mesh->start[e];
    }
    return valid;
}
