/* When edges meet that move on straight ways.
 *
 *     c ●          two edges that are apart, or cross, do so until a point of one comes to lie on the other: the
 *        ╲  ↓      sign of a quadratic (way.h). Two edges at one point: until one lies along the other.
 *     a ──╲────── b
 *          ● d     A point that slides over an edge with one neighbour on either side changes nothing: the crossing only
 *                  moves on to the next edge. All else is a meeting. Three edges that cross pairwise may do so in one point:
 *                  then nothing is proved.
 *
 * Pairs are found by a tree of boxes over the edges in their order, each box at the start and at the end of the ways: two boxes that
 * are apart along one axis at both are so all the way. Parts of displaced ways are looked at one after the other; where the first
 * ends counts to both. Invariant: no meeting is missed, and some that are found may be none, since places are told apart by 2^-20 of a part.
 * O(n log n + k) in practice for n edges and k pairs whose boxes meet; with more than PAIRS_MOST for each edge nothing is proved. */
#include "morph/check/lulls.h"

#include <math.h>
#include <stdlib.h>

/* Pairs of boxes looked at for each edge, and crossings in all, at most: glyphs have up to ten, and a few hundred. */
#define PAIRS_MOST 1000
#define CROSSINGS_MOST 4096

/* What an edge and a pair of boxes cost, in steps of the arena. */
enum { EDGE_STEPS = 64, PAIR_STEPS = 8 };

/* Lulls, at most: with more, nothing is proved. */
#define LULLS_MOST 64

/* A lull of this length is looked at, however fast points are. */
#define LONG_LULL 0.01

/* The edges from … to - 1, and the box around them at the start and at the end of a part. */
typedef struct mt_edge_box {
    mt_box at[2];
    int from, to;
} mt_edge_box;

typedef struct mt_finder {
    const mt_moving_edges *edges;
    const mt_way *ways; /* of the part at hand */
    int part;
    mt_steps all; /* of it */
    mt_arena *arena;
    mt_edge_box
        *tree; /* a node's first child follows it, the second follows that one's 2m - 1 nodes, of m edges */
    int64_t pairs; /* that may still be looked at */
    bool known, plain;
    int meeting_count, meeting_room;
    mt_lull *meetings;
    int crossing_count, crossing_room;
    mt_link *crossings; /* edges that cross at some place of the part, the lower first */
    mt_status status;
} mt_finder;

/* ---- boxes ------------------------------------------------------------------------------------------------------ */

static mt_edge_box box_of(const mt_finder *f, int edge) {
    const mt_way *a = &f->ways[f->edges->edges[edge].a], *b = &f->ways[f->edges->edges[edge].b];
    mt_edge_box made = {.from = edge, .to = edge + 1};
    for (int k = 0; k < 2; k++)
        made.at[k] = mt_box_around((mt_box){a->at[k], a->at[k]}, (mt_box){b->at[k], b->at[k]});
    return made;
}

static int second_child(int node, const mt_edge_box *box) {
    return node + 2 * ((box->to - box->from) / 2);
}

static void build(mt_finder *f, int node, int from, int to) {
    mt_edge_box *box = &f->tree[node];
    if (to - from == 1) {
        *box = box_of(f, from);
        return;
    }
    *box = (mt_edge_box){.from = from, .to = to};
    int middle = from + (to - from) / 2, second = second_child(node, box);
    build(f, node + 1, from, middle);
    build(f, second, middle, to);
    for (int k = 0; k < 2; k++) box->at[k] = mt_box_around(f->tree[node + 1].at[k], f->tree[second].at[k]);
}

/* Whether p is before q all along: at both ends, and not just touching at both. */
static bool is_before(const mt_finder *f, const int32_t p[2], const int32_t q[2]) {
    bool at_start = f->all.open_from ? p[0] <= q[0] : p[0] < q[0],
         at_end = f->all.open_to ? p[1] <= q[1] : p[1] < q[1];
    return at_start && at_end && (p[0] < q[0] || p[1] < q[1]);
}

