/* A region closes along its own middle line:
 *
 *     ┌───────────────┐        the corners go to the ends of the line, each where the disc that touches both
 *     │╲_____________╱│        edges touches a third; all other nodes go straight across;
 *     │╱             ╲│        then the line goes with the contours around it (carrier.h)
 *     └───────────────┘
 *
 * Nodes and curves are those of the fitted contour, flattened again so that each curve's middle is a vertex: the discs touch what is drawn.
 * What this leaves open, since it branches or bends, closes on its spine (spine.h), with more nodes; what touches itself, in a point.
 * White has to end in the ink of the other drawing, since a hole that leaves its ink is drawn as ink (topology.c): what of its
 * line would not goes to the nearest border.
 * O(n m) for n nodes and m vertices of the region and samples of the carrier. */
#include "morph/join/closing.h"
#include "morph/join/spine.h"

#include <assert.h>
#include <math.h>

#include "geometry/disc.h"
#include "geometry/enclosed.h"
#include "geometry/inside.h"
#include "geometry/limits.h"

/* The mean width of what is closed, at most, 1/1000 em: within the unit by which a variable font may be off at its ends. */
#define CLOSED 0.75

#define PIECE 60.0                /* of a line or curve, 1/1000 em; … */
enum { PIECES = 40, CHORDS = 8 }; /* … so many at most; chords of a curve: even, so that one ends half-way */

/* ---- the drawing ------------------------------------------------------------------------------------------ */

static mt_point rounded(mt_vector p) {
    return (mt_point){(int32_t)lround(p.x), (int32_t)lround(p.y)};
}

/* In how many pieces of a segment its middle line follows what the contours around it do. */
static int pieces_of(mt_point from, const mt_segment *s, bool curves) {
    double length = sqrt((double)mt_distance2(from, s->end));
    return s->degree == 1 || curves ? (int)fmin(PIECES, 1 + length / mt_grid_units(PIECE)) : 1;
}

/* A segment from t to u: the control point is the blossom at both. */
static mt_segment piece_of(mt_point from, const mt_segment *s, double t, double u) {
    mt_segment piece = {.degree = s->degree, .end = u < 1 ? rounded(mt_segment_at(from, s, u)) : s->end};
    double start = (1 - t) * (1 - u), control = t * (1 - u) + u * (1 - t), end = t * u;
    if (s->degree == 2)
        piece.control[0] = rounded((mt_vector){start * from.x + control * s->control[0].x + end * s->end.x,
                                               start * from.y + control * s->control[0].y + end * s->end.y});
    return piece;
}

/* Lines, and curves if asked for, in pieces of about the same length. */
static mt_status divide(const mt_contour *contour, bool curves, mt_arena *arena, mt_contour *divided) {
    int count = 0;
    mt_point start = contour->segments[contour->count - 1].end, from = start;
    for (int i = 0; i < contour->count; from = contour->segments[i++].end)
        count += pieces_of(from, &contour->segments[i], curves);
    *divided = (mt_contour){0, mt_arena_new(arena, (size_t)count, sizeof(mt_segment))};
    if (!divided->segments) return MT_NO_MEMORY;
    from = start;
    for (int i = 0; i < contour->count; from = contour->segments[i++].end) {
        int pieces = pieces_of(from, &contour->segments[i], curves);
        for (int k = 0; k < pieces; k++)
            divided->segments[divided->count++] =
                piece_of(from, &contour->segments[i], (double)k / pieces, (double)(k + 1) / pieces);
    }
    return MT_OK;
}

static mt_status divide_all(const mt_outline *outline, bool curves, mt_arena *arena, mt_outline *divided) {
    *divided = (mt_outline){outline->count, mt_arena_new(arena, (size_t)outline->count, sizeof(mt_contour))};
    mt_status status = divided->contours ? MT_OK : MT_NO_MEMORY;
    for (int i = 0; status == MT_OK && i < outline->count; i++)
        status = divide(&outline->contours[i], curves, arena, &divided->contours[i]);
    return status;
}

static int chords_of(const mt_segment *s) {
    return s->degree == 1 ? 1 : CHORDS;
}

/* A fitted contour as a ring of known vertices: of segment 0 those behind the start of the contour, and so on. */
static mt_status flatten(const mt_contour *contour, mt_arena *arena, mt_ring *ring) {
    int count = 0;
    for (int i = 0; i < contour->count; i++) count += chords_of(&contour->segments[i]);
    mt_status status = mt_ring_new(arena, count, ring);
    if (status != MT_OK) return status;
    mt_point from = contour->segments[contour->count - 1].end;
    count = 0;
    for (int i = 0; i < contour->count; i++) {
        const mt_segment *s = &contour->segments[i];
        for (int k = 1; k < chords_of(s); k++)
            ring->points[count++] = rounded(mt_segment_at(from, s, (double)k / chords_of(s)));
        ring->points[count++] = s->end;
        from = s->end;
    }
    return MT_OK;
}

