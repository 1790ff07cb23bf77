#include "morph/holes.h"

#include <math.h>

#include "geometry/decompose.h"
#include "geometry/limits.h"
#include "morph/divide.h"

/* Between the barycentres of two holes that are taken for counterparts, in boxes. */
#define HOLE_DISTANCE 0.25

/* ---- holes without a counterpart ----------------------------------------------------------------------- */

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

/* A point in the ink of a part: the barycentre of the piece that lies nearest to the hole's own place. A piece is convex,
 * so its barycentre is inside it. */
static mt_status point_inside(const mt_joining *j, const mt_ring *hole, mt_box box, mt_part to,
                              mt_point *found) {
    mt_pieces pieces;
    mt_status status = mt_decompose(to.component, j->arena, &pieces);
    if (status != MT_OK) return status;
    double least = INFINITY;
    for (int i = 0; i < pieces.count; i++) {
        double d = apart(hole, box, &pieces.rings[i], to.box);
        if (d >= least) continue;
        least = d;
        double x, y;
        mt_ring_centre(&pieces.rings[i], &x, &y);
        *found = (mt_point){(int32_t)lround(x), (int32_t)lround(y)};
    }
    return MT_OK;
}

/* The hole's own contour on the one side, all of it at one point on the other. */
static mt_status close_hole(const mt_joining *j, const mt_ring *hole, bool in_a, mt_masters *masters) {
    mt_rings one = {1, (mt_ring *)hole};
    mt_outline outline;
    mt_point point;
    double tolerance = mt_grid_units(j->params->tolerance), fit = mt_grid_units(j->params->fit);
    *masters = (mt_masters){0};
    mt_status status = mt_fit(&one, tolerance, fit, j->arena, &outline);
    if (status != MT_OK || outline.count == 0) return status;
    status = point_inside(j, hole, in_a ? j->a.box : j->b.box, in_a ? j->b : j->a, &point);
    if (status != MT_OK) return status;
    mt_contour open = outline.contours[0], shut = {open.count, NULL};
    shut.segments = mt_arena_new(j->arena, (size_t)shut.count, sizeof(mt_segment));
    if (!shut.segments) return MT_NO_MEMORY;
    for (int i = 0; i < shut.count; i++)
        shut.segments[i] = (mt_segment){open.segments[i].degree, {point}, point};
    *masters = in_a ? (mt_masters){open, shut} : (mt_masters){shut, open};
    return MT_OK;
}

/* ---- pairing holes ------------------------------------------------------------------------------------- */

/* Pairs holes, nearest first: there[p] is the hole of B that goes with hole p of A, and back[q] that of A with hole q of B. */
static void pair_holes(const mt_joining *j, int *there, int *back) {
    for (;;) {
        double least = HOLE_DISTANCE;
        mt_link best = {0, 0};
        for (int p = 1; p < j->a.component->count; p++)
            for (int q = 1; q < j->b.component->count && !there[p]; q++) {
                if (back[q]) continue;
                double d = apart(&j->a.component->rings[p], j->a.box, &j->b.component->rings[q], j->b.box);
                if (d >= least) continue;
                least = d;
                best = (mt_link){p, q};
            }
        if (best.a == 0) return;
        there[best.a] = best.b;
        back[best.b] = best.a;
    }
}

/* The holes of both parts on their way: what each goes with. */
typedef struct mt_holes {
    int *partner[2]; /* of each hole of A in B, and the other way round; 0 where there is none */
    int *host
        [2]; /* the paired hole of the other side that holds a hole without a partner; 0 where none does */
    bool *done[2];
} mt_holes;

static const mt_part *part(const mt_joining *j, int side) {
    return side == 0 ? &j->a : &j->b;
}

static const mt_ring *hole_of(const mt_joining *j, int side, int i) {
    return &part(j, side)->component->rings[i];
}

/* Whether a place relative to the box is inside a ring. */
static bool holds(const mt_ring *ring, mt_box box, double x, double y) {
    bool inside = false;
    x = box.min.x + x * mt_box_width(box);
    y = box.min.y + y * mt_box_height(box);
    for (int i = 0; i < ring->count; i++) {
        mt_point a = ring->points[i], b = ring->points[(i + 1) % ring->count];
        if ((a.y <= y) == (b.y <= y)) continue;
        inside ^= x < a.x + (y - a.y) / ((double)b.y - a.y) * ((double)b.x - a.x);
    }
    return inside;
}

static void find_hosts(const mt_joining *j, int from, mt_holes *holes) {
    for (int p = 1; p < part(j, from)->component->count; p++) {
        double x, y;
        place_of(hole_of(j, from, p), part(j, from)->box, &x, &y);
        for (int q = 1; q < part(j, 1 - from)->component->count && !holes->partner[from][p]; q++)
            if (holes->partner[1 - from][q] && holds(hole_of(j, 1 - from, q), part(j, 1 - from)->box, x, y))
                holes->host[from][p] = q;
    }
}

