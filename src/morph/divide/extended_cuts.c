/* Extending parts beyond their cut, into the ink of the part on its other side.
 *
 *     ─────────┐   │        ─────────┬───┐        ─────────────┐      A's two strokes share a cut, B's have a gap g.
 *      part 0  │ g │         part 0  │ 1 │         part 0   ┊  │      Without extension they separate as soon as T > 0;
 *     ─────────┘   │        ─────────┴───┤        ──────────┊──┤      extended by g they separate half-way.
 *          B                     A       │            A     ┊ 1│
 *
 * Of the two parts the one extends that turns more at the cut: a stroke ends there, where the other runs past. It extends along its two
 * sides, at most LONGEST and as far as the drawing's own boundary does not cross the extension; half as far, and so on, where it does.
 * Invariant: the union of the parts stays the side's ink. O(e log e) for e edges of the parts, O(e) for each extension. */
#include "morph/divide/extended_cuts.h"

#include <math.h>
#include <stdlib.h>

#include "arithmetic/angles.h"
#include "geometry/inside.h"
#include "geometry/limits.h"

/* The longest extension and the shortest that matters, 1/1000 em; and how many lengths are tried, each half of the one before. */
#define LONGEST 120.0
#define SHORTEST 2.0
enum { LENGTHS = 4 };

/* Times the gap: the extension on the side with more ink; on the other it is the inverse. */
#define RATIO 1.1

/* The cosine of the angle to the edge's normal, at most, at which a part is still extended along its sides: 45 degrees. */
#define AHEAD_LEAST 0.7

/* An edge of a part's outer ring. */
typedef struct mt_part_edge {
    mt_point from, to;
    int part, at; /* the vertex that it leaves */
} mt_part_edge;

typedef struct mt_direction {
    double x, y;
} mt_direction;

/* ---- shared edges ----------------------------------------------------------------------------------------------- */

static int by_ends(const void *p, const void *q) {
    const mt_part_edge *a = p, *b = q;
    const int32_t keys[][2] = {
        {a->from.x, b->from.x}, {a->from.y, b->from.y}, {a->to.x, b->to.x}, {a->to.y, b->to.y}};
    for (int i = 0; i < 4; i++)
        if (keys[i][0] != keys[i][1]) return keys[i][0] < keys[i][1] ? -1 : 1;
    return (a->part > b->part) - (a->part < b->part);
}

static mt_status list_edges(const mt_shape *parts, mt_arena *arena, mt_part_edge **edges, int *count) {
    size_t total = 0;
    for (int i = 0; i < parts->count; i++) total += (size_t)parts->components[i].rings[0].count;
    *edges = mt_arena_new(arena, total, sizeof **edges);
    if (!*edges) return MT_NO_MEMORY;
    *count = 0;
    for (int i = 0; i < parts->count; i++) {
        const mt_ring *ring = &parts->components[i].rings[0];
        for (int k = 0; k < ring->count; k++)
            (*edges)[(*count)++] = (mt_part_edge){ring->points[k], ring->points[(k + 1) % ring->count], i, k};
    }
    qsort(*edges, (size_t)*count, sizeof **edges, by_ends);
    return MT_OK;
}

