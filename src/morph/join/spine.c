/* A region is triangulated over its nodes. Its spine crosses each diagonal once, and meets itself in the middle of each triangle that has
 * three (L. Prasad, "Morphological analysis of shapes", 1997):
 *
 *     ──●────●──────●───●            ● nodes    ─┼─ where the spine crosses a diagonal
 *        ╲   │ ╲    │  ╱             A contour that goes around its nodes crosses the diagonals at each of them in the order
 *      ───┼──┼──┼───┼─┼──            in which they stand around it. It crosses each diagonal at both ends, and so goes along
 *          ╲ │   ╲  │╱               each line of the spine once on either side.
 *     ──────●─────●─●───
 *
 * The middle of a diagonal is between the middles of the largest discs that touch its two nodes: of a round spot, all are in one point.
 * A node with several diagonals has as many nodes in the open contour, in one place. O(n²) for n nodes, which is the discs. */
#include "morph/join/spine.h"

#include <math.h>
#include <stdlib.h>

#include "geometry/disc.h"
#include "geometry/triangulate.h"

/* An edge of the region's border in the mesh. */
typedef struct mt_border_edge {
    mt_point from, to;
    int edge;
} mt_border_edge;

typedef struct mt_spine {
    bool left;
    mt_half_edges mesh;
    mt_vector *middles; /* of the mesh's vertices */
    int *end_of;        /* of each triangle: the diagonal behind which it is an end; -1: it is in none */
    int border_count;
    mt_border_edge *border; /* sorted */
    mt_arena *arena;
} mt_spine;

static mt_point rounded(double x, double y) {
    return (mt_point){(int32_t)lround(x), (int32_t)lround(y)};
}

/* ---- the mesh -------------------------------------------------------------------------------------------- */

/* A contour's nodes, from its first segment's end on, with the region to the left. */
static mt_status nodes_of(const mt_contour *contour, bool left, mt_arena *arena, mt_ring *ring) {
    int n = contour->count;
    mt_status status = mt_ring_new(arena, n, ring);
    for (int i = 0; status == MT_OK && i < n; i++)
        ring->points[left ? i : n - 1 - i] = contour->segments[i].end;
    return status;
}

static mt_status find_middles(mt_spine *s, const mt_rings *rings) {
    s->middles = mt_arena_new(s->arena, (size_t)s->mesh.vertex_count, sizeof *s->middles);
    if (!s->middles) return MT_NO_MEMORY;
    for (int r = 0, v = 0; r < rings->count; r++)
        for (int i = 0; i < rings->rings[r].count; i++, v++) {
            mt_vector way = mt_way_to_middle(rings, r, i, true);
            s->middles[v] = (mt_vector){s->mesh.points[v].x + way.x, s->mesh.points[v].y + way.y};
        }
    return MT_OK;
}

static int compare_points(mt_point p, mt_point q) {
    return p.x != q.x ? (p.x > q.x) - (p.x < q.x) : (p.y > q.y) - (p.y < q.y);
}

static int compare_edges(const void *p, const void *q) {
    const mt_border_edge *a = p, *b = q;
    int from = compare_points(a->from, b->from);
    return from ? from : compare_points(a->to, b->to);
}

static mt_point start_of(const mt_half_edges *mesh, int e) {
    return mesh->points[mesh->start[e]];
}

static mt_status list_border(mt_spine *s) {
    const mt_half_edges *mesh = &s->mesh;
    int edges = 3 * mesh->triangle_count;
    s->border = mt_arena_new(s->arena, (size_t)edges, sizeof *s->border);
    if (!s->border) return MT_NO_MEMORY;
    for (int e = 0; e < edges; e++)
        if (mesh->twin[e] < 0)
            s->border[s->border_count++] =
                (mt_border_edge){start_of(mesh, e), start_of(mesh, mt_mesh_after(e)), e};
    qsort(s->border, (size_t)s->border_count, sizeof *s->border, compare_edges);
    return MT_OK;
}

/* ---- ends -------------------------------------------------------------------------------------------------- */

/* What lies behind a diagonal is an end, and no branch, where all of it lies around the diagonal's middle: the end of a stroke, a corner
 * that is a little out. The spine stops there. */
typedef struct mt_end {
    int edge;  /* the diagonal, with the end to the left */
    int count; /* of its triangles */
} mt_end;

typedef struct mt_end_search {
    const mt_half_edges *mesh;
    int *stack, *seen; /* seen[triangle]: the search that was there last */
    int number;
} mt_end_search;