static mt_status start_holes(const mt_joining *j, mt_holes *holes) {
    for (int s = 0; s < 2; s++) {
        size_t count = (size_t)part(j, s)->component->count;
        holes->partner[s] = mt_arena_new(j->arena, count, sizeof(int));
        holes->host[s] = mt_arena_new(j->arena, count, sizeof(int));
        holes->done[s] = mt_arena_new(j->arena, count, sizeof(bool));
        if (!holes->partner[s] || !holes->host[s] || !holes->done[s]) return MT_NO_MEMORY;
    }
    pair_holes(j, holes->partner[0], holes->partner[1]);
    find_hosts(j, 0, holes);
    find_hosts(j, 1, holes);
    return MT_OK;
}

/* ---- a hole that is several on the other side ---------------------------------------------------------- */

/* The same ring the other way round; an edge's marks stay with the edge. */
static mt_status reversed(const mt_ring *ring, mt_arena *arena, mt_ring *back) {
    int n = ring->count;
    mt_status status = mt_ring_new(arena, n, back);
    for (int i = 0; status == MT_OK && i < n; i++) {
        back->points[i] = ring->points[n - 1 - i];
        uint8_t edge = ring->marks[(2 * n - 2 - i) % n] & MT_EDGE_MARKS;
        back->marks[i] = (uint8_t)((ring->marks[n - 1 - i] & MT_POINT_MARKS) | edge);
    }
    return status;
}

/* Holes of a part as if they were ink. */
static mt_status holes_as_ink(const mt_joining *j, int from, const int *which, int count, mt_side *ink) {
    *ink = (mt_side){.box = part(j, from)->box};
    ink->shape = (mt_shape){count, mt_arena_new(j->arena, (size_t)count, sizeof(mt_component))};
    mt_ring *rings = mt_arena_new(j->arena, (size_t)count, sizeof *rings);
    if (!ink->shape.components || !rings) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) {
        mt_status status = reversed(hole_of(j, from, which[i]), j->arena, &rings[i]);
        if (status != MT_OK) return status;
        ink->shape.components[i] = (mt_component){1, &rings[i]};
    }
    return MT_OK;
}

static mt_status join_share(const mt_joining *j, int from, const mt_ring *hole, const mt_ring *share,
                            mt_masters *to) {
    mt_ring back;
    mt_status status = reversed(share, j->arena, &back);
    if (status != MT_OK) return status;
    return from == 0 ? mt_join_rings(j, &back, hole, to) : mt_join_rings(j, hole, &back, to);
}

/* Divides a hole of side `from` among its partner and its guests on the other side, as a component is divided: the cuts become
 * strokes without width, which grow into those that part the guests. */
static mt_status share_hole(const mt_joining *j, int from, int host, mt_holes *holes, mt_masters *contours,
                            int *count) {
    int to = 1 - from, guests = 1, most = part(j, to)->component->count;
    int *which = mt_arena_new(j->arena, (size_t)most, sizeof *which);
    int *partners = mt_arena_new(j->arena, (size_t)most, sizeof *partners);
    mt_component *shares = mt_arena_new(j->arena, (size_t)most, sizeof *shares);
    if (!which || !partners || !shares) return MT_NO_MEMORY;
    which[0] = holes->partner[from][host];
    for (int i = 1; i < most; i++)
        if (holes->host[to][i] == host) which[guests++] = i;
    for (int i = 0; i < guests; i++) partners[i] = i;
    if (guests < 2 || holes->done[to][which[0]]) return MT_OK;
    mt_side hole, others;
    bool divided;
    mt_status status = holes_as_ink(j, from, &host, 1, &hole);
    if (status == MT_OK) status = holes_as_ink(j, to, which, guests, &others);
    if (status == MT_OK) status = mt_divide(&hole, 0, &others, partners, guests, j->arena, shares, &divided);
    if (status != MT_OK) return status;
    for (int i = 0; i < guests; i++) divided = divided && shares[i].count == 1;
    for (int i = 0; status == MT_OK && i < guests && divided; i++) {
        status = join_share(j, from, hole_of(j, to, which[i]), &shares[i].rings[0], &contours[(*count)++]);
        holes->done[to][which[i]] = holes->done[from][host] = true;
    }
    return status;
}

/* ---- all holes ----------------------------------------------------------------------------------------- */

mt_status mt_join_holes(const mt_joining *j, mt_masters *contours, int *count) {
    mt_holes holes;
    mt_status status = start_holes(j, &holes);
    for (int s = 0; s < 2; s++)
        for (int i = 1; status == MT_OK && i < part(j, s)->component->count; i++)
            if (holes.partner[s][i] && !holes.done[s][i])
                status = share_hole(j, s, i, &holes, contours, count);
    for (int s = 0; s < 2; s++)
        for (int i = 1; status == MT_OK && i < part(j, s)->component->count; i++) {
            int partner = holes.partner[s][i];
            mt_masters *to = &contours[*count];
            if (holes.done[s][i] || (partner && s == 1)) continue;
            if (partner)
                status = mt_join_rings(j, hole_of(j, 0, i), hole_of(j, 1, partner), to);
            else
                status = close_hole(j, hole_of(j, s, i), s == 0, to);
            *count += to->a.count > 0;
        }
    return status;
}
