/* The joint method for one set of settings (docs/joining.md, steps 1 to 10).
 *
 * 1. Where every component has one counterpart with as many holes, all pairs are joined as they are, at a cost up to PLAIN_MOST each.
 * 2. Otherwise, or where a pair costs more, both sides are cut until their parts correspond (reconcile.c). If both sides have more parts
 *    than either had components, cuts are extended (extended_cuts.c). Partners are joined at any cost.
 * 3. Parts that only one side has left grow out of the other's ink; parts that both have left are matched all with all, for the links.
 * 4. Where 2 leaves parts without contours, 1 is done again with PLAIN_LAST.
 * Invariants: contours are sorted by area, so that their order does not depend on which side is A; an aligned component has no pieces. */
#include "morph/join/joint.h"

#include <math.h>
#include <stdlib.h>

#include "morph/divide/extended_cuts.h"
#include "morph/divide/reconcile.h"
#include "morph/fit/contour_pair.h"
#include "morph/join/closing.h"
#include "morph/join/join.h"
#include "morph/paper/components.h"

/* The most that aligning two components as they are may cost before cutting is tried, … */
#define PLAIN_MOST 0.8
/* … and after cutting has left parts without contours: up to here, contours are better than links. */
#define PLAIN_LAST 1.5

typedef struct mt_join_state {
    mt_morph *morph;
    const mt_join_context *context;
    mt_arena *arena;
} mt_join_state;

static mt_part part_of(const mt_side *side, int k) {
    return (mt_part){&side->shape.components[k], side->frame};
}

/* Room for the contours and the aligned flags. */
static mt_status start(mt_join_state *state) {
    mt_morph *m = state->morph;
    m->contour_count = 0;
    m->contours = mt_arena_new(
        state->arena, (size_t)mt_shape_ring_count(&m->a.shape) + (size_t)mt_shape_ring_count(&m->b.shape),
        sizeof(mt_contour_pair));
    m->a.aligned = mt_arena_new(state->arena, (size_t)m->a.shape.count, sizeof(bool));
    m->b.aligned = mt_arena_new(state->arena, (size_t)m->b.shape.count, sizeof(bool));
    return m->contours && m->a.aligned && m->b.aligned ? MT_OK : MT_NO_MEMORY;
}

/* Joins a match; both components are aligned if it has contours then. */
static mt_status join_match(mt_join_state *state, mt_link match, double most) {
    mt_morph *m = state->morph;
    int before = m->contour_count;
    mt_status status = mt_join(part_of(&m->a, match.a), part_of(&m->b, match.b), most, state->context,
                               state->arena, m->contours, &m->contour_count);
    if (m->contour_count > before) m->a.aligned[match.a] = m->b.aligned[match.b] = true;
    return status;
}

/* ---- as they are --------------------------------------------------------------------------------------------- */

/* Whether every component has one counterpart with as many holes. */
static bool is_plain(const mt_morph *m) {
    if (m->matches.count != m->a.shape.count || m->matches.count != m->b.shape.count) return false;
    for (int i = 0; i < m->matches.count; i++) {
        mt_link match = m->matches.links[i];
        if (match.a != i || m->a.shape.components[match.a].count != m->b.shape.components[match.b].count)
            return false;
    }
    return true;
}

static mt_status join_plain(mt_join_state *state, double most, bool *joined) {
    mt_morph *m = state->morph;
    mt_status status = start(state);
    *joined = is_plain(m);
    for (int i = 0; status == MT_OK && *joined && i < m->matches.count; i++) {
        status = join_match(state, m->matches.links[i], most);
        *joined = m->a.aligned[m->matches.links[i].a];
    }
    return status;
}

/* ---- cut ----------------------------------------------------------------------------------------------------- */

static int without_partner(const mt_cut_side *cut) {
    int count = 0;
    for (int i = 0; i < cut->parts.count; i++) count += cut->partner[i] < 0;
    return count;
}

