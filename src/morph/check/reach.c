/* On the way from a place that holds, topology is looked at in the order in which places come, and only where it may have changed.
 *
 *     T = 1                                                        T = 2
 *       |----- lull ------|· |------- lull -------|·|--- lull ---|
 *              good                  good              a hole is lost: the morph goes as far as here ┘ (the second lull's end)
 *
 * During a lull (lulls.h) nothing meets, and where no contour becomes a crumb or a seam meanwhile one look is enough for all of it: where
 * one lull goes all along, none is. Otherwise looks are LOOK apart, and one more is in each lull between two of them. Sums of links, and
 * contours that a displacement bends on the way, are not known to have lulls. */
#include "morph/check/reach.h"

#include <math.h>

#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "morph/check/lulls.h"
#include "morph/check/topology.h"
#include "morph/fit/contour_pair.h"

/* Between two looks, of the way. */
#define LOOK (1.0 / 16)

/* How near to a bad place a morph goes where nothing is proved. */
#define NEAR (1.0 / 1024)

/* Where a lull ends, edges touch: a morph stays within. */
#define WITHIN (63.0 / 64)

/* A straight way out of a place. */
typedef struct mt_outskirts {
    const mt_morph *morph;
    mt_at from, to;
    mt_topology least, most; /* what is good */
    mt_params fine;          /* with chords for what may overlap */
    mt_lulls lulls;          /* 0: `from`, 1: `to` */
    bool alike;              /* nothing changes at all */
    mt_arena *arena;
} mt_outskirts;

/* ---- contours on the way --------------------------------------------------------------------------------- */

static mt_weights weights_at(const mt_outskirts *o, double share) {
    return mt_weights_of(mt_at_between(o->from, o->to, share));
}

/* A contour at both ends of the way. */
static mt_status go_on(const mt_outskirts *o, const mt_contour_pair *pair, mt_contour_pair *outer) {
    *outer = (mt_contour_pair){0};
    mt_status status = mt_contour_pair_mix(pair, weights_at(o, 0), o->arena, &outer->a);
    return status == MT_OK ? mt_contour_pair_mix(pair, weights_at(o, 1), o->arena, &outer->b) : status;
}

/* Whether all contours move straight; between the ends, those do not that a displacement bends. */
static bool is_straight(const mt_outskirts *o) {
    bool outside = o->from.x == o->from.y && o->to.x == o->to.y; /* past an end */
    for (int i = 0; i < o->morph->contour_count && !outside; i++) {
        mt_point by = o->morph->contours[i].displacement;
        if (by.x != 0 || by.y != 0) return false;
    }
    return o->morph->links.count == 0;
}

static mt_status find_lulls(mt_outskirts *o) {
    const mt_morph *morph = o->morph;
    double tolerance = mt_grid_units(o->fine.tolerance);
    mt_moving_edges edges;
    mt_morph outer = {.contour_count = morph->contour_count};
    if (!is_straight(o)) return MT_OK;
    outer.contours = mt_arena_new(o->arena, (size_t)morph->contour_count, sizeof *outer.contours);
    mt_status status = outer.contours ? MT_OK : MT_NO_MEMORY;
    for (int i = 0; status == MT_OK && i < morph->contour_count; i++)
        status = go_on(o, &morph->contours[i], &outer.contours[i]);
    if (status == MT_OK) status = mt_moving_edges_of(&outer, tolerance, o->arena, &edges);
    if (status == MT_OK) status = mt_find_lulls(&edges, tolerance, o->arena, &o->lulls);
    if (status == MT_TOO_LARGE) o->lulls = (mt_lulls){0}; /* nothing is proved */
    if (status != MT_OK) return status == MT_TOO_LARGE ? MT_OK : status;
    double crumb = 2 * MT_CRUMB * (MT_EM / 1000.0) * (MT_EM / 1000.0);
    o->alike =
        o->lulls.known && o->lulls.plain && edges.least_area2 >= crumb && edges.least_width >= MT_SEAM_WIDTH;
    return MT_OK;
}

