/* Holes of two parts: paired, slit open, or closed.
 *
 *     ┌──────┐  paired: mt_pair_rings, at any cost, so that as many holes as can be have a counterpart
 *     │ o  h │  slit:   h has none, and opening it into another ring makes that ring align better (slit.c); then again from the start
 *     └──────┘  closed: h shrinks to one point, the barycentre of the piece of the other part's ink nearest to its own place
 *
 * Invariants: the side with more ink is looked at first, so that swapping A and B swaps the result; a closed ring ends within the ink.
 * O(h²) alignments for h holes, again after each slit. */
#include "morph/join/holes.h"

#include <assert.h>
#include <math.h>

#include "geometry/decompose.h"
#include "geometry/limits.h"
#include "morph/divide/slit.h"

/* ---- rings without a counterpart ----------------------------------------------------------------------- */

/* The barycentre of a ring, relative to its glyph's box. */
static void place_of(const mt_ring *ring, mt_box box, double *x, double *y) {
    mt_ring_centre(ring, x, y);
    *x = (*x - box.min.x) / mt_box_width(box);
    *y = (*y - box.min.y) / mt_box_height(box);
}

static double apart(const mt_ring *p, mt_box box_p, const mt_ring *q, mt_box box_q) {
    double px, py, qx, qy;
    place_of(p, box_p, &px, &py);
    place_of(q, box_q, &qx, &qy);
    return hypot(px - qx, py - qy);
}

/* A point in the ink: the barycentre of the piece nearest to the ring's own place. A piece is convex and contains its barycentre. */
static mt_status point_inside(const mt_ring *ring, mt_box box, const mt_shape *ink, mt_box ink_box,
                              mt_arena *arena, mt_point *found) {
    double least = INFINITY;
    for (int k = 0; k < ink->count; k++) {
        mt_pieces pieces;
        mt_status status = mt_decompose(&ink->components[k], arena, &pieces);
        if (status != MT_OK) return status;
        for (int i = 0; i < pieces.count; i++) {
            double x, y, d = apart(ring, box, &pieces.rings[i], ink_box);
            if (d >= least) continue;
            least = d;
            mt_ring_centre(&pieces.rings[i], &x, &y);
            *found = (mt_point){(int32_t)lround(x), (int32_t)lround(y)};
        }
    }
    return MT_OK;
}

mt_status mt_close_ring(const mt_ring *ring, bool in_a, const mt_closing *c, mt_arena *arena,
                        mt_contour_pair *masters) {
    mt_rings one = {1, (mt_ring *)ring};
    mt_outline outline;
    mt_point point = {0, 0};
    *masters = (mt_contour_pair){0};
    mt_status status =
        mt_fit(&one, mt_grid_units(c->params->tolerance), mt_grid_units(c->params->fit), arena, &outline);
    if (status != MT_OK || outline.count == 0) return status;
    status = point_inside(ring, c->box, c->ink, c->ink_box, arena, &point);
    if (status != MT_OK) return status;
    mt_contour open = outline.contours[0],
               shut = {open.count, mt_arena_new(arena, (size_t)open.count, sizeof(mt_segment))};
    if (!shut.segments) return MT_NO_MEMORY;
    for (int i = 0; i < shut.count; i++)
        shut.segments[i] = (mt_segment){open.segments[i].degree, {point}, point};
    *masters = in_a ? (mt_contour_pair){.a = open, .b = shut} : (mt_contour_pair){.a = shut, .b = open};
    assert(mt_contour_pair_is_valid(masters));
    return MT_OK;
}

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
