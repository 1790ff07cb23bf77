/* Parts lengthened beyond their cuts, into the ink of the parts beside them. A cut is where two strokes meet. Where each ends is hidden
 * by the ink of the other, and comes to light as soon as the two part:
 *
 *     │   │      │   │                ┌────────       ┌────────
 *     │   │      │   │                │   ╱ its       ┆   ╱
 *    ─┴┄┄┄┴─    ─┼┄┄┄┼─  a stroke     │ ┄╱  corner    ┆  ╱     both sides go on
 *                │   │   goes on      │┄╱             ┆ ╱      until they meet
 *    ───────    ─└───┘─              ─┴╱              └╱
 *
 * 1. A stroke ends in that of two parts whose turn at the cut is more like half a turn. It goes on along its sides as far as its partner
 *    reaches, where the frames of both glyphs carry it (align/registration.h).
 * 2. A part that is cut through a corner turns less: its sides meet no further out than the cut is long, and go on until there.
 * 3. Where both sides are cut where the other has a gap, all would separate at once and join last, or all be one half-way: so parts go on
 *    by the gap between their partners instead, and separate half-way.
 * An extension is at most LONGEST, and half as long, and so on, where the drawing's own boundary crosses it. Invariant: the union of the
 * parts stays the side's ink. O(e log e) for e edges of the parts, O(e) for each extension. */
#include "morph/divide/extended_cuts.h"

#include <math.h>
#include <stdlib.h>

#include "arithmetic/angles.h"
#include "geometry/inside.h"
#include "geometry/limits.h"
#include "morph/align/view.h"

/* The longest extension and the shortest that matters, 1/1000 em: with less, the cut is overlapped anyway (between/seam_overlap.h). And how
 * many lengths are tried, each half of the one before. */
#define LONGEST 120.0
#define SHORTEST 4.0
enum { LENGTHS = 4 };

/* Times the gap: the extension on the side with more ink; on the other it is the inverse. */
#define RATIO 1.1

/* The cosine of the angle straight out of a part, at least, of a side that goes on beyond its end: of one that leads towards the other
 * side, and of one that leads away from it. */
#define TOWARDS_LEAST 0.05
#define AWAY_LEAST 0.7

/* The tangent of the angle by which a side turns inwards where the ink hides it, 6 degrees: there it keeps a corner, which smoothing does not
 * move (fit/smooth.h), so that what is drawn stays as it is. */
#define BEND 0.105

/* A part turns by that at a cut through its corner, at least, radians. */
#define CORNER_TURN 1.0

/* Samples of a partner's ring, at least. */
#define SAMPLES 60.0

/* The sine of a corner's turn, at least, by which its place is where its sides meet: others are smooth, or turn back. */
#define TURN_LEAST 0.3

/* An edge of a part's outer ring. */
typedef struct mt_part_edge {
    mt_point from, to;
    int part, at; /* the vertex that it leaves */
} mt_part_edge;

typedef struct mt_extending {
    const mt_side *here, *there; /* as they were before they were cut */
    double flatness;             /* grid units, of the rings */
    double gaps; /* extensions are as long as that many gaps between partners; 0: as is hidden */
    mt_arena *arena;
} mt_extending;

/* An extension: the cut's start, the far corners, the cut's end. */
typedef struct mt_tip {
    int count; /* 4, or 3 where both sides meet */
    mt_point points[4];
} mt_tip;

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

static mt_vector unit(mt_point from, mt_point to) {
    double x = (double)to.x - from.x, y = (double)to.y - from.y, length = mt_hypot(x, y);
    return length > 0 ? (mt_vector){x / length, y / length} : (mt_vector){0, 0};
}

static double dot(mt_vector p, mt_vector q) {
    return p.x * q.x + p.y * q.y;
}

static mt_vector reversed(mt_vector p) {
    return (mt_vector){-p.x, -p.y};
}

/* From one heading to the next, radians: > 0 to the left. */
static double turn_between(mt_vector p, mt_vector q) {
    return mt_atan2(p.x * q.y - p.y * q.x, dot(p, q));
}