/* Whether a place is no further from the middle of a diagonal than three quarters of its length. */
static bool is_around(const mt_half_edges *mesh, int diagonal, mt_point p) {
    mt_point a = start_of(mesh, diagonal), b = start_of(mesh, mt_mesh_after(diagonal));
    int64_t x = 2 * (int64_t)p.x - a.x - b.x, y = 2 * (int64_t)p.y - a.y - b.y;
    return 4 * (x * x + y * y) <= 9 * mt_distance2(a, b);
}

/* The triangles behind a diagonal, on the stack; 0 where they are no end. */
static int triangles_behind(mt_end_search *search, int diagonal) {
    const mt_half_edges *mesh = search->mesh;
    int count = 1, before = mesh->twin[diagonal] / 3;
    search->number++;
    search->stack[0] = diagonal / 3;
    search->seen[diagonal / 3] = search->number;
    for (int i = 0; i < count; i++)
        for (int e = 3 * search->stack[i]; e < 3 * search->stack[i] + 3; e++) {
            int twin = mesh->twin[e];
            if (!is_around(mesh, diagonal, start_of(mesh, e))) return 0;
            if (e == diagonal || twin < 0 || search->seen[twin / 3] == search->number) continue;
            if (twin / 3 == before) return 0;
            search->seen[twin / 3] = search->number;
            search->stack[count++] = twin / 3;
        }
    return count;
}

/* The largest first. */
static int compare_ends(const void *p, const void *q) {
    const mt_end *a = p, *b = q;
    return a->count != b->count ? b->count - a->count : a->edge - b->edge;
}

/* Gives an end its triangles, unless another has one of them. */
static void take_end(mt_spine *s, mt_end_search *search, int diagonal) {
    int count = triangles_behind(search, diagonal);
    for (int i = 0; i < count; i++)
        if (s->end_of[search->stack[i]] >= 0) return;
    for (int i = 0; i < count; i++) s->end_of[search->stack[i]] = diagonal;
}

static mt_status find_ends(mt_spine *s) {
    size_t triangles = (size_t)s->mesh.triangle_count;
    mt_end_search search = {&s->mesh, mt_arena_new(s->arena, triangles, sizeof(int)),
                            mt_arena_new(s->arena, triangles, sizeof(int)), 0};
    mt_end *ends = mt_arena_new(s->arena, 3 * triangles, sizeof *ends);
    s->end_of = mt_arena_new(s->arena, triangles, sizeof(int));
    if (!search.stack || !search.seen || !ends || !s->end_of) return MT_NO_MEMORY;
    int count = 0;
    for (size_t i = 0; i < triangles; i++) s->end_of[i] = -1;
    for (int e = 0; e < 3 * s->mesh.triangle_count; e++)
        if (s->mesh.twin[e] >= 0 && (ends[count] = (mt_end){e, triangles_behind(&search, e)}).count > 0)
            count++;
    qsort(ends, (size_t)count, sizeof *ends, compare_ends);
    for (int i = 0; i < count; i++) take_end(s, &search, ends[i].edge);
    return MT_OK;
}

static mt_status begin(mt_spine *s, const mt_outline *region) {
    mt_rings rings = {0, mt_arena_new(s->arena, (size_t)region->count, sizeof(mt_ring))};
    if (!rings.rings) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (; status == MT_OK && rings.count < region->count; rings.count++)
        status = nodes_of(&region->contours[rings.count], s->left, s->arena, &rings.rings[rings.count]);
    if (status == MT_OK) status = mt_triangulate(&rings, s->arena, &s->mesh);
    if (status == MT_OK) status = find_middles(s, &rings);
    if (status == MT_OK) status = list_border(s);
    return status == MT_OK ? find_ends(s) : status;
}

/* ---- places ------------------------------------------------------------------------------------------------ */

/* Where the spine crosses a diagonal; where this is in an end, where it crosses the diagonal before it. */
static mt_point crossing(const mt_spine *s, int e) {
    int end = s->end_of[e / 3];
    if (end >= 0 && end != e && end == s->end_of[s->mesh.twin[e] / 3]) e = end;
    mt_vector p = s->middles[s->mesh.start[e]], q = s->middles[s->mesh.start[mt_mesh_after(e)]];
    return rounded((p.x + q.x) / 2, (p.y + q.y) / 2);
}

static bool is_branching(const mt_half_edges *mesh, int triangle) {
    const int *twin = &mesh->twin[3 * triangle];
    return twin[0] >= 0 && twin[1] >= 0 && twin[2] >= 0;
}

static mt_point branching(const mt_spine *s, int triangle) {
    if (s->end_of[triangle] >= 0) return crossing(s, s->end_of[triangle]);
    mt_point p = crossing(s, 3 * triangle), q = crossing(s, 3 * triangle + 1),
             r = crossing(s, 3 * triangle + 2);
    return rounded(((double)p.x + q.x + r.x) / 3, ((double)p.y + q.y + r.y) / 3);
}

