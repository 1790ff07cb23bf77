/* Counting components and holes at MT_TOPOLOGY_STEPS places between the ends, and comparing them with both ends'.
 *
 *     A: 2 components       in-between: 3       B: 1 component       error 1: the range of the ends is 1 … 2
 *     A: 1 hole             in-between: 0       B: 1 hole            error 1, of which 1 opened
 *
 * A place with an error is looked at again with chords MT_OVERLAP_CARE times as fine, since chords may touch where curves do not. Seams
 * and crumbs do not count. Invariant: 0 for a morph from a shape to itself. O(n log n) in practice for n corners at each place. */
#include "morph/check/topology.h"

#include <math.h>

#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "morph/check/lulls.h"

/* ---- one shape ------------------------------------------------------------------------------------------- */

/* Twice an area in grid units squared, in square thousandths of the em. */
static double thousandths(double area2) {
    return area2 / 2 / (MT_EM / 1000.0) / (MT_EM / 1000.0);
}

static bool is_seam(const mt_ring *ring) {
    return fabs((double)mt_ring_area2(ring)) < MT_SEAM_WIDTH * mt_ring_length(ring);
}

static void count_part(double area2, int *parts, int *crumbs) {
    if (thousandths(area2) >= MT_CRUMB)
        ++*parts;
    else
        ++*crumbs;
}

mt_topology mt_topology_of(const mt_shape *shape) {
    mt_topology topology = {.area = thousandths((double)mt_shape_area2(shape)) / 1e6};
    for (int k = 0; k < shape->count; k++) {
        const mt_component *component = &shape->components[k];
        if (!is_seam(&component->rings[0]))
            count_part((double)mt_component_area2(component), &topology.components, &topology.crumbs);
        for (int i = 1; i < component->count; i++)
            if (!is_seam(&component->rings[i]))
                count_part((double)-mt_ring_area2(&component->rings[i]), &topology.holes, &topology.crumbs);
    }
    return topology;
}

/* ---- on the way ------------------------------------------------------------------------------------------ */

int mt_count_excess(int count, int a, int b) {
    int least = a < b ? a : b, most = a < b ? b : a;
    return count > most ? count - most : count < least ? least - count : 0;
}

double mt_area_excess(double area, double a, double b) {
    double most = fmax(a, b), least = fmin(a, b);
    return most > 0 ? fmax(0, fmax(area - most, least - area)) / most : 0;
}

double mt_topology_position(const mt_morph *morph, int number) {
    int from_half = (number + 1) / 2, half = (MT_TOPOLOGY_STEPS + 1) / 2;
    bool before = (number % 2 != 0) == (mt_shape_area2(&morph->a.whole) >= mt_shape_area2(&morph->b.whole));
    return (double)(before ? half - from_half : half + from_half) / (MT_TOPOLOGY_STEPS + 1);
}

static int more(int a, int b) {
    return a > b ? a : b;
}

static int fewer_than_both(int count, int a, int b) {
    return count < a && count < b ? mt_count_excess(count, a, b) : 0;
}

/* The state of counting. */
typedef struct mt_counting {
    const mt_morph *morph;
    mt_topology ends[2];
    const mt_params *params;
    mt_params fine; /* the same with finer chords */
    int enough;
    mt_arena *arena;
    mt_lulls lulls;
    bool *counted;                /* of each lull */
    double parts, merged, opened; /* as of mt_topology_error, not rounded */
    bool stays, proved;
    int64_t corners;
} mt_counting;

/* What was seen at one place. */
typedef struct mt_place_error {
    int parts, merged, opened;
    int crumbs;
    bool in_doubt; /* crumbs that may be larger elsewhere would leave the range */
} mt_place_error;

static bool is_in_doubt(const mt_counting *c, const mt_topology *at) {
    const mt_topology *a = &c->ends[0], *b = &c->ends[1];
    return at->crumbs > 0 && (at->components + at->crumbs > more(a->components, b->components) ||
                              at->holes + at->crumbs > more(a->holes, b->holes));
}

