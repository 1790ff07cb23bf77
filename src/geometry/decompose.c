/* Convex decomposition (section 2.1): drop the diagonals of the triangulation, longest first, while both of
 * their ends stay convex. A diagonal that cannot be dropped is needed by a reflex vertex at one of its ends,
 * and stays needed, since angles only grow; no vertex needs more than two. So one pass is enough, and with r
 * reflex vertices at most 2r diagonals stay: at most 2r + 1 pieces, one fewer for each hole.
 *
 *     ┌──────┐        ┌──────┐
 *     │╲   ╱ │        │      │    the reflex vertex ● keeps one diagonal,
 *     │  ●───┘  ──▶   ├──●───┘    all others are dropped: two pieces
 *     └──┘            └──┘
 *
 * Invariants, checked each time: pieces are convex, and their areas add up to the component's exactly.
 * O(n log n) for n diagonals. */
#include "geometry/decompose.h"

#include <assert.h>
#include <stdlib.h>

#include "geometry/triangulate.h"

typedef struct mt_faces {
    const mt_half_edges *mesh;
    int *next, *prev; /* of each half-edge around its piece */
    bool *dropped;
} mt_faces;

typedef struct mt_diagonal {
    int64_t length2;
    int edge;
} mt_diagonal;

static int longest_first(const void *p, const void *q) {
    const mt_diagonal *a = p, *b = q;
    if (a->length2 != b->length2) return a->length2 > b->length2 ? -1 : 1;
    return (a->edge > b->edge) - (a->edge < b->edge);
}

static mt_point start_of(const mt_faces *faces, int e) {
    return faces->mesh->points[faces->mesh->start[e]];
}

/* The corner that dropping a diagonal would leave between edge `in` and edge `out`: at most 180°. Both of the
 * angles that it joins are under or at 180°, so that the sign of the turn decides; a fold back onto itself is
 * no corner. */
static bool stays_convex(const mt_faces *faces, int in, int out) {
    mt_point a = start_of(faces, in), b = start_of(faces, out), c = start_of(faces, faces->next[out]);
    int64_t turn = mt_orient(a, b, c);
    return turn > 0 || (turn == 0 && mt_dot(a, b, b, c) > 0);
}

static void drop_if_convex(mt_faces *faces, int e) {
    int f = faces->mesh->twin[e];
    int e_in = faces->prev[e], e_out = faces->next[e], f_in = faces->prev[f], f_out = faces->next[f];
    if (!stays_convex(faces, e_in, f_out) || !stays_convex(faces, f_in, e_out)) return;
    faces->next[e_in] = f_out;
    faces->prev[f_out] = e_in;
    faces->next[f_in] = e_out;
    faces->prev[e_out] = f_in;
    faces->dropped[e] = faces->dropped[f] = true;
}

static mt_status merge(mt_faces *faces, mt_arena *arena) {
    int edges = 3 * faces->mesh->triangle_count, count = 0;
    mt_diagonal *diagonals = mt_arena_new(arena, (size_t)edges / 2 + 1, sizeof *diagonals);
    if (!diagonals) return MT_NO_MEMORY;
    for (int e = 0; e < edges; e++) {
        int twin = faces->mesh->twin[e];
        if (twin <= e) continue;
        diagonals[count++] = (mt_diagonal){mt_distance2(start_of(faces, e), start_of(faces, twin)), e};
    }
    qsort(diagonals, (size_t)count, sizeof *diagonals, longest_first);
    for (int i = 0; i < count; i++) drop_if_convex(faces, diagonals[i].edge);
    return MT_OK;
}