static mt_status flatten_all(const mt_outline *outline, mt_arena *arena, mt_rings *rings) {
    *rings = (mt_rings){outline->count, mt_arena_new(arena, (size_t)outline->count, sizeof(mt_ring))};
    if (!rings->rings) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (int i = 0; status == MT_OK && i < outline->count; i++)
        status = flatten(&outline->contours[i], arena, &rings->rings[i]);
    return status;
}

/* ---- where it ends ---------------------------------------------------------------------------------------- */

/* The mean width of the area that these rings enclose. */
static mt_status measure(const mt_rings *rings, mt_arena *arena, double *width) {
    double area, length = mt_rings_length(rings);
    mt_status status = mt_enclosed_area(rings, arena, &area);
    *width = status == MT_OK && length > 0 ? 2 * area / length : 0;
    return status;
}

/* Each vertex of a region moved to the middle. */
static mt_status move_to_middle(const mt_rings *region, bool left, mt_arena *arena, mt_rings *moved) {
    *moved = (mt_rings){region->count, mt_arena_new(arena, (size_t)region->count, sizeof(mt_ring))};
    if (!moved->rings) return MT_NO_MEMORY;
    for (int r = 0; r < region->count; r++) {
        const mt_ring *ring = &region->rings[r];
        mt_status status = mt_ring_new(arena, ring->count, &moved->rings[r]);
        if (status != MT_OK) return status;
        for (int i = 0; i < ring->count; i++) {
            mt_vector way = mt_way_to_middle(region, r, i, left);
            moved->rings[r].points[i] =
                rounded((mt_vector){ring->points[i].x + way.x, ring->points[i].y + way.y});
        }
    }
    return MT_OK;
}

/* Where a place of the middle is on the other side. White ends in the ink: a place beside it goes to the nearest place of its border. */
static mt_point carried(const mt_closing *c, mt_point p) {
    mt_point to = rounded(mt_carry(&c->carrier, (mt_vector){p.x, p.y}));
    return c->ink && !mt_is_in_ink(c->ink, to) ? rounded(mt_nearest_on_border(c->ink, to)) : to;
}

/* Where each vertex of a region ends, if that leaves nothing open. */
static mt_status end_on_middles(const mt_rings *region, const mt_closing *c, mt_arena *arena, mt_rings *ends,
                                bool *shut) {
    double width = 0;
    mt_status status = move_to_middle(region, mt_ring_area2(&region->rings[0]) > 0, arena, ends);
    if (status != MT_OK) return status;
    for (int r = 0; r < ends->count; r++)
        for (int i = 0; i < ends->rings[r].count; i++)
            ends->rings[r].points[i] = carried(c, ends->rings[r].points[i]);
    status = measure(ends, arena, &width);
    *shut = width <= mt_grid_units(CLOSED);
    return status;
}

/* ---- the contour that it ends as -------------------------------------------------------------------------- */

/* The control point of a curve that starts, ends and is half-way in given places. */
static mt_point control_through(mt_point start, mt_point half, mt_point end) {
    return rounded((mt_vector){2.0 * half.x - ((double)start.x + end.x) / 2,
                               2.0 * half.y - ((double)start.y + end.y) / 2});
}

static mt_status closed_contour(const mt_contour *open, const mt_ring *ends, mt_arena *arena,
                                mt_contour *shut) {
    *shut = (mt_contour){open->count, mt_arena_new(arena, (size_t)open->count, sizeof(mt_segment))};
    if (!shut->segments) return MT_NO_MEMORY;
    mt_point start = ends->points[ends->count - 1];
    for (int i = 0, k = -1; i < open->count; i++) {
        const mt_segment *s = &open->segments[i];
        mt_point half = ends->points[k + (s->degree == 2 ? CHORDS / 2 : 1)],
                 end = ends->points[k += chords_of(s)];
        mt_point control = s->degree == 2 ? control_through(start, half, end) : end;
        shut->segments[i] = (mt_segment){s->degree, {control}, end};
        start = end;
    }
    return MT_OK;
}

static void set_pair(const mt_closing *c, const mt_contour *open, const mt_contour *shut,
                     mt_contour_pair *pair) {
    *pair = c->in_a ? (mt_contour_pair){.a = *open, .b = *shut} : (mt_contour_pair){.a = *shut, .b = *open};
    assert(mt_contour_pair_is_valid(pair));
}