static mt_place_error error_of(const mt_counting *c, const mt_topology *at) {
    const mt_topology *a = &c->ends[0], *b = &c->ends[1];
    return (mt_place_error){.parts = mt_count_excess(at->components, a->components, b->components) +
                                     mt_count_excess(at->holes, a->holes, b->holes),
                            .merged = fewer_than_both(at->components, a->components, b->components),
                            .opened = fewer_than_both(at->holes, a->holes, b->holes),
                            .crumbs = at->crumbs,
                            .in_doubt = is_in_doubt(c, at)};
}

static mt_place_error worse(mt_place_error p, mt_place_error q) {
    bool in_doubt = p.in_doubt || q.in_doubt;
    p = q.parts > p.parts ? q : p;
    p.in_doubt = in_doubt;
    return p;
}

/* At one place, flattened within the params' tolerance: as it is drawn and, where rings lie over one another, as it is meant. */
static mt_status error_at(mt_counting *c, double t, const mt_params *params, mt_place_error *error) {
    mt_arena_place before = mt_arena_mark(c->arena);
    mt_rings rings;
    mt_shape drawn, meant;
    mt_topology at;
    mt_status status = mt_morph_rings(c->morph, mt_weights_at(t), params, c->arena, &rings);
    if (status == MT_OK) status = mt_union_unmarked(&rings, MT_NONZERO, c->arena, &drawn);
    if (status == MT_OK) {
        at = mt_topology_of(&drawn);
        *error = error_of(c, &at);
    }
    if (status == MT_OK && mt_component_area2(&rings) != mt_shape_area2(&drawn)) {
        status = mt_union_unmarked(&rings, MT_POSITIVE, c->arena, &meant);
        if (status == MT_OK) at = mt_topology_of(&meant);
        if (status == MT_OK) *error = worse(*error, error_of(c, &at));
    }
    if (status == MT_OK) c->corners += mt_rings_corners(&rings);
    if (status == MT_OK && error->in_doubt) c->proved = false;
    mt_arena_rewind(c->arena, before);
    return status;
}

/* Chords may touch where the curves do not: what strays is looked at again, more finely; all is, where the proof is of finer chords. */
static mt_status look(mt_counting *c, double t, mt_place_error *error) {
    if (c->lulls.known) return error_at(c, t, &c->fine, error);
    mt_status status = error_at(c, t, c->params, error);
    return status == MT_OK && error->parts > 0 ? error_at(c, t, &c->fine, error) : status;
}

/* twentieths: of the way, for which a place stands. */
static void add(mt_counting *c, const mt_place_error *error, double twentieths) {
    c->parts += twentieths * error->parts;
    c->merged += twentieths * error->merged;
    c->opened += twentieths * error->opened;
    if (error->parts > 0) c->stays = false;
}

static mt_status count_place(mt_counting *c, double t, double twentieths) {
    mt_place_error here;
    mt_status status = look(c, t, &here);
    if (status == MT_OK) add(c, &here, twentieths);
    return status;
}

static bool is_enough(const mt_counting *c) {
    return c->parts >= c->enough;
}

/* ---- lulls ----------------------------------------------------------------------------------------------------- */

/* Place number k in the order of T, 1 … MT_TOPOLOGY_STEPS. */
static double place_at(int k) {
    return (double)k / (MT_TOPOLOGY_STEPS + 1);
}

/* Whether every place has the rings of any other, all larger than crumbs and wider than seams. */
static bool is_all_alike(const mt_moving_edges *edges, const mt_lulls *lulls) {
    return lulls->plain && thousandths(edges->least_area2) >= MT_CRUMB && edges->least_width >= MT_SEAM_WIDTH;
}

static mt_status begin(mt_counting *c) {
    mt_moving_edges edges;
    mt_status status = mt_moving_edges_of(c->morph, mt_grid_units(c->fine.tolerance), c->arena, &edges);
    if (status == MT_OK)
        status = mt_find_lulls(&edges, mt_grid_units(c->fine.tolerance), c->arena, &c->lulls);
    if (status == MT_TOO_LARGE) c->lulls = (mt_lulls){0};
    if (status != MT_OK) return status == MT_TOO_LARGE ? MT_OK : status;
    c->corners = edges.edge_count;
    c->proved = c->lulls.known;
    c->lulls.plain = is_all_alike(&edges, &c->lulls);
    c->counted = mt_arena_new(c->arena, (size_t)c->lulls.count, sizeof *c->counted);
    return c->counted ? MT_OK : MT_NO_MEMORY;
}

