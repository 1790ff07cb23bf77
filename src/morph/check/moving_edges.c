/* Rings of points with a place in A, one in B and a displacement half-way; points that are equal in all three are made one.
 *
 *     part 0: from 2A to A + B + 2d       part 1: from there to 2B       in half grid units, so that half-way is a whole number
 *
 * Invariants: no edge leads from a point to itself, no two edges are between the same points. O(n log n) for n points. */
#include "morph/check/moving_edges.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "geometry/limits.h"

/* ---- rings ------------------------------------------------------------------------------------------------------ */

typedef struct mt_corner_way {
    mt_point a, b, displacement;
    int place; /* in the order of the rings */
} mt_corner_way;

/* All rings, one after the other. */
typedef struct mt_corner_ways {
    int count, room;
    mt_corner_way *corners;
    int *next; /* of each, the one after it around its ring */
    mt_arena *arena;
} mt_corner_ways;

static mt_status make_room(mt_corner_ways *all, int more) {
    if (all->count + more <= all->room) return MT_OK;
    if (more > MT_POINTS_MAX - all->count) return MT_TOO_LARGE;
    int room = 2 * (all->count + more);
    mt_corner_way *corners = mt_arena_new(all->arena, (size_t)room, sizeof *corners);
    int *next = mt_arena_new(all->arena, (size_t)room, sizeof *next);
    if (!corners || !next) return MT_NO_MEMORY;
    if (all->count > 0) {
        memcpy(corners, all->corners, (size_t)all->count * sizeof *corners);
        memcpy(next, all->next, (size_t)all->count * sizeof *next);
    }
    all->corners = corners;
    all->next = next;
    all->room = room;
    return MT_OK;
}

static void add_corner(mt_corner_ways *all, mt_point a, mt_point b, mt_point displacement) {
    all->corners[all->count] = (mt_corner_way){a, b, displacement, all->count};
    all->next[all->count] = all->count + 1;
    all->count++;
}

static double cross(mt_point p, mt_point q) {
    return (double)p.x * q.y - (double)p.y * q.x;
}

/* Measures a ring that starts at a corner, at all T. Twice its area is a quadratic in T, no less than the least of its Bernstein coefficients;
 * its length is no more than at one of the ends. A displacement changes neither. */
static void measure(const mt_corner_ways *all, int start, mt_moving_edges *edges) {
    double area2[3] = {0}, length[2] = {0};
    for (int i = start; i < all->count; i++) {
        const mt_corner_way *p = &all->corners[i], *q = &all->corners[all->next[i]];
        area2[0] += cross(p->a, q->a);
        area2[1] += (cross(p->a, q->b) + cross(p->b, q->a)) / 2;
        area2[2] += cross(p->b, q->b);
        length[0] += sqrt((double)mt_distance2(p->a, q->a));
        length[1] += sqrt((double)mt_distance2(p->b, q->b));
    }
    double low = fmin(area2[0], fmin(area2[1], area2[2])), high = fmax(area2[0], fmax(area2[1], area2[2]));
    double least = low > 0 ? low : high < 0 ? -high : 0;
    edges->least_area2 = fmin(edges->least_area2, least);
    edges->least_width = fmin(edges->least_width, least / fmax(1, fmax(length[0], length[1])));
}

static void close_ring(mt_corner_ways *all, int start, mt_moving_edges *edges) {
    all->next[all->count - 1] = start;
    measure(all, start, edges);
}

static mt_status add_contour(mt_corner_ways *all, const mt_contour_pair *contour, double tolerance,
                             mt_moving_edges *edges) {
    mt_ring a, b;
    mt_status status = mt_flatten_alike(&contour->a, &contour->b, tolerance, all->arena, &a, &b);
    if (status == MT_OK) status = make_room(all, a.count);
    if (status != MT_OK || a.count == 0) return status;
    int start = all->count;
    for (int i = 0; i < a.count; i++) add_corner(all, a.points[i], b.points[i], contour->displacement);
    close_ring(all, start, edges);
    return MT_OK;
}