/* ---- looks ----------------------------------------------------------------------------------------------- */

static bool is_good(const mt_outskirts *o, const mt_shape *shape) {
    mt_topology at = mt_topology_of(shape);
    return at.components >= o->least.components && at.components <= o->most.components &&
           at.holes >= o->least.holes && at.holes <= o->most.holes;
}

/* As it is drawn and, where rings lie over one another, as it is meant (topology.h). */
static mt_status look(const mt_outskirts *o, double share, bool *good) {
    mt_arena_place before = mt_arena_mark(o->arena);
    mt_rings rings;
    mt_shape drawn, meant;
    mt_status status = mt_morph_rings(o->morph, weights_at(o, share), &o->fine, o->arena, &rings);
    if (status == MT_OK) status = mt_union_unmarked(&rings, MT_NONZERO, o->arena, &drawn);
    if (status == MT_OK) *good = is_good(o, &drawn);
    if (status == MT_OK && *good && mt_component_area2(&rings) != mt_shape_area2(&drawn)) {
        status = mt_union_unmarked(&rings, MT_POSITIVE, o->arena, &meant);
        if (status == MT_OK) *good = is_good(o, &meant);
    }
    mt_arena_rewind(o->arena, before);
    return status;
}

/* The next place to look at after one: the middle of a lull that begins before the next regular one, or that. */
static double next_place(const mt_outskirts *o, double share) {
    double next = (floor(share / LOOK) + 1) * LOOK;
    for (int i = 0; i < o->lulls.count; i++) {
        double middle = (o->lulls.lulls[i].from + o->lulls.lulls[i].to) / 2;
        if (o->lulls.lulls[i].from >= share && middle < next && middle > share) next = middle;
    }
    return next;
}

/* How far past a good place nothing meets. */
static double lull_end(const mt_outskirts *o, double share) {
    for (int i = 0; i < o->lulls.count; i++)
        if (o->lulls.lulls[i].from <= share && share < o->lulls.lulls[i].to) return o->lulls.lulls[i].to;
    return share;
}

/* Within the lull, near its end; the last good place where contours have become crumbs or seams by then. */
static mt_status stay_within(const mt_outskirts *o, double last, double end, double *reach) {
    const double inside = last + (end - last) * WITHIN;
    bool good = false;
    mt_status status = look(o, inside, &good);
    *reach = status == MT_OK && good ? inside : last;
    return status;
}

/* Where nothing is proved, between a good place and a bad one. */
static mt_status halve(const mt_outskirts *o, double last, double bad, double *reach) {
    mt_status status = MT_OK;
    while (status == MT_OK && bad - last > NEAR) {
        bool good = false;
        double middle = (last + bad) / 2;
        status = look(o, middle, &good);
        if (status == MT_OK && good)
            last = middle;
        else
            bad = middle;
    }
    *reach = last;
    return status;
}

static mt_status go_out(const mt_outskirts *o, double wanted, double *reach) {
    double last = 0, place = 0;
    bool good = true;
    mt_status status = MT_OK;
    while (status == MT_OK && good && place < wanted) {
        last = place;
        place = next_place(o, place);
        status = look(o, place, &good);
    }
    *reach = place;
    if (status != MT_OK || good) return status;
    double end = lull_end(o, last);
    return end > last ? stay_within(o, last, fmin(end, place), reach) : halve(o, last, place, reach);
}

/* ---- past both ends -------------------------------------------------------------------------------------- */

static mt_outskirts outskirts_of(const mt_morph *morph, mt_at from, mt_at to, const mt_params *params,
                                 mt_arena *arena) {
    mt_outskirts o = {.morph = morph, .from = from, .to = to, .fine = *params, .arena = arena};
    o.fine.tolerance /= MT_OVERLAP_CARE;
    return o;
}

