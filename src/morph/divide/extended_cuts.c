#include "morph/divide/extended_cuts.h"

#include <math.h>
#include <stdlib.h>

#include "geometry/inside.h"
#include "geometry/limits.h"

/* The longest overlap, 1/1000 em; the shortest that is worth while, and how often half of it is tried. */
#define LONGEST 120.0
#define SHORTEST 2.0
/* By how many times the gap the parts of the side with more ink are lengthened; those of the other by its inverse. */
#define LONGER 1.1
enum { TRIES = 4 };

/* An edge of a part's outer ring. */
typedef struct mt_division_edge {
    mt_point from, to;
    int part, at; /* the vertex that it leaves */
} mt_division_edge;

typedef struct mt_vector {
    double x, y;
} mt_vector;

/* ---- where parts meet ------------------------------------------------------------------------------------------- */

static int by_ends(const void *p, const void *q) {
    const mt_division_edge *a = p, *b = q;
    const int32_t keys[][2] = {
        {a->from.x, b->from.x}, {a->from.y, b->from.y}, {a->to.x, b->to.x}, {a->to.y, b->to.y}};
    for (int i = 0; i < 4; i++)
        if (keys[i][0] != keys[i][1]) return keys[i][0] < keys[i][1] ? -1 : 1;
    return (a->part > b->part) - (a->part < b->part);
}

static mt_status list_edges(const mt_shape *parts, mt_arena *arena, mt_division_edge **edges, int *count) {
    size_t total = 0;
    for (int i = 0; i < parts->count; i++) total += (size_t)parts->components[i].rings[0].count;
    *edges = mt_arena_new(arena, total, sizeof **edges);
    if (!*edges) return MT_NO_MEMORY;
    *count = 0;
    for (int i = 0; i < parts->count; i++) {
        const mt_ring *ring = &parts->components[i].rings[0];
        for (int k = 0; k < ring->count; k++)
            (*edges)[(*count)++] =
                (mt_division_edge){ring->points[k], ring->points[(k + 1) % ring->count], i, k};
    }
    qsort(*edges, (size_t)*count, sizeof **edges, by_ends);
    return MT_OK;
}