/* The matches of the parts: partners, and every part left on one side with every part left on the other. */
static mt_status match_parts(mt_join_state *state, const mt_cut_side *a, const mt_cut_side *b) {
    size_t rest = (size_t)without_partner(a) * (size_t)without_partner(b);
    mt_links made = {0, mt_arena_new(state->arena, rest + (size_t)a->parts.count, sizeof(mt_link))};
    if (!made.links) return MT_NO_MEMORY;
    for (int i = 0; i < a->parts.count; i++) {
        if (a->partner[i] >= 0) made.links[made.count++] = (mt_link){i, a->partner[i]};
        for (int k = 0; k < b->parts.count && a->partner[i] < 0; k++)
            if (b->partner[k] < 0) made.links[made.count++] = (mt_link){i, k};
    }
    state->morph->matches = made;
    return MT_OK;
}

/* Parts that only one side has left are born where they stand, carried by the contours around them. */
static mt_status join_rest(mt_join_state *state, const mt_cut_side *cut, bool in_a) {
    mt_morph *m = state->morph;
    mt_side *side = in_a ? &m->a : &m->b, *other = in_a ? &m->b : &m->a;
    mt_closing closing = {.in_a = in_a, .params = state->context->params};
    mt_status status = mt_carrier_of(m->contours, m->contour_count, in_a, side->box, other->box, state->arena,
                                     &closing.carrier);
    for (int k = 0; status == MT_OK && k < cut->parts.count; k++) {
        if (cut->partner[k] >= 0) continue;
        status = mt_close_region(&cut->parts.components[k], &closing, state->arena, m->contours,
                                 &m->contour_count);
        side->aligned[k] = true;
    }
    return status;
}

/* Whether both sides have more parts than either has components: in-betweens would have more components than both ends. */
static bool is_cut_twice(const mt_morph *m, const mt_cut_side *a, const mt_cut_side *b) {
    return a->parts.count > m->a.shape.count && a->parts.count > m->b.shape.count &&
           b->parts.count > m->a.shape.count && b->parts.count > m->b.shape.count;
}

static mt_status join_cut(mt_join_state *state) {
    mt_morph *m = state->morph;
    mt_cut_side a, b;
    mt_status status =
        mt_reconcile(&m->a, &m->b, state->context->hints, &state->context->settings, state->arena, &a, &b);
    bool twice = status == MT_OK && is_cut_twice(m, &a, &b);
    if (status == MT_OK && (twice || state->context->settings.goes_on))
        status = mt_extend_cuts(&m->a, &a, &m->b, &b, twice, state->context->settings.flatness, state->arena);
    if (status != MT_OK) return status;
    m->a.shape = a.parts;
    m->b.shape = b.parts;
    status = match_parts(state, &a, &b);
    if (status == MT_OK) status = start(state);
    for (int i = 0; status == MT_OK && i < m->matches.count; i++)
        if (a.partner[m->matches.links[i].a] >= 0) status = join_match(state, m->matches.links[i], INFINITY);
    int in_a = without_partner(&a), in_b = without_partner(&b);
    if (status == MT_OK && in_a && !in_b) status = join_rest(state, &a, true);
    if (status == MT_OK && in_b && !in_a) status = join_rest(state, &b, false);
    return status;
}

/* ---- all of it ----------------------------------------------------------------------------------------------- */

static bool all_aligned(const mt_side *side) {
    for (int k = 0; k < side->shape.count; k++)
        if (!side->aligned[k]) return false;
    return true;
}

/* As they are where they can be, else cut, else as they are at PLAIN_LAST. */
static mt_status join_all(mt_morph *morph, const mt_join_context *context, mt_arena *arena) {
    mt_morph whole = *morph;
    mt_join_state state = {morph, context, arena};
    bool joined;
    mt_status status = join_plain(&state, PLAIN_MOST, &joined);
    if (status != MT_OK || joined) return status;
    status = join_cut(&state);
    if (status != MT_OK || all_aligned(&morph->a)) return status;
    state.morph = &whole;
    status = join_plain(&state, PLAIN_LAST, &joined);
    if (status == MT_OK && joined) *morph = whole;
    return status;
}