static bool are_apart(const mt_finder *f, const mt_box p[2], const mt_box q[2]) {
    const int32_t p_right[] = {p[0].max.x, p[1].max.x}, q_left[] = {q[0].min.x, q[1].min.x},
                  q_right[] = {q[0].max.x, q[1].max.x}, p_left[] = {p[0].min.x, p[1].min.x},
                  p_top[] = {p[0].max.y, p[1].max.y}, q_bottom[] = {q[0].min.y, q[1].min.y},
                  q_top[] = {q[0].max.y, q[1].max.y}, p_bottom[] = {p[0].min.y, p[1].min.y};
    return is_before(f, p_right, q_left) || is_before(f, q_right, p_left) || is_before(f, p_top, q_bottom) ||
           is_before(f, q_top, p_bottom);
}

/* ---- meetings --------------------------------------------------------------------------------------------------- */

static double place_of(const mt_finder *f, int step) {
    return ((double)f->part + (double)step / MT_WAY_STEPS) / f->edges->part_count;
}

static void add_meeting(mt_finder *f, const mt_steps *steps) {
    mt_lull *list =
        mt_arena_grow_list(f->arena, f->meetings, f->meeting_count, &f->meeting_room, sizeof *list);
    if (!list) {
        f->status = MT_NO_MEMORY;
        return;
    }
    f->meetings = list;
    list[f->meeting_count++] = (mt_lull){place_of(f, steps->from), place_of(f, steps->to)};
}

static void add_crossing(mt_finder *f, int edge, int other) {
    f->plain = false;
    if (f->crossing_count == CROSSINGS_MOST) f->known = false;
    if (!f->known) return;
    mt_link *list =
        mt_arena_grow_list(f->arena, f->crossings, f->crossing_count, &f->crossing_room, sizeof *list);
    if (!list) {
        f->status = MT_NO_MEMORY;
        return;
    }
    f->crossings = list;
    list[f->crossing_count++] = (mt_link){edge < other ? edge : other, edge < other ? other : edge};
}

/* The side of the edge's line on which a point is all along these steps, or 0. */
static int side_of(const mt_finder *f, mt_link edge, int point, mt_steps steps) {
    return mt_steady_side(&f->ways[edge.a], &f->ways[edge.b], &f->ways[point], steps);
}

/* Whether a point passes to the other side of the edge, away from the edge's ends, with one neighbour on either side. */
static bool slides(const mt_finder *f, mt_link edge, int point, mt_steps steps) {
    const int *neighbours = &f->edges->neighbours[f->edges->first[point]];
    mt_steps start = {.from = steps.from, .to = steps.from}, end = {.from = steps.to, .to = steps.to};
    if (f->edges->first[point + 1] - f->edges->first[point] != 2) return false;
    return side_of(f, edge, point, start) * side_of(f, edge, point, end) < 0 &&
           side_of(f, edge, neighbours[0], steps) * side_of(f, edge, neighbours[1], steps) < 0 &&
           mt_stays_between(&f->ways[edge.a], &f->ways[edge.b], &f->ways[point], steps);
}

/* Looks when a point may be on an edge. Returns whether it ever is. */
static bool pass(mt_finder *f, mt_link edge, int point) {
    mt_steps found[MT_PASSES_MOST];
    int count = mt_passes(&f->ways[edge.a], &f->ways[edge.b], &f->ways[point], f->all, found);
    if (count < 0) f->known = false;
    for (int i = 0; i < count; i++)
        if (!slides(f, edge, point, found[i])) add_meeting(f, &found[i]);
    return count != 0;
}

static void fold(mt_finder *f, int point, int end, int other) {
    mt_steps found[MT_PASSES_MOST];
    int count = mt_folds(&f->ways[point], &f->ways[end], &f->ways[other], f->all, found);
    if (count < 0) f->known = false;
    for (int i = 0; i < count; i++) add_meeting(f, &found[i]);
}