/* A part's end at a cut. */
typedef struct mt_end {
    mt_point from, to; /* the cut */
    double length;     /* of the cut, grid units */
    mt_vector along, out;
    mt_vector start, finish; /* how both sides go on beyond the cut, for each unit out of the part */
    double meet;             /* how far out they meet; INFINITY: nowhere */
    double turn; /* of the part into the cut and out of it: half a turn where a stroke ends, none in a side */
} mt_end;

static mt_vector bent(mt_vector way, mt_vector inwards) {
    mt_vector beside = {-way.y, way.x};
    double bend = dot(beside, inwards) > 0 ? BEND : -BEND;
    return (mt_vector){way.x + bend * beside.x, way.y + bend * beside.y};
}

/* A side of the part goes on beyond the cut as it is drawn, but for BEND; straight out where it does not lead out, or leads out too
 * slantwise away from the other side. For each unit out. */
static mt_vector goes_on(mt_vector side, mt_vector out, mt_vector inwards) {
    double least = dot(inwards, side) > 0 ? TOWARDS_LEAST : AWAY_LEAST;
    mt_vector way = bent(side, inwards);
    if (dot(out, way) <= least) way = bent(out, inwards);
    double by = dot(out, way);
    return (mt_vector){way.x / by, way.y / by};
}

/* `at`: the vertex that the edge of the cut leaves; its ends are apart. */
static mt_end end_at(const mt_ring *ring, int at) {
    int n = ring->count;
    mt_point before = ring->points[(at + n - 1) % n], from = ring->points[at],
             to = ring->points[(at + 1) % n], after = ring->points[(at + 2) % n];
    mt_vector in = unit(before, from), along = unit(from, to), back = unit(to, after),
              out = {along.y, -along.x};
    mt_end end = {.from = from,
                  .to = to,
                  .length = sqrt((double)mt_distance2(from, to)),
                  .along = along,
                  .out = out,
                  .start = goes_on(in, out, along),
                  .finish = goes_on(reversed(back), out, reversed(along)),
                  .meet = INFINITY,
                  .turn = turn_between(in, along) + turn_between(along, back)};
    double closing = dot(along, end.start) - dot(along, end.finish);
    if (closing > 0) end.meet = end.length / closing;
    return end;
}

/* ---- room in the ink --------------------------------------------------------------------------------------------- */

/* Whether two segments cross at an inner point of both. */
static bool do_cross(mt_point a, mt_point b, mt_point c, mt_point d) {
    int64_t p = mt_orient(a, b, c), q = mt_orient(a, b, d), r = mt_orient(c, d, a), s = mt_orient(c, d, b);
    return ((p > 0) != (q > 0)) && p != 0 && q != 0 && ((r > 0) != (s > 0)) && r != 0 && s != 0;
}

/* The least turn from an extension's sides, which run anticlockwise, to a point given in halves of a grid unit: < 0 inside, 0 on the border. */
static int64_t outside(const mt_tip *tip, mt_point twice) {
    int64_t most = INT64_MIN;
    for (int k = 0; k < tip->count; k++) {
        mt_point p = tip->points[k], q = tip->points[(k + 1) % tip->count];
        int64_t turn = -mt_orient((mt_point){2 * p.x, 2 * p.y}, (mt_point){2 * q.x, 2 * q.y}, twice);
        if (turn > most) most = turn;
    }
    return most;
}

/* Whether an edge from border to border leads through the extension: along a white as wide as that, sides meet and do not cross. */
static bool leads_through(mt_point a, mt_point b, const mt_tip *tip) {
    return outside(tip, (mt_point){2 * a.x, 2 * a.y}) <= 0 &&
           outside(tip, (mt_point){2 * b.x, 2 * b.y}) <= 0 &&
           outside(tip, (mt_point){a.x + b.x, a.y + b.y}) < 0;
}