static mt_status add_link(mt_corner_ways *all, const mt_ring *p, const mt_ring *q, mt_moving_edges *edges) {
    mt_corner *corners = mt_arena_new(all->arena, (size_t)p->count + (size_t)q->count, sizeof *corners);
    if (!corners) return MT_NO_MEMORY;
    int start = all->count, count = mt_minkowski_corners(p, q, corners);
    mt_status status = make_room(all, count);
    if (status != MT_OK) return status;
    for (int i = 0; i < count; i++)
        add_corner(all, p->points[corners[i].p], q->points[corners[i].q], (mt_point){0, 0});
    close_ring(all, start, edges);
    return MT_OK;
}

static mt_status gather(const mt_morph *morph, double tolerance, mt_corner_ways *all,
                        mt_moving_edges *edges) {
    mt_status status = MT_OK;
    for (int i = 0; status == MT_OK && i < morph->contour_count; i++)
        status = add_contour(all, &morph->contours[i], tolerance, edges);
    for (int i = 0; status == MT_OK && i < morph->links.count; i++)
        status = add_link(all, &morph->a.pieces.rings[morph->links.links[i].a],
                          &morph->b.pieces.rings[morph->links.links[i].b], edges);
    return status;
}

/* ---- points ----------------------------------------------------------------------------------------------------- */

static int compare_points(mt_point p, mt_point q) {
    return p.y != q.y ? (p.y > q.y) - (p.y < q.y) : (p.x > q.x) - (p.x < q.x);
}

static int compare_ways(const mt_corner_way *p, const mt_corner_way *q) {
    int order = compare_points(p->a, q->a);
    if (order == 0) order = compare_points(p->b, q->b);
    return order != 0 ? order : compare_points(p->displacement, q->displacement);
}

static int by_way(const void *p, const void *q) {
    const mt_corner_way *c = p, *d = q;
    int order = compare_ways(c, d);
    return order != 0 ? order : (c->place > d->place) - (c->place < d->place);
}

static bool is_within(mt_point p) {
    return abs(p.x) <= MT_WAY_MOST && abs(p.y) <= MT_WAY_MOST;
}

static bool add_point(mt_moving_edges *edges, const mt_corner_way *c) {
    mt_point start = {2 * c->a.x, 2 * c->a.y}, end = {2 * c->b.x, 2 * c->b.y};
    mt_point half = {c->a.x + c->b.x + 2 * c->displacement.x, c->a.y + c->b.y + 2 * c->displacement.y};
    if (edges->part_count == 1) half = end;
    edges->ways[0][edges->point_count] = (mt_way){{start, half}};
    edges->ways[1][edges->point_count++] = (mt_way){{half, end}};
    return is_within(start) && is_within(half) && is_within(end);
}

/* numbers: of each corner, its point. Sorts the corners. */
static mt_status number_points(mt_corner_ways *all, int *numbers, mt_arena *arena, mt_moving_edges *edges) {
    for (int k = 0; k < 2; k++) {
        edges->ways[k] = mt_arena_new(arena, (size_t)all->count, sizeof(mt_way));
        if (!edges->ways[k]) return MT_NO_MEMORY;
    }
    qsort(all->corners, (size_t)all->count, sizeof *all->corners, by_way);
    for (int i = 0; i < all->count; i++) {
        bool is_new = i == 0 || compare_ways(&all->corners[i - 1], &all->corners[i]) != 0;
        if (is_new && !add_point(edges, &all->corners[i])) return MT_TOO_LARGE;
        numbers[all->corners[i].place] = edges->point_count - 1;
    }
    return MT_OK;
}

/* ---- edges ------------------------------------------------------------------------------------------------------ */

typedef struct mt_placed_edge {
    mt_link edge; /* the lower point first */
    int place;
} mt_placed_edge;