/* By area half-way, the largest first; of equal ones the one that begins further left, or lower. */
static int compare_contours(const void *p, const void *q) {
    const mt_contour_pair *one = p, *other = q;
    double area = mt_contour_pair_area(one), beside = mt_contour_pair_area(other);
    if (area != beside) return area > beside ? -1 : 1;
    mt_point a = one->a.segments[0].end, b = one->b.segments[0].end, c = other->a.segments[0].end,
             d = other->b.segments[0].end;
    int64_t x = (int64_t)a.x + b.x - c.x - d.x, y = (int64_t)a.y + b.y - c.y - d.y;
    return x != 0 ? (x > 0) - (x < 0) : (y > 0) - (y < 0);
}

/* ---- white ----------------------------------------------------------------------------------------------------- */

/* Appends the white of one side that was filled: it closes, carried by all contours so far. */
static mt_status open_white(mt_morph *m, const mt_white *white, bool in_a, const mt_params *params,
                            mt_arena *arena) {
    mt_side *own = in_a ? &m->a : &m->b, *other = in_a ? &m->b : &m->a;
    mt_closing closing = {.in_a = in_a, .ink = &other->whole, .params = params};
    mt_status status =
        mt_carrier_of(m->contours, m->contour_count, in_a, own->box, other->box, arena, &closing.carrier);
    for (int i = 0; status == MT_OK && i < white->count; i++)
        status = mt_close_region(&white->regions[i], &closing, arena, m->contours, &m->contour_count);
    return status;
}

static int64_t white_area2(const mt_white *white) {
    int64_t area2 = 0;
    for (int i = 0; i < white->count; i++) area2 -= mt_component_area2(&white->regions[i]);
    return area2;
}

/* The side with more white first: the other's opens beside the lines that it closes on. */
static mt_status open_all_white(mt_morph *m, const mt_join_context *context, mt_arena *arena) {
    const mt_white *a = &context->white[0], *b = &context->white[1];
    bool a_first = white_area2(a) >= white_area2(b);
    size_t rings = (size_t)m->contour_count + (size_t)a->ring_count + (size_t)b->ring_count;
    mt_contour_pair *all = mt_arena_new(arena, rings, sizeof *all);
    if (!all) return MT_NO_MEMORY;
    for (int i = 0; i < m->contour_count; i++) all[i] = m->contours[i];
    m->contours = all;
    mt_status status = open_white(m, a_first ? a : b, a_first, context->params, arena);
    return status == MT_OK ? open_white(m, a_first ? b : a, !a_first, context->params, arena) : status;
}

/* White without a counterpart is filled first, and laid over the contours again. */
static mt_status join_filled(mt_morph *m, const mt_join_context *context, mt_arena *arena) {
    if (context->white[0].count > 0) m->a.shape = context->white[0].filled;
    if (context->white[1].count > 0) m->b.shape = context->white[1].filled;
    mt_status status = mt_match_sides(m, context->params, arena);
    if (status == MT_OK) status = join_all(m, context, arena);
    if (status != MT_OK) return status;
    bool drawn = all_aligned(&m->a) && all_aligned(&m->b); /* over sums of pieces, white would not be seen */
    return drawn ? open_all_white(m, context, arena) : MT_BAD_GEOMETRY;
}

mt_status mt_joint(mt_morph *morph, const mt_join_context *context, mt_arena *arena) {
    mt_status status = context->white ? join_filled(morph, context, arena) : join_all(morph, context, arena);
    if (status == MT_OK)
        qsort(morph->contours, (size_t)morph->contour_count, sizeof *morph->contours, compare_contours);
    return status;
}