static bool cross_half_way(const mt_finder *f, mt_link p, mt_link q) {
    mt_steps half = {.from = MT_WAY_STEPS / 2, .to = MT_WAY_STEPS / 2};
    return side_of(f, p, q.a, half) * side_of(f, p, q.b, half) < 0 &&
           side_of(f, q, p.a, half) * side_of(f, q, p.b, half) < 0;
}

/* Two edges without a point in common. */
static void meet(mt_finder *f, int edge, int other) {
    mt_link p = f->edges->edges[edge], q = f->edges->edges[other];
    if (side_of(f, p, q.a, f->all) * side_of(f, p, q.b, f->all) > 0) return;
    if (side_of(f, q, p.a, f->all) * side_of(f, q, p.b, f->all) > 0) return;
    bool ever = pass(f, p, q.a);
    ever = pass(f, p, q.b) || ever;
    ever = pass(f, q, p.a) || ever;
    ever = pass(f, q, p.b) || ever;
    if (ever || cross_half_way(f, p, q)) add_crossing(f, edge, other);
}

static void look(mt_finder *f, int edge, int other) {
    mt_link p = f->edges->edges[edge], q = f->edges->edges[other];
    if (p.a == q.a)
        fold(f, p.a, p.b, q.b);
    else if (p.a == q.b)
        fold(f, p.a, p.b, q.a);
    else if (p.b == q.a)
        fold(f, p.b, p.a, q.b);
    else if (p.b == q.b)
        fold(f, p.b, p.a, q.a);
    else
        meet(f, edge, other);
}

/* ---- pairs ------------------------------------------------------------------------------------------------------ */

static void look_between(mt_finder *f, int node, int other) {
    const mt_edge_box *p = &f->tree[node], *q = &f->tree[other];
    if (--f->pairs < 0) f->known = false;
    if (!f->known || f->status != MT_OK || are_apart(f, p->at, q->at)) return;
    int in_p = p->to - p->from, in_q = q->to - q->from;
    if (in_p == 1 && in_q == 1) {
        look(f, p->from, q->from);
    } else if (in_p >= in_q) {
        look_between(f, node + 1, other);
        look_between(f, second_child(node, p), other);
    } else {
        look_between(f, node, other + 1);
        look_between(f, node, second_child(other, q));
    }
}

static void look_within(mt_finder *f, int node) {
    const mt_edge_box *box = &f->tree[node];
    if (box->to - box->from == 1) return;
    look_within(f, node + 1);
    look_within(f, second_child(node, box));
    look_between(f, node + 1, second_child(node, box));
}

/* ---- three at once ---------------------------------------------------------------------------------------------- */

static bool do_cross(const mt_finder *f, int edge, int other) {
    const mt_link link = {edge, other};
    return bsearch(&link, f->crossings, (size_t)f->crossing_count, sizeof link, mt_link_compare) != NULL;
}

/* Whether there are three edges each two of which cross. */
static bool have_triangle(mt_finder *f) {
    if (f->crossing_count < 3) return false;
    qsort(f->crossings, (size_t)f->crossing_count, sizeof *f->crossings, mt_link_compare);
    for (int i = 0; i < f->crossing_count; i++)
        for (int k = i + 1; k < f->crossing_count && f->crossings[k].a == f->crossings[i].a; k++)
            if (do_cross(f, f->crossings[i].b, f->crossings[k].b)) return true;
    return false;
}

/* ---- lulls ------------------------------------------------------------------------------------------------------ */

static int by_start(const void *p, const void *q) {
    const mt_lull *x = p, *y = q;
    return x->from != y->from ? (x->from > y->from) - (x->from < y->from) : (x->to > y->to) - (x->to < y->to);
}