/* The reverse of an edge, on another part; NULL: there is none. */
static const mt_part_edge *twin_of(const mt_part_edge *edges, int count, const mt_part_edge *edge) {
    int low = 0, high = count;
    mt_part_edge wanted = {edge->to, edge->from, -1, 0};
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

/* ---- ends of parts at a cut ------------------------------------------------------------------------------------- */

static mt_direction unit(mt_point from, mt_point to) {
    double x = (double)to.x - from.x, y = (double)to.y - from.y, length = mt_hypot(x, y);
    return length > 0 ? (mt_direction){x / length, y / length} : (mt_direction){0, 0};
}

/* The direction out of the part across its edge: that of its two sides, or the edge's normal where they disagree. */
static mt_direction direction_out(const mt_ring *ring, int at) {
    int n = ring->count;
    mt_point before = ring->points[(at + n - 1) % n], p = ring->points[at], q = ring->points[(at + 1) % n],
             after = ring->points[(at + 2) % n];
    mt_direction edge = unit(p, q), in = unit(before, p), back = unit(after, q);
    mt_direction out = {edge.y, -edge.x}, direction = {in.x + back.x, in.y + back.y};
    double length = mt_hypot(direction.x, direction.y);
    bool ahead = length > 0 && direction.x * out.x + direction.y * out.y > AHEAD_LEAST * length;
    return ahead ? (mt_direction){direction.x / length, direction.y / length} : out;
}

/* The ring's turn into its edge and out of it: two right angles where a stroke ends at the edge, none where the edge is in its side. */
static double turn_at(const mt_ring *ring, int at) {
    int n = ring->count;
    mt_point before = ring->points[(at + n - 1) % n], p = ring->points[at], q = ring->points[(at + 1) % n],
             after = ring->points[(at + 2) % n];
    mt_direction in = unit(before, p), edge = unit(p, q), out = unit(q, after);
    return mt_atan2(in.x * edge.y - in.y * edge.x, in.x * edge.x + in.y * edge.y) +
           mt_atan2(edge.x * out.y - edge.y * out.x, edge.x * out.x + edge.y * out.y);
}

/* ---- room in the ink --------------------------------------------------------------------------------------------- */

/* Whether two segments cross at an inner point of both. */
static bool do_cross(mt_point a, mt_point b, mt_point c, mt_point d) {
    int64_t p = mt_orient(a, b, c), q = mt_orient(a, b, d), r = mt_orient(c, d, a), s = mt_orient(c, d, b);
    return ((p > 0) != (q > 0)) && p != 0 && q != 0 && ((r > 0) != (s > 0)) && r != 0 && s != 0;
}

/* The least turn from an extension's sides, which run anticlockwise, to a point given in halves of a grid unit: < 0 inside, 0 on the border. */
static int64_t outside(const mt_point tip[4], mt_point twice) {
    int64_t most = INT64_MIN;
    for (int k = 0; k < 4; k++) {
        mt_point p = tip[k], q = tip[(k + 1) % 4];
        int64_t turn = -mt_orient((mt_point){2 * p.x, 2 * p.y}, (mt_point){2 * q.x, 2 * q.y}, twice);
        if (turn > most) most = turn;
    }
    return most;
}

/* Whether an edge from border to border leads through the extension: along a white as wide as that, sides meet and do not cross. */
static bool leads_through(mt_point a, mt_point b, const mt_point tip[4]) {
    return outside(tip, (mt_point){2 * a.x, 2 * a.y}) <= 0 &&
           outside(tip, (mt_point){2 * b.x, 2 * b.y}) <= 0 &&
           outside(tip, (mt_point){a.x + b.x, a.y + b.y}) < 0;
}

/* Whether no edge of the drawing crosses the extension p, p', q', q, and its far corners are in the ink. */
static bool is_in_ink(const mt_shape *drawn, const mt_point tip[4]) {
    for (int c = 0; c < drawn->count; c++)
        for (int r = 0; r < drawn->components[c].count; r++) {
            const mt_ring *ring = &drawn->components[c].rings[r];
            for (int i = 0; i < ring->count; i++) {
                mt_point a = ring->points[i], b = ring->points[(i + 1) % ring->count];
                if (leads_through(a, b, tip)) return false;
                for (int k = 0; k < 3; k++)
                    if (do_cross(a, b, tip[k], tip[k + 1])) return false;
            }
        }
    return mt_is_in_ink(drawn, tip[1]) && mt_is_in_ink(drawn, tip[2]);
}

static mt_point moved(mt_point p, mt_direction direction, double by) {
    return (mt_point){p.x + (int32_t)lround(direction.x * by), p.y + (int32_t)lround(direction.y * by)};
}

/* ---- extending --------------------------------------------------------------------------------------------------- */

/* Extends the part at the edge that leaves vertex `at`. */
static mt_status add_extension(mt_component *part, int at, mt_point near, mt_point far, mt_arena *arena) {
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

/* The vertex that the edge leaves now: extensions before it have shifted it. */
static int place_of(const mt_ring *ring, const mt_part_edge *edge) {
    int at = edge->at;
    while (!mt_point_equal(ring->points[at], edge->from) ||
           !mt_point_equal(ring->points[(at + 1) % ring->count], edge->to))
        at = (at + 1) % ring->count;
    return at;
}

static mt_status extend_part(const mt_shape *drawn, mt_shape *parts, const mt_part_edge *edge, double length,
                             mt_arena *arena) {
    mt_component *part = &parts->components[edge->part];
    int at = place_of(&part->rings[0], edge);
    mt_direction direction = direction_out(&part->rings[0], at);
    double by = fmin(length, mt_grid_units(LONGEST));
    for (int i = 0; i < LENGTHS && by >= mt_grid_units(SHORTEST); i++, by /= 2) {
        const mt_point tip[4] = {edge->from, moved(edge->from, direction, by), moved(edge->to, direction, by),
                                 edge->to};
        if (is_in_ink(drawn, tip)) return add_extension(part, at, tip[1], tip[2], arena);
    }
    return MT_OK;
}

/* Extends the parts in `made`, at first those of `cut`, by `times` the gap between their partners on the other side. */
static mt_status extend_side(const mt_shape *drawn, const mt_cut_side *cut, const mt_cut_side *other,
                             double times, mt_shape *made, mt_arena *arena) {
    mt_part_edge *edges;
    int count;
    mt_status status = list_edges(&cut->parts, arena, &edges, &count);
    for (int i = 0; status == MT_OK && i < count; i++) {
        const mt_part_edge *edge = &edges[i], *twin = twin_of(edges, count, edge);
        if (!twin || edge->part > twin->part) continue;
        int p = cut->partner[edge->part], q = cut->partner[twin->part];
        if (p < 0 || q < 0) continue;
        mt_point direction;
        double gap = mt_ring_gap(&other->parts.components[p].rings[0], &other->parts.components[q].rings[0],
                                 &direction);
        bool ends = turn_at(&cut->parts.components[edge->part].rings[0], edge->at) >=
                    turn_at(&cut->parts.components[twin->part].rings[0], twin->at);
        status = extend_part(drawn, made, ends ? edge : twin, times * gap, arena);
    }
    return status;
}

/* The extension of A's parts, in gaps. With one gap on both sides, parts that A joins separate half-way, just where parts that B joins
 * meet: there both would be separate. So this happens nearer to the end with less ink, whichever of the two that is. */
static double overlap_ratio(const mt_shape *in_a, const mt_shape *in_b) {
    int64_t a = mt_shape_area2(in_a), b = mt_shape_area2(in_b);
    return a > b ? RATIO : a < b ? 1 / RATIO : 1;
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
    if (status == MT_OK) status = extend_side(in_a, a, b, times, &made_a, arena);
    if (status == MT_OK) status = extend_side(in_b, b, a, 1 / times, &made_b, arena);
    if (status != MT_OK) return status;
    a->parts = made_a;
    b->parts = made_b;
    return MT_OK;
}
