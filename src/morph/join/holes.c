/* Holes of two parts: paired, or slit open.
 *
 *     ┌──────┐  paired: mt_pair_rings, at any cost, so that as many holes as can be have a counterpart
 *     │ o  h │  slit:   h has none, and opening it into another ring makes that ring align better (slit.c); then again from the start
 *     └──────┘
 *
 * Invariants: the side with more ink is looked at first, so that swapping A and B swaps the result.
 * O(h²) alignments for h holes, again after each slit. */
#include "morph/join/holes.h"

#include <math.h>

#include "morph/divide/slit.h"

/* ---- pairing holes ------------------------------------------------------------------------------------- */

static mt_part *part(mt_joining *j, int side) {
    return side == 0 ? &j->a : &j->b;
}

static mt_status holes_of(mt_joining *j, int side, mt_ring_list *list) {
    const mt_component *c = part(j, side)->component;
    *list = (mt_ring_list){c->count - 1, mt_arena_new(j->arena, (size_t)c->count, sizeof(mt_ring *)),
                           part(j, side)->frame};
    if (!list->rings) return MT_NO_MEMORY;
    for (int i = 1; i < c->count; i++) list->rings[i - 1] = &c->rings[i];
    return MT_OK;
}

static mt_status pair(mt_joining *j, mt_hole_pairs *pairs) {
    mt_ring_list a, b;
    mt_status status = holes_of(j, 0, &a);
    if (status == MT_OK) status = holes_of(j, 1, &b);
    if (status != MT_OK) return status;
    pairs->in_b = mt_arena_new(j->arena, (size_t)a.count + 1, sizeof(int));
    pairs->in_a = mt_arena_new(j->arena, (size_t)b.count + 1, sizeof(int));
    if (!pairs->in_b || !pairs->in_a) return MT_NO_MEMORY;
    for (int i = 1; i <= a.count; i++) pairs->in_b[i] = -1;
    for (int i = 1; i <= b.count; i++) pairs->in_a[i] = -1;
    status =
        mt_pair_rings(&a, &b, INFINITY, &j->context->settings, j->arena, pairs->in_b + 1, pairs->in_a + 1);
    for (int i = 1; i <= a.count; i++) pairs->in_b[i]++;
    for (int i = 1; i <= b.count; i++) pairs->in_a[i]++;
    return status;
}

/* ---- slits --------------------------------------------------------------------------------------------- */

/* Slits one hole of a side open, if one without a counterpart can be. */
static mt_status open_one(mt_joining *j, int side, const mt_hole_pairs *pairs, bool *opened) {
    mt_part *own = part(j, side), *other = part(j, 1 - side);
    const int *partner = side == 0 ? pairs->in_b : pairs->in_a;
    int rings = own->component->count;
    const mt_ring **counterpart = mt_arena_new(j->arena, (size_t)rings, sizeof *counterpart);
    if (!counterpart) return MT_NO_MEMORY;
    for (int i = 0; i < rings; i++)
        if (i == 0 || partner[i]) counterpart[i] = &other->component->rings[i == 0 ? 0 : partner[i]];
    mt_slit_case slit = {own->component, own->frame, counterpart, other->frame};
    mt_status status = MT_OK;
    for (int i = 1; status == MT_OK && i < rings && !*opened; i++) {
        mt_component *made = mt_arena_new(j->arena, 1, sizeof *made);
        if (!made) return MT_NO_MEMORY;
        if (!partner[i]) status = mt_slit(&slit, i, &j->context->settings, j->arena, made, opened);
        if (*opened) own->component = made;
    }
    return status;
}

/* The side to look at first, by an order of their own: the one with more ink. */
static int first_side(const mt_joining *j) {
    return mt_component_area2(j->a.component) < mt_component_area2(j->b.component);
}

mt_status mt_pair_holes(mt_joining *j, mt_hole_pairs *pairs) {
    int first = first_side(j);
    bool opened;
    do {
        opened = false;
        mt_status status = pair(j, pairs);
        if (status == MT_OK) status = open_one(j, first, pairs, &opened);
        if (status == MT_OK && !opened) status = open_one(j, 1 - first, pairs, &opened);
        if (status != MT_OK) return status;
    } while (opened);
    return MT_OK;
}