/* Appends a place, unless it is the last one. */
static int add_place(mt_point place, mt_point *places, int count) {
    if (count > 0 && mt_point_equal(places[count - 1], place)) return count;
    places[count] = place;
    return count + 1;
}

/* The places of the spine around a node, from the border edge that leaves it with the region to the left, to the one that arrives.
 * `places` has room for six times the triangles: each of their edges has two. */
static int places_around(const mt_spine *s, int border, mt_point *places) {
    const mt_half_edges *mesh = &s->mesh;
    int count = 0;
    for (int e = border;;) {
        int arriving = mt_mesh_after(mt_mesh_after(e));
        e = mesh->twin[arriving];
        if (e < 0) return count;
        count = add_place(crossing(s, arriving), places, count);
        if (is_branching(mesh, e / 3)) count = add_place(branching(s, e / 3), places, count);
    }
}

/* ---- the contours ------------------------------------------------------------------------------------------ */

/* The place of the border edge from one point to another; -1: none, since the contour touches itself or another there. */
static int find_edge(const mt_spine *s, mt_point from, mt_point to) {
    mt_border_edge key = {from, to, 0};
    const mt_border_edge *found =
        s->border_count ? bsearch(&key, s->border, (size_t)s->border_count, sizeof *s->border, compare_edges)
                        : NULL;
    return found ? found->edge : -1;
}

static mt_point node(const mt_contour *contour, int i) {
    return contour->segments[(i + contour->count) % contour->count].end;
}

/* The place of a node that no diagonal leads to. */
static mt_point tip(const mt_spine *s, int border, int vertex) {
    int end = border >= 0 ? s->end_of[border / 3] : -1;
    return end >= 0 ? crossing(s, end) : rounded(s->middles[vertex].x, s->middles[vertex].y);
}

/* The places that node i of a contour goes to, in the order in which the contour passes them: where it leads no diagonal, the middle of
 * its own disc. */
static int places_of(const mt_spine *s, const mt_contour *contour, int i, int vertex, mt_point *places) {
    mt_point here = node(contour, i);
    int border = find_edge(s, here, node(contour, s->left ? i + 1 : i - 1));
    int count = border < 0 ? 0 : places_around(s, border, places);
    if (count == 0) places[count++] = tip(s, border, vertex);
    for (int k = 0; s->left && k < count / 2; k++) {
        mt_point other = places[count - 1 - k];
        places[count - 1 - k] = places[k];
        places[k] = other;
    }
    return count;
}

static void append(const mt_segment *segment, const mt_point *places, int count, mt_contour *open,
                   mt_contour *shut) {
    for (int k = 0; k < count; k++) {
        mt_segment line = {.degree = 1, .end = segment->end};
        open->segments[open->count++] = k ? line : *segment;
        shut->segments[shut->count++] = (mt_segment){.degree = k ? 1 : segment->degree, .end = places[k]};
    }
}

static mt_status close_contour(const mt_spine *s, const mt_contour *contour, int first, mt_contour *open,
                               mt_contour *shut) {
    size_t around = 6 * (size_t)s->mesh.triangle_count, room = (size_t)contour->count + around;
    mt_point *places = mt_arena_new(s->arena, around + 1, sizeof *places);
    *open = (mt_contour){0, mt_arena_new(s->arena, room, sizeof(mt_segment))};
    *shut = (mt_contour){0, mt_arena_new(s->arena, room, sizeof(mt_segment))};
    if (!places || !open->segments || !shut->segments) return MT_NO_MEMORY;
    for (int i = 0; i < contour->count; i++) {
        int vertex = first + (s->left ? i : contour->count - 1 - i);
        int count = places_of(s, contour, i, vertex, places);
        append(&contour->segments[i], places, count, open, shut);
    }
    return MT_OK;
}

mt_status mt_spine_of(const mt_outline *region, bool left, mt_arena *arena, mt_outline *open,
                      mt_outline *shut) {
    mt_spine s = {.left = left, .arena = arena};
    size_t count = (size_t)region->count;
    *open = (mt_outline){0, mt_arena_new(arena, count, sizeof(mt_contour))};
    *shut = (mt_outline){0, mt_arena_new(arena, count, sizeof(mt_contour))};
    if (!open->contours || !shut->contours) return MT_NO_MEMORY;
    mt_status status = begin(&s, region);
    for (int i = 0, first = 0; status == MT_OK && i < region->count; first += region->contours[i++].count)
        status = close_contour(&s, &region->contours[i], first, &open->contours[open->count++],
                               &shut->contours[shut->count++]);
    return status;
}