static mt_status pair_of(const mt_contour *open, const mt_ring *ends, const mt_closing *c, mt_arena *arena,
                         mt_contour_pair *made) {
    mt_contour shut;
    mt_status status = closed_contour(open, ends, arena, &shut);
    if (status == MT_OK) set_pair(c, open, &shut, made);
    return status;
}

/* Each vertex goes to the middle: few nodes, and *shut where it leaves nothing open. */
static mt_status close_on_middles(const mt_outline *outline, const mt_closing *c, mt_arena *arena,
                                  mt_contour_pair *pairs, bool *shut) {
    mt_outline open;
    mt_rings drawn, ends;
    mt_status status = divide_all(outline, false, arena, &open);
    if (status == MT_OK) status = flatten_all(&open, arena, &drawn);
    if (status == MT_OK) status = end_on_middles(&drawn, c, arena, &ends, shut);
    for (int i = 0; status == MT_OK && *shut && i < open.count; i++)
        status = pair_of(&open.contours[i], &ends.rings[i], c, arena, &pairs[i]);
    return status;
}

static void carry_contour(const mt_closing *c, mt_contour *contour) {
    for (int i = 0; i < contour->count; i++) {
        mt_segment *s = &contour->segments[i];
        s->end = carried(c, s->end);
    }
    for (int i = 0; i < contour->count; i++) {
        mt_segment *s = &contour->segments[i];
        mt_point from = contour->segments[i ? i - 1 : contour->count - 1].end;
        if (s->degree == 2)
            s->control[0] =
                rounded((mt_vector){((double)from.x + s->end.x) / 2, ((double)from.y + s->end.y) / 2});
    }
}

/* *shut: where the region does not touch itself. */
static mt_status close_on_spine(const mt_outline *outline, bool left, const mt_closing *c, mt_arena *arena,
                                mt_contour_pair *pairs, bool *shut) {
    mt_outline drawn, open, closed;
    mt_rings ends;
    double width = 0;
    mt_status status = divide_all(outline, true, arena, &drawn);
    if (status == MT_OK) status = mt_spine_of(&drawn, left, arena, &open, &closed);
    *shut = false;
    if (status == MT_BAD_GEOMETRY) return MT_OK;
    for (int i = 0; status == MT_OK && i < open.count; i++) {
        carry_contour(c, &closed.contours[i]);
        set_pair(c, &open.contours[i], &closed.contours[i], &pairs[i]);
    }
    if (status == MT_OK) status = flatten_all(&closed, arena, &ends);
    if (status == MT_OK) status = measure(&ends, arena, &width);
    *shut = width <= mt_grid_units(CLOSED);
    return status;
}

/* All of it in the middle of its box. */
static mt_status close_in_point(const mt_outline *outline, const mt_closing *c, mt_arena *arena,
                                mt_contour_pair *pairs) {
    mt_rings drawn;
    mt_status status = flatten_all(outline, arena, &drawn);
    if (status != MT_OK) return status;
    mt_box box = mt_ring_box(&drawn.rings[0]);
    mt_point middle = carried(
        c, (mt_point){box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2});
    for (int i = 0; i < outline->count; i++) {
        const mt_contour *open = &outline->contours[i];
        mt_contour shut = {open->count, mt_arena_new(arena, (size_t)open->count, sizeof(mt_segment))};
        if (!shut.segments) return MT_NO_MEMORY;
        for (int k = 0; k < shut.count; k++)
            shut.segments[k] = (mt_segment){open->segments[k].degree, {middle}, middle};
        set_pair(c, open, &shut, &pairs[i]);
    }
    return MT_OK;
}

mt_status mt_close_region(const mt_rings *region, const mt_closing *c, mt_arena *arena,
                          mt_contour_pair *contours, int *count) {
    mt_outline outline;
    mt_contour_pair *made = &contours[*count];
    bool shut;
    mt_status status =
        mt_fit(region, mt_grid_units(c->params->tolerance), mt_grid_units(c->params->fit), arena, &outline);
    if (status != MT_OK || outline.count == 0) return status;
    bool left = mt_ring_area2(&region->rings[0]) > 0;
    status = close_on_middles(&outline, c, arena, made, &shut);
    if (status == MT_OK && !shut) status = close_on_spine(&outline, left, c, arena, made, &shut);
    if (status == MT_OK && !shut) status = close_in_point(&outline, c, arena, made);
    if (status == MT_OK) *count += outline.count;
    return status;
}