static int by_points(const void *p, const void *q) {
    const mt_placed_edge *e = p, *f = q;
    if (e->edge.a != f->edge.a) return (e->edge.a > f->edge.a) - (e->edge.a < f->edge.a);
    if (e->edge.b != f->edge.b) return (e->edge.b > f->edge.b) - (e->edge.b < f->edge.b);
    return (e->place > f->place) - (e->place < f->place);
}

static int by_place(const void *p, const void *q) {
    const mt_placed_edge *e = p, *f = q;
    return (e->place > f->place) - (e->place < f->place);
}

static int list_edges(const mt_corner_ways *all, const int *numbers, mt_placed_edge *placed) {
    int count = 0;
    for (int i = 0; i < all->count; i++) {
        int p = numbers[i], q = numbers[all->next[i]];
        if (p != q) placed[count++] = (mt_placed_edge){{p < q ? p : q, p < q ? q : p}, i};
    }
    return count;
}

/* Leaves the first of equal edges, in the order of the rings. */
static int drop_equals(mt_placed_edge *placed, int count) {
    int kept = 0;
    qsort(placed, (size_t)count, sizeof *placed, by_points);
    for (int i = 0; i < count; i++)
        if (kept == 0 || placed[i].edge.a != placed[kept - 1].edge.a ||
            placed[i].edge.b != placed[kept - 1].edge.b)
            placed[kept++] = placed[i];
    qsort(placed, (size_t)kept, sizeof *placed, by_place);
    return kept;
}

static mt_status connect(const mt_corner_ways *all, const int *numbers, mt_arena *arena,
                         mt_moving_edges *edges) {
    mt_placed_edge *placed = mt_arena_new(arena, (size_t)all->count, sizeof *placed);
    if (!placed) return MT_NO_MEMORY;
    edges->edge_count = drop_equals(placed, list_edges(all, numbers, placed));
    edges->edges = mt_arena_new(arena, (size_t)edges->edge_count, sizeof *edges->edges);
    edges->first = mt_arena_new(arena, (size_t)edges->point_count + 2, sizeof *edges->first);
    edges->neighbours = mt_arena_new(arena, 2 * (size_t)edges->edge_count, sizeof *edges->neighbours);
    if (!edges->edges || !edges->first || !edges->neighbours) return MT_NO_MEMORY;
    for (int i = 0; i < edges->edge_count; i++) {
        mt_link e = edges->edges[i] = placed[i].edge;
        edges->first[e.a + 2]++;
        edges->first[e.b + 2]++;
    }
    for (int k = 0; k < edges->point_count; k++) edges->first[k + 2] += edges->first[k + 1];
    for (int i = 0; i < edges->edge_count;
         i++) { /* first[k + 1] goes from the start of k's neighbours to their end */
        mt_link e = edges->edges[i];
        edges->neighbours[edges->first[e.a + 1]++] = e.b;
        edges->neighbours[edges->first[e.b + 1]++] = e.a;
    }
    return MT_OK;
}

static int part_count(const mt_morph *morph) {
    for (int i = 0; i < morph->contour_count; i++)
        if (!mt_point_equal(morph->contours[i].displacement, (mt_point){0, 0})) return 2;
    return 1;
}

mt_status mt_moving_edges_of(const mt_morph *morph, double tolerance, mt_arena *arena,
                             mt_moving_edges *edges) {
    mt_corner_ways all = {.arena = arena};
    mt_moving_edges made = {
        .part_count = part_count(morph), .least_area2 = INFINITY, .least_width = INFINITY};
    mt_status status = gather(morph, tolerance, &all, &made);
    if (status != MT_OK) return status;
    int *numbers = mt_arena_new(arena, (size_t)all.count, sizeof *numbers);
    if (!numbers) return MT_NO_MEMORY;
    status = number_points(&all, numbers, arena, &made);
    made.shared = made.point_count < all.count;
    if (status == MT_OK) status = connect(&all, numbers, arena, &made);
    if (status == MT_OK) *edges = made;
    return status;
}