static mt_status start_faces(const mt_half_edges *mesh, mt_arena *arena, mt_faces *faces) {
    size_t edges = 3 * (size_t)mesh->triangle_count;
    *faces = (mt_faces){mesh, mt_arena_new(arena, edges, sizeof(int)),
                        mt_arena_new(arena, edges, sizeof(int)), mt_arena_new(arena, edges, sizeof(bool))};
    if (!faces->next || !faces->prev || !faces->dropped) return MT_NO_MEMORY;
    for (int e = 0; e < (int)edges; e++) {
        faces->next[e] = e % 3 == 2 ? e - 2 : e + 1;
        faces->prev[e] = e % 3 == 0 ? e + 2 : e - 1;
    }
    return MT_OK;
}

/* ---- out ----------------------------------------------------------------------------------------------- */

/* The piece around half-edge e; its edges count as dropped afterwards, so that it comes out once. */
static mt_status take_piece(mt_faces *faces, int e, mt_arena *arena, mt_ring *piece) {
    int count = 0;
    for (int f = e; count == 0 || f != e; f = faces->next[f]) count++;
    mt_status status = mt_ring_new(arena, count, piece);
    if (status != MT_OK) return status;
    for (int i = 0; i < count; i++, e = faces->next[e]) {
        piece->points[i] = start_of(faces, e);
        piece->marks[i] = faces->mesh->marks[e];
        faces->dropped[e] = true;
    }
    return MT_OK;
}

static mt_status take_pieces(mt_faces *faces, mt_arena *arena, mt_pieces *pieces) {
    int triangles = faces->mesh->triangle_count;
    *pieces = (mt_pieces){0, mt_arena_new(arena, (size_t)triangles, sizeof(mt_ring))};
    if (!pieces->rings) return MT_NO_MEMORY;
    for (int e = 0; e < 3 * triangles; e++) {
        if (faces->dropped[e]) continue;
        mt_status status = take_piece(faces, e, arena, &pieces->rings[pieces->count]);
        if (status != MT_OK) return status;
        pieces->count++;
    }
    return MT_OK;
}

/* The promise of the header, checked each time: the sum of the areas is exact, and costs little beside the
 * rest. */
static bool keeps_promise(const mt_component *component, const mt_pieces *pieces) {
    int64_t area2 = 0;
    for (int i = 0; i < pieces->count; i++) area2 += mt_ring_area2(&pieces->rings[i]);
    return mt_pieces_is_valid(pieces) && area2 == mt_component_area2(component) &&
           pieces->count <= 2 * mt_reflex_count(component) + 1;
}

mt_status mt_decompose(const mt_component *component, mt_arena *arena, mt_pieces *pieces) {
    mt_half_edges mesh;
    mt_faces faces;
    mt_pieces made;
    mt_status status = mt_triangulate(component, arena, &mesh);
    if (status == MT_OK) status = start_faces(&mesh, arena, &faces);
    if (status == MT_OK) status = merge(&faces, arena);
    if (status == MT_OK) status = take_pieces(&faces, arena, &made);
    if (status != MT_OK) return status;
    if (!keeps_promise(component, &made)) return MT_BAD_GEOMETRY;
    *pieces = made;
    return MT_OK;
}

/* ---- reflex vertices ----------------------------------------------------------------------------------- */

static mt_point around(const mt_ring *ring, int i, int step) {
    mt_point p = ring->points[i];
    for (int k = 1; k < ring->count; k++) {
        mt_point q = ring->points[((i + step * k) % ring->count + ring->count) % ring->count];
        if (!mt_point_equal(p, q)) return q;
    }
    return p;
}

int mt_reflex_count(const mt_component *component) {
    int count = 0;
    for (int r = 0; r < component->count; r++) {
        const mt_ring *ring = &component->rings[r];
        for (int i = 0; i < ring->count; i++) {
            mt_point p = ring->points[i], a = around(ring, i, -1), c = around(ring, i, 1);
            if (mt_point_equal(p, ring->points[(i + 1) % ring->count]))
                continue; /* count a repeated point once */
            int64_t turn = mt_orient(a, p, c);
            count += turn < 0 || (turn == 0 && mt_dot(a, p, p, c) < 0);
        }
    }
    return count;
}