/* Whether no edge of the drawing crosses the extension, and its far corners are in the ink. */
static bool is_in_ink(const mt_shape *drawn, const mt_tip *tip) {
    for (int c = 0; c < drawn->count; c++)
        for (int r = 0; r < drawn->components[c].count; r++) {
            const mt_ring *ring = &drawn->components[c].rings[r];
            for (int i = 0; i < ring->count; i++) {
                mt_point a = ring->points[i], b = ring->points[(i + 1) % ring->count];
                if (leads_through(a, b, tip)) return false;
                for (int k = 0; k + 1 < tip->count; k++)
                    if (do_cross(a, b, tip->points[k], tip->points[k + 1])) return false;
            }
        }
    for (int k = 1; k + 1 < tip->count; k++)
        if (!mt_is_in_ink(drawn, tip->points[k])) return false;
    return true;
}

static mt_point moved(mt_point p, mt_vector direction, double by) {
    return (mt_point){p.x + (int32_t)lround(direction.x * by), p.y + (int32_t)lround(direction.y * by)};
}

/* The extension by a part's two sides, as far out as `reach`, or as where they meet. */
static mt_tip tip_at(const mt_end *end, double reach) {
    if (reach >= end->meet) return (mt_tip){3, {end->from, moved(end->from, end->start, end->meet), end->to}};
    return (mt_tip){
        4, {end->from, moved(end->from, end->start, reach), moved(end->to, end->finish, reach), end->to}};
}

/* ---- extending --------------------------------------------------------------------------------------------------- */