static mt_status reach_past(const mt_morph *morph, bool past_b, double wanted, const mt_params *params,
                            mt_arena *arena, double *reach) {
    mt_outskirts o = outskirts_of(morph, mt_at_both(past_b ? 1 : 0),
                                  mt_at_both(past_b ? 1 + MT_REACH_MOST : -MT_REACH_MOST), params, arena);
    o.least = o.most = mt_topology_of(past_b ? &morph->b.whole : &morph->a.whole);
    bool blank = morph->a.whole.count == 0 && morph->b.whole.count == 0;
    *reach = blank ? MT_REACH_MOST : 0;
    if (wanted <= 0 || morph->links.count > 0 || morph->contour_count == 0) return MT_OK;
    mt_arena_place before = mt_arena_mark(arena);
    mt_status status = find_lulls(&o);
    if (status == MT_OK && o.alike)
        *reach = MT_REACH_MOST;
    else if (status == MT_OK)
        status = go_out(&o, wanted, reach);
    mt_arena_rewind(arena, before);
    return status;
}

mt_status mt_morph_reach(const mt_morph *morph, mt_reach wanted, const mt_params *params, mt_arena *arena,
                         mt_reach *reach) {
    double before, past;
    mt_status status = reach_past(morph, false, fmin(-wanted.from, MT_REACH_MOST), params, arena, &before);
    if (status == MT_OK)
        status = reach_past(morph, true, fmin(wanted.to - 1, MT_REACH_MOST), params, arena, &past);
    if (status == MT_OK) *reach = (mt_reach){before > 0 ? -before : 0, 1 + past};
    return status;
}

/* ---- aside ----------------------------------------------------------------------------------------------- */

static void widen(mt_outskirts *o, mt_topology by) {
    if (by.components < o->least.components) o->least.components = by.components;
    if (by.components > o->most.components) o->most.components = by.components;
    if (by.holes < o->least.holes) o->least.holes = by.holes;
    if (by.holes > o->most.holes) o->most.holes = by.holes;
}

/* What is good: the range of both ends, and what the place has that the way begins at, drawn and meant. */
static mt_status find_range(mt_outskirts *o) {
    mt_rings rings;
    mt_shape drawn, meant;
    o->least = o->most = mt_topology_of(&o->morph->a.whole);
    widen(o, mt_topology_of(&o->morph->b.whole));
    mt_status status = mt_morph_rings(o->morph, weights_at(o, 0), &o->fine, o->arena, &rings);
    if (status == MT_OK) status = mt_union_unmarked(&rings, MT_NONZERO, o->arena, &drawn);
    if (status == MT_OK) status = mt_union_unmarked(&rings, MT_POSITIVE, o->arena, &meant);
    if (status != MT_OK) return status;
    widen(o, mt_topology_of(&drawn));
    widen(o, mt_topology_of(&meant));
    return MT_OK;
}

static mt_status go_aside(mt_outskirts *o, double *share) {
    bool good = false;
    mt_status status = find_range(o);
    *share = 1;
    if (status == MT_OK) status = look(o, 1, &good);
    if (status != MT_OK || good) return status;
    status = find_lulls(o);
    if (status == MT_OK) status = go_out(o, 1, share);
    return status;
}

mt_status mt_morph_aside(const mt_morph *morph, double from, mt_at aim, const mt_params *params,
                         mt_arena *arena, mt_at *reach) {
    double share = 1;
    if (morph->links.count > 0) aim = (mt_at){fmin(fmax(aim.x, 0), 1), fmin(fmax(aim.y, 0), 1)};
    mt_outskirts o = outskirts_of(morph, mt_at_both(from), aim, params, arena);
    bool blank = morph->links.count == 0 && morph->contour_count == 0;
    mt_arena_place before = mt_arena_mark(arena);
    mt_status status = blank || mt_at_equal(o.from, aim) ? MT_OK : go_aside(&o, &share);
    mt_arena_rewind(arena, before);
    if (status == MT_OK) *reach = mt_at_between(o.from, aim, share);
    return status;
}