/* Whether two places agree, and no crumbs can tell otherwise between them. */
static bool is_same(const mt_place_error *p, const mt_place_error *q) {
    return p->crumbs + q->crumbs == 0 && p->parts == q->parts && p->merged == q->merged &&
           p->opened == q->opened;
}

/* The places between the first and the last, but for k. */
static mt_status count_others(mt_counting *c, int first, int last, int k) {
    mt_status status = MT_OK;
    for (int i = first + 1; status == MT_OK && i < last; i++)
        if (i != k) status = count_place(c, place_at(i), 1);
    return status;
}

/* All places of a lull, of which k is the one nearest to half-way. The edges lie alike at all, so that only crumbs can make a difference:
 * if there are none at the first place, the last and this one, and all three are alike, so are the others. */
static mt_status count_lull(mt_counting *c, const mt_lull *lull, int k) {
    mt_place_error at_k, at_first, at_last;
    int first = k, last = k;
    while (first > 1 && place_at(first - 1) > lull->from) first--;
    while (last < MT_TOPOLOGY_STEPS && place_at(last + 1) < lull->to) last++;
    mt_status status = look(c, place_at(k), &at_k);
    at_first = at_last = at_k;
    bool alike = c->lulls.plain;
    if (status == MT_OK && !alike && first < k) status = look(c, place_at(first), &at_first);
    if (status == MT_OK && !alike && last > k) status = look(c, place_at(last), &at_last);
    if (status != MT_OK) return status;
    alike = alike || (is_same(&at_k, &at_first) && is_same(&at_k, &at_last));
    add(c, &at_k, alike ? last - first + 1 : 1);
    if (alike) return MT_OK;
    if (first < k) add(c, &at_first, 1);
    if (last > k) add(c, &at_last, 1);
    return count_others(c, first, last, k);
}

static int lull_at(const mt_counting *c, double t) {
    for (int i = 0; i < c->lulls.count; i++)
        if (c->lulls.lulls[i].from < t && t < c->lulls.lulls[i].to) return i;
    return -1;
}

/* A place, with all others of its lull; nothing if it is counted. */
static mt_status count_around(mt_counting *c, double t) {
    int lull = lull_at(c, t);
    if (lull < 0) return count_place(c, t, 1);
    if (c->counted[lull]) return MT_OK;
    c->counted[lull] = true;
    return count_lull(c, &c->lulls.lulls[lull], (int)lround(t * (MT_TOPOLOGY_STEPS + 1)));
}

/* The lulls that have no place: each stands for its own length. */
static mt_status count_between(mt_counting *c) {
    mt_status status = MT_OK;
    for (int i = 0; status == MT_OK && i < c->lulls.count && !is_enough(c); i++) {
        double from = c->lulls.lulls[i].from, length = c->lulls.lulls[i].to - from;
        if (!c->counted[i]) status = count_place(c, from + length / 2, length * (MT_TOPOLOGY_STEPS + 1));
    }
    return status;
}

mt_status mt_morph_topology_error(const mt_morph *morph, int enough, const mt_params *params, mt_arena *arena,
                                  mt_topology_error *error) {
    mt_counting c = {.morph = morph,
                     .ends = {mt_topology_of(&morph->a.whole), mt_topology_of(&morph->b.whole)},
                     .params = params,
                     .fine = *params,
                     .enough = enough,
                     .arena = arena,
                     .stays = true};
    mt_arena_place before = mt_arena_mark(arena);
    c.fine.tolerance /= MT_OVERLAP_CARE;
    mt_status status = begin(&c);
    for (int i = 0; status == MT_OK && i < MT_TOPOLOGY_STEPS && !is_enough(&c); i++)
        status = count_around(&c, mt_topology_position(morph, i));
    if (status == MT_OK) status = count_between(&c);
    mt_arena_rewind(arena, before);
    if (status == MT_OK)
        *error =
            (mt_topology_error){(int)c.parts, (int)c.merged, (int)c.opened, c.stays, c.proved, c.corners};
    return status;
}