/* The share of the way from A to B on which no point gets farther. */
static double moment_of(const mt_moving_edges *edges, double far) {
    int64_t farthest = 1;
    for (int k = 0; k < edges->part_count; k++)
        for (int i = 0; i < edges->point_count; i++) {
            const mt_way *way = &edges->ways[k][i];
            int64_t x = llabs((int64_t)way->at[1].x - way->at[0].x),
                    y = llabs((int64_t)way->at[1].y - way->at[0].y);
            if (x > farthest) farthest = x;
            if (y > farthest) farthest = y;
        }
    return fmin(LONG_LULL, 2 * far / ((double)farthest * edges->part_count));
}

/* What is between the meetings. */
static int list_gaps(const mt_finder *f, mt_lull *gaps) {
    int count = 0;
    double end = 0;
    for (int i = 0; i < f->meeting_count; i++) {
        if (f->meetings[i].from > end) gaps[count++] = (mt_lull){end, f->meetings[i].from};
        end = fmax(end, f->meetings[i].to);
    }
    if (end < 1) gaps[count++] = (mt_lull){end, 1};
    return count;
}

/* Drops short gaps, but for several in a row that are not short together. */
static int drop_moments(mt_lull *gaps, int count, double moment) {
    int kept = 0;
    for (int i = 0, k; i < count; i = k) {
        for (k = i; k < count && gaps[k].to - gaps[k].from <= moment;) k++;
        bool is_short = k > i && gaps[k - 1].to - gaps[i].from <= moment;
        if (k == i) k++;
        for (int j = i; !is_short && j < k; j++) gaps[kept++] = gaps[j];
    }
    return kept;
}

static mt_status list_lulls(mt_finder *f, double far, mt_lulls *lulls) {
    mt_lull *gaps = mt_arena_new(f->arena, (size_t)f->meeting_count + 1, sizeof *gaps);
    if (!gaps) return MT_NO_MEMORY;
    if (f->meeting_count > 0) qsort(f->meetings, (size_t)f->meeting_count, sizeof *f->meetings, by_start);
    int count = drop_moments(gaps, list_gaps(f, gaps), moment_of(f->edges, far));
    if (count <= LULLS_MOST) *lulls = (mt_lulls){true, f->plain && f->meeting_count == 0, count, gaps};
    return MT_OK;
}

static void look_at_part(mt_finder *f) {
    f->ways = f->edges->ways[f->part];
    f->all = (mt_steps){0, MT_WAY_STEPS, f->part == 0, f->part + 1 == f->edges->part_count};
    f->crossing_count = 0;
    build(f, 0, 0, f->edges->edge_count);
    look_within(f, 0);
    if (f->known && f->status == MT_OK && have_triangle(f)) f->known = false;
}

mt_status mt_find_lulls(const mt_moving_edges *edges, double far, mt_arena *arena, mt_lulls *lulls) {
    mt_finder f = {.edges = edges,
                   .arena = arena,
                   .tree = mt_arena_new(arena, 2 * (size_t)edges->edge_count, sizeof *f.tree),
                   .pairs = (int64_t)PAIRS_MOST * (edges->edge_count + 1),
                   .known = true,
                   .plain = !edges->shared};
    *lulls = (mt_lulls){0};
    if (!f.tree) return MT_NO_MEMORY;
    for (f.part = 0; edges->edge_count > 0 && f.known && f.status == MT_OK && f.part < edges->part_count;
         f.part++)
        look_at_part(&f);
    int64_t looked = (int64_t)PAIRS_MOST * (edges->edge_count + 1) - f.pairs;
    bool paid = mt_arena_spend(arena, EDGE_STEPS * (int64_t)edges->edge_count + PAIR_STEPS * looked);
    if (f.status == MT_OK && !paid) return MT_TOO_LARGE;
    return f.status == MT_OK && f.known ? list_lulls(&f, far, lulls) : f.status;
}