/* The same edge of another part, the other way round; NULL where none is. */
static const mt_division_edge *twin_of(const mt_division_edge *edges, int count,
                                       const mt_division_edge *edge) {
    int low = 0, high = count;
    mt_division_edge wanted = {edge->to, edge->from, -1, 0};
    while (low < high) {
        int middle = (low + high) / 2;
        if (by_ends(&edges[middle], &wanted) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    bool found = low < count && mt_point_equal(edges[low].from, wanted.from) &&
                 mt_point_equal(edges[low].to, wanted.to) && edges[low].part != edge->part;
    return found ? &edges[low] : NULL;
}

/* ---- how a part ends at a cut ----------------------------------------------------------------------------------- */

static mt_vector unit(mt_point from, mt_point to) {
    double x = (double)to.x - from.x, y = (double)to.y - from.y, length = hypot(x, y);
    return length > 0 ? (mt_vector){x / length, y / length} : (mt_vector){0, 0};
}

/* The way out of the part across its edge: on along its two sides, as far as they agree. */
static mt_vector way_on(const mt_ring *ring, int at) {
    int n = ring->count;
    mt_point before = ring->points[(at + n - 1) % n], p = ring->points[at], q = ring->points[(at + 1) % n],
             after = ring->points[(at + 2) % n];
    mt_vector edge = unit(p, q), in = unit(before, p), back = unit(after, q);
    mt_vector out = {edge.y, -edge.x}, way = {in.x + back.x, in.y + back.y};
    double length = hypot(way.x, way.y);
    bool ahead = length > 0 && way.x * out.x + way.y * out.y > 0.7 * length;
    return ahead ? (mt_vector){way.x / length, way.y / length} : out;
}

/* How much the ring turns into its edge and out of it: by two right angles where a stroke ends there, not at all where the
 * edge is a part of its side. */
static double turn_at(const mt_ring *ring, int at) {
    int n = ring->count;
    mt_point before = ring->points[(at + n - 1) % n], p = ring->points[at], q = ring->points[(at + 1) % n],
             after = ring->points[(at + 2) % n];
    mt_vector in = unit(before, p), edge = unit(p, q), out = unit(q, after);
    return atan2(in.x * edge.y - in.y * edge.x, in.x * edge.x + in.y * edge.y) +
           atan2(edge.x * out.y - edge.y * out.x, edge.x * out.x + edge.y * out.y);
}

/* ---- how far it may go ------------------------------------------------------------------------------------------- */

/* Whether two segments cross, each at an inner point of it. */
static bool do_cross(mt_point a, mt_point b, mt_point c, mt_point d) {
    int64_t p = mt_orient(a, b, c), q = mt_orient(a, b, d), r = mt_orient(c, d, a), s = mt_orient(c, d, b);
    return ((p > 0) != (q > 0)) && p != 0 && q != 0 && ((r > 0) != (s > 0)) && r != 0 && s != 0;
}

/* Whether the drawing's boundary keeps out of the flap p, p', q', q, and its far side is in the ink. */
static bool is_in_ink(const mt_shape *drawn, const mt_point flap[4]) {
    for (int c = 0; c < drawn->count; c++)
        for (int r = 0; r < drawn->components[c].count; r++) {
            const mt_ring *ring = &drawn->components[c].rings[r];
            for (int i = 0; i < ring->count; i++)
                for (int k = 0; k < 3; k++)
                    if (do_cross(ring->points[i], ring->points[(i + 1) % ring->count], flap[k], flap[k + 1]))
                        return false;
        }
    return mt_is_in_ink(drawn, flap[1]) && mt_is_in_ink(drawn, flap[2]);
}

static mt_point moved(mt_point p, mt_vector way, double by) {
    return (mt_point){p.x + (int32_t)lround(way.x * by), p.y + (int32_t)lround(way.y * by)};
}

/* ---- the overlap ------------------------------------------------------------------------------------------------- */

/* The part with a flap behind the edge that leaves vertex `at`. */
static mt_status put_flap(mt_component *part, int at, mt_point near, mt_point far, mt_arena *arena) {
    const mt_ring *ring = &part->rings[0];
    mt_ring made;
    mt_ring *rings = mt_arena_new(arena, (size_t)part->count, sizeof *rings);
    mt_status status = rings ? mt_ring_new(arena, ring->count + 2, &made) : MT_NO_MEMORY;
    if (status != MT_OK) return status;
    for (int i = 0, k = 0; i < ring->count; i++, k++) {
        made.points[k] = ring->points[i];
        made.marks[k] = ring->marks[i];
        if (i != at) continue;
        made.points[++k] = near;
        made.marks[k] = MT_CORNER | MT_LINE;
        made.points[++k] = far;
        made.marks[k] = MT_CORNER | MT_LINE;
    }
    rings[0] = made;
    for (int r = 1; r < part->count; r++) rings[r] = part->rings[r];
    part->rings = rings;
    return MT_OK;
}

/* Where the edge is now: flaps before it have moved it on. */
static int place_of(const mt_ring *ring, const mt_division_edge *edge) {
    int at = edge->at;
    while (!mt_point_equal(ring->points[at], edge->from) ||
           !mt_point_equal(ring->points[(at + 1) % ring->count], edge->to))
        at = (at + 1) % ring->count;
    return at;
}

static mt_status overlap(const mt_shape *drawn, mt_shape *parts, const mt_division_edge *edge, double length,
                         mt_arena *arena) {
    mt_component *part = &parts->components[edge->part];
    int at = place_of(&part->rings[0], edge);
    mt_vector way = way_on(&part->rings[0], at);
    double by = fmin(length, mt_grid_units(LONGEST));
    for (int i = 0; i < TRIES && by >= mt_grid_units(SHORTEST); i++, by /= 2) {
        const mt_point flap[4] = {edge->from, moved(edge->from, way, by), moved(edge->to, way, by), edge->to};
        if (is_in_ink(drawn, flap)) return put_flap(part, at, flap[1], flap[2], arena);
    }
    return MT_OK;
}

/* Lengthens the parts in `made`, which begin as those of `cut`, by so many times the gap that the other side has. */
static mt_status overlap_side(const mt_shape *drawn, const mt_cut_side *cut, const mt_cut_side *other,
                              double times, mt_shape *made, mt_arena *arena) {
    mt_division_edge *edges;
    int count;
    mt_status status = list_edges(&cut->parts, arena, &edges, &count);
    for (int i = 0; status == MT_OK && i < count; i++) {
        const mt_division_edge *edge = &edges[i], *twin = twin_of(edges, count, edge);
        if (!twin || edge->part > twin->part) continue;
        int p = cut->partner[edge->part], q = cut->partner[twin->part];
        if (p < 0 || q < 0) continue;
        mt_point way;
        double gap =
            mt_ring_gap(&other->parts.components[p].rings[0], &other->parts.components[q].rings[0], &way);
        bool ends = turn_at(&cut->parts.components[edge->part].rings[0], edge->at) >=
                    turn_at(&cut->parts.components[twin->part].rings[0], twin->at);
        status = overlap(drawn, made, ends ? edge : twin, times * gap, arena);
    }
    return status;
}

/* How far A's parts are lengthened, in gaps. What A has in one is parted at the place where what B has in one comes together: with
 * one gap on both sides that is half-way, where each would be parted already and not together yet. So it is a little to the
 * side of it: nearer to the end with less ink, whichever of the two that is. */
static double overlap_ratio(const mt_shape *in_a, const mt_shape *in_b) {
    int64_t a = mt_shape_area2(in_a), b = mt_shape_area2(in_b);
    return a > b ? LONGER : a < b ? 1 / LONGER : 1;
}

static mt_status copy(const mt_shape *shape, mt_arena *arena, mt_shape *made) {
    *made = (mt_shape){shape->count, mt_arena_new(arena, (size_t)shape->count, sizeof(mt_component))};
    if (!made->components) return MT_NO_MEMORY;
    for (int i = 0; i < shape->count; i++) made->components[i] = shape->components[i];
    return MT_OK;
}

mt_status mt_extend_cuts(const mt_shape *in_a, mt_cut_side *a, const mt_shape *in_b, mt_cut_side *b,
                         mt_arena *arena) {
    mt_shape made_a, made_b;
    mt_status status = copy(&a->parts, arena, &made_a);
    if (status == MT_OK) status = copy(&b->parts, arena, &made_b);
    double times = overlap_ratio(in_a, in_b);
    if (status == MT_OK) status = overlap_side(in_a, a, b, times, &made_a, arena);
    if (status == MT_OK) status = overlap_side(in_b, b, a, 1 / times, &made_b, arena);
    if (status != MT_OK) return status;
    a->parts = made_a;
    b->parts = made_b;
    return MT_OK;
}