/* Puts an extension in the place of the edge that leaves vertex `at`. */
static mt_status add_extension(mt_component *part, int at, const mt_tip *tip, mt_arena *arena) {
    const mt_ring *ring = &part->rings[0];
    mt_ring made;
    mt_ring *rings = mt_arena_new(arena, (size_t)part->count, sizeof *rings);
    mt_status status = rings ? mt_ring_new(arena, ring->count + tip->count - 2, &made) : MT_NO_MEMORY;
    if (status != MT_OK) return status;
    for (int i = 0, k = 0; i < ring->count; i++) {
        made.points[k] = ring->points[i];
        made.marks[k++] = ring->marks[i];
        for (int t = 1; i == at && t + 1 < tip->count; t++) {
            made.points[k] = tip->points[t];
            made.marks[k++] = MT_CORNER | MT_LINE;
        }
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

/* How far out of a part a place lies; 0 where it is not in front of its end. */
static double beyond(const mt_end *end, mt_vector place) {
    mt_vector off = {place.x - end->from.x, place.y - end->from.y};
    double by = dot(end->along, off);
    return by < -end->length || by > 2 * end->length ? 0 : dot(end->out, off);
}

/* Where the frames carry a sample of the other side. A corner goes to where its two sides go, each moved along its own normal. */
static mt_vector carried(const mt_extending *e, const mt_ring_sample *sample) {
    mt_ring_sample in = *sample, out = *sample;
    in.out = sample->in;
    out.in = sample->out;
    mt_sample_view u = mt_sample_view_of(&in, &e->there->frame),
                   v = mt_sample_view_of(&out, &e->there->frame);
    mt_vector p = mt_place_of_view(&e->here->frame, &u), q = mt_place_of_view(&e->here->frame, &v);
    double turn = u.in_x * v.in_y - u.in_y * v.in_x, x = q.x - p.x, y = q.y - p.y;
    if (fabs(turn) < TURN_LEAST) return (mt_vector){p.x + x / 2, p.y + y / 2};
    double ahead = (x * v.in_y - y * v.in_x) / turn;
    return (mt_vector){p.x + ahead * u.in_x, p.y + ahead * u.in_y};
}

/* How far out of a part's end its partner reaches, where the frames carry it. */
static mt_status find_reach(const mt_extending *e, const mt_ring *partner, const mt_end *end, double *reach) {
    mt_arena_place before = mt_arena_mark(e->arena);
    mt_ring_samples samples;
    mt_status status = mt_ring_samples_at_least(partner, e->flatness, SAMPLES, e->arena, &samples);
    *reach = 0;
    for (int i = 0; status == MT_OK && i < samples.count; i++) {
        double by = beyond(end, carried(e, &samples.samples[i]));
        if (by <= mt_grid_units(LONGEST)) *reach = fmax(*reach, by);
    }
    mt_arena_rewind(e->arena, before);
    return status;
}

/* The same end, going on straight out. */
static mt_end straight(const mt_end *end) {
    mt_end made = *end;
    made.start = made.finish = end->out;
    made.meet = INFINITY;
    return made;
}

/* A corner of a part that the ink beyond its cut hides: where both sides meet no further out than the cut is long. */
static double hidden_corner(const mt_end *end) {
    return end->turn >= CORNER_TURN && end->meet <= end->length ? end->meet : 0;
}

/* Lengthens a part beyond its end, as far as there is ink. */
static mt_status lengthen(const mt_extending *e, mt_component *part, int at, const mt_end *end,
                          double length) {
    double by = fmin(fmin(length, end->meet), mt_grid_units(LONGEST));
    for (int i = 0; i < LENGTHS && by >= mt_grid_units(SHORTEST); i++, by /= 2) {
        mt_tip tip = tip_at(end, by);
        if (is_in_ink(&e->here->shape, &tip)) return add_extension(part, at, &tip, e->arena);
    }
    return MT_OK;
}

/* Lengthens the parts on both sides of a cut. Of the two, a stroke ends in the one whose turn is more like half a turn. */
static mt_status extend_at(const mt_extending *e, const mt_cut_side *cut, const mt_cut_side *other,
                           const mt_part_edge *const edges[2], mt_shape *made) {
    mt_component *parts[2];
    const mt_ring *partners[2];
    mt_end ends[2];
    int at[2];
    for (int k = 0; k < 2; k++) {
        parts[k] = &made->components[edges[k]->part];
        partners[k] = &other->parts.components[cut->partner[edges[k]->part]].rings[0];
        at[k] = place_of(&parts[k]->rings[0], edges[k]);
        ends[k] = end_at(&parts[k]->rings[0], at[k]);
    }
    int ending = fabs(ends[0].turn - M_PI) <= fabs(ends[1].turn - M_PI) ? 0 : 1;
    mt_point direction;
    double reach;
    if (e->gaps > 0) {
        double length = e->gaps * mt_ring_gap(partners[0], partners[1], &direction);
        mt_end end = length < ends[ending].meet ? ends[ending] : straight(&ends[ending]);
        return lengthen(e, parts[ending], at[ending], &end, length);
    }
    mt_status status = find_reach(e, partners[ending], &ends[ending], &reach);
    for (int k = 0; status == MT_OK && k < 2; k++)
        status =
            lengthen(e, parts[k], at[k], &ends[k], fmax(hidden_corner(&ends[k]), k == ending ? reach : 0));
    return status;
}

/* Extends the parts in `made`, at first those of `cut`. */
static mt_status extend_side(const mt_extending *e, const mt_cut_side *cut, const mt_cut_side *other,
                             mt_shape *made) {
    mt_part_edge *edges;
    int count;
    mt_status status = list_edges(&cut->parts, e->arena, &edges, &count);
    for (int i = 0; status == MT_OK && i < count; i++) {
        const mt_part_edge *edge = &edges[i], *twin = twin_of(edges, count, edge);
        if (!twin || edge->part > twin->part || mt_point_equal(edge->from, edge->to)) continue;
        if (cut->partner[edge->part] < 0 || cut->partner[twin->part] < 0) continue;
        status = extend_at(e, cut, other, (const mt_part_edge *[]){edge, twin}, made);
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

mt_status mt_extend_cuts(const mt_side *a, mt_cut_side *cut_a, const mt_side *b, mt_cut_side *cut_b,
                         bool is_cut_twice, double flatness, mt_arena *arena) {
    mt_shape made_a, made_b;
    mt_status status = copy(&cut_a->parts, arena, &made_a);
    if (status == MT_OK) status = copy(&cut_b->parts, arena, &made_b);
    double gaps = is_cut_twice ? overlap_ratio(&a->shape, &b->shape) : 0;
    mt_extending in_a = {a, b, flatness, gaps, arena},
                 in_b = {b, a, flatness, gaps > 0 ? 1 / gaps : 0, arena};
    if (status == MT_OK) status = extend_side(&in_a, cut_a, cut_b, &made_a);
    if (status == MT_OK) status = extend_side(&in_b, cut_b, cut_a, &made_b);
    if (status != MT_OK) return status;
    cut_a->parts = made_a;
    cut_b->parts = made_b;
    return MT_OK;
}
