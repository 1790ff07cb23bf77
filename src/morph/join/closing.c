/* A region closes along its own middle line:
 *
 *     ┌───────────────┐        the corners go to the ends of the line, each where the disc that touches both
 *     │╲_____________╱│        edges touches a third; all other nodes go straight across;
 *     │╱             ╲│        then the line goes with the contours around it (carrier.h)
 *     └───────────────┘
 *
 * Nodes and curves are those of the fitted contour, flattened again so that each curve's middle is a vertex: the discs touch what is drawn.
 * White has to end in the ink of the other drawing, since a hole that leaves its ink is drawn as ink (topology.c): what of its
 * line would not goes to the nearest border.
 * O(n m) for n nodes and m vertices of the region and samples of the carrier. */
#include "morph/join/closing.h"

#include <assert.h>
#include <math.h>

#include "geometry/disc.h"
#include "geometry/enclosed.h"
#include "geometry/inside.h"
#include "geometry/limits.h"

/* The mean width of what is closed, at most, 1/1000 em: within the unit by which a variable font may be off at its ends. */
#define CLOSED 0.75
/* How far middles lie beside a straight line for all of them to end on it, relative to how far they lie along it. */
#define STRAIGHT 0.15

#define PIECE 60.0 /* of a line, 1/1000 em; … */
enum {
    PIECES = 40,
    CHORDS = 8,
    ROUNDS = 3
}; /* … so many at most; chords of a curve: even, so that one ends half-way */

/* ---- the drawing ------------------------------------------------------------------------------------------ */

static mt_point rounded(mt_vector p) {
    return (mt_point){(int32_t)lround(p.x), (int32_t)lround(p.y)};
}

/* In how many pieces of a line, of equal length, its middle line follows what the contours around it do. */
static int pieces_of(mt_point from, const mt_segment *s) {
    double length = sqrt((double)mt_distance2(from, s->end));
    return s->degree == 1 ? (int)fmin(PIECES, 1 + length / mt_grid_units(PIECE)) : 1;
}

static mt_status divide_lines(mt_arena *arena, mt_contour *contour) {
    int count = 0;
    mt_point start = contour->segments[contour->count - 1].end, from = start;
    for (int i = 0; i < contour->count; from = contour->segments[i++].end)
        count += pieces_of(from, &contour->segments[i]);
    mt_contour divided = {0, mt_arena_new(arena, (size_t)count, sizeof(mt_segment))};
    if (!divided.segments) return MT_NO_MEMORY;
    from = start;
    for (int i = 0; i < contour->count; from = contour->segments[i++].end) {
        mt_segment s = contour->segments[i];
        int pieces = pieces_of(from, &s);
        for (int k = 1; k < pieces; k++) {
            double x = from.x + ((double)s.end.x - from.x) * k / pieces,
                   y = from.y + ((double)s.end.y - from.y) * k / pieces;
            divided.segments[divided.count++] = (mt_segment){.degree = 1, .end = rounded((mt_vector){x, y})};
        }
        divided.segments[divided.count++] = s;
    }
    *contour = divided;
    return MT_OK;
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

/* The area that these rings enclose, and its mean width. */
static mt_status measure(const mt_rings *rings, mt_arena *arena, double *area, double *width) {
    double length = mt_rings_length(rings);
    mt_status status = mt_enclosed_area(rings, arena, area);
    *width = status == MT_OK && length > 0 ? 2 * *area / length : 0;
    return status;
}

/* Each vertex of a region moved to the middle, if that is no further than `most`. */
static mt_status move_to_middle(const mt_rings *region, bool left, double most, mt_arena *arena,
                                mt_rings *moved) {
    *moved = (mt_rings){region->count, mt_arena_new(arena, (size_t)region->count, sizeof(mt_ring))};
    if (!moved->rings) return MT_NO_MEMORY;
    for (int r = 0; r < region->count; r++) {
        const mt_ring *ring = &region->rings[r];
        mt_status status = mt_ring_new(arena, ring->count, &moved->rings[r]);
        if (status != MT_OK) return status;
        for (int i = 0; i < ring->count; i++) {
            mt_vector way = mt_way_to_middle(region, r, i, left);
            if (hypot(way.x, way.y) > most) way = (mt_vector){0, 0};
            moved->rings[r].points[i] =
                rounded((mt_vector){ring->points[i].x + way.x, ring->points[i].y + way.y});
        }
    }
    return MT_OK;
}

/* A line through the middle of points, along the axis that they are spread most on. */
typedef struct mt_axis_line {
    mt_vector middle, along; /* of unit length */
    double spread, across;   /* standard deviations along it and beside it */
} mt_axis_line;

static mt_axis_line axis_of(const mt_rings *rings) {
    double count = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    for (int pass = 0; pass < 2; pass++)
        for (int r = 0; r < rings->count; r++)
            for (int i = 0; i < rings->rings[r].count; i++) {
                mt_point p = rings->rings[r].points[i];
                double u = p.x - x, v = p.y - y;
                if (pass == 0) {
                    count++;
                    x += u / count;
                    y += v / count;
                } else {
                    xx += u * u / count;
                    xy += u * v / count;
                    yy += v * v / count;
                }
            }
    double angle = atan2(2 * xy, xx - yy) / 2, c = cos(angle), s = sin(angle);
    double along = c * c * xx + 2 * c * s * xy + s * s * yy,
           across = s * s * xx - 2 * c * s * xy + c * c * yy;
    return (mt_axis_line){{x, y}, {c, s}, sqrt(fmax(0, along)), sqrt(fmax(0, across))};
}

/* All on one straight line, or where they lie too far beside it in one point. */
static void end_on_line(mt_rings *middles) {
    mt_axis_line line = axis_of(middles);
    bool straight = line.across <= STRAIGHT * line.spread;
    for (int r = 0; r < middles->count; r++)
        for (int i = 0; i < middles->rings[r].count; i++) {
            mt_point *p = &middles->rings[r].points[i];
            double along =
                straight ? (p->x - line.middle.x) * line.along.x + (p->y - line.middle.y) * line.along.y : 0;
            *p = rounded(
                (mt_vector){line.middle.x + along * line.along.x, line.middle.y + along * line.along.y});
        }
}

/* The middles of a region's vertices. Between vertices the line that they lie on bends, and where it branches they lie around the
 * branching: what they leave open is closed in the same way. */
static mt_status find_middles(const mt_rings *region, mt_arena *arena, mt_rings *middles) {
    bool left = mt_ring_area2(&region->rings[0]) > 0;
    double area = 0, width = 0, less, narrow, enough = mt_grid_units(CLOSED);
    mt_status status = move_to_middle(region, left, INFINITY, arena, middles);
    if (status == MT_OK) status = measure(middles, arena, &area, &width);
    for (int i = 0; status == MT_OK && i < ROUNDS && width > enough; i++) {
        mt_rings narrower;
        status = move_to_middle(middles, left, width, arena, &narrower);
        if (status == MT_OK) status = measure(&narrower, arena, &less, &narrow);
        if (status != MT_OK || less >= area) break;
        *middles = narrower;
        area = less;
        width = narrow;
    }
    return status;
}

static void carry_all(const mt_closing *c, mt_rings *rings) {
    for (int r = 0; r < rings->count; r++)
        for (int i = 0; i < rings->rings[r].count; i++) {
            mt_point *p = &rings->rings[r].points[i];
            *p = rounded(mt_carry(&c->carrier, (mt_vector){p->x, p->y}));
        }
}

/* White ends in the ink: a place beside it goes to the nearest place of its border. */
static void pull_into_ink(const mt_shape *ink, mt_rings *rings) {
    for (int r = 0; r < rings->count; r++)
        for (int i = 0; i < rings->rings[r].count; i++) {
            mt_point *p = &rings->rings[r].points[i];
            if (!mt_is_in_ink(ink, *p)) *p = rounded(mt_nearest_on_border(ink, *p));
        }
}

/* Where each vertex of a region ends. What does not close along its middles is bent and broad, or a grid or a knot: it ends on a straight
 * line if it is long, or in a point. */
static mt_status find_ends(const mt_rings *region, const mt_closing *c, mt_arena *arena, mt_rings *ends) {
    double area, width = 0;
    mt_status status = find_middles(region, arena, ends);
    if (status != MT_OK) return status;
    carry_all(c, ends);
    if (c->ink) pull_into_ink(c->ink, ends);
    status = measure(ends, arena, &area, &width);
    if (status != MT_OK || width <= mt_grid_units(CLOSED)) return status;
    end_on_line(ends);
    if (c->ink) pull_into_ink(c->ink, ends);
    return MT_OK;
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

static mt_status pair_of(const mt_contour *open, const mt_ring *ends, bool in_a, mt_arena *arena,
                         mt_contour_pair *made) {
    mt_contour shut;
    mt_status status = closed_contour(open, ends, arena, &shut);
    if (status != MT_OK) return status;
    *made = in_a ? (mt_contour_pair){.a = *open, .b = shut} : (mt_contour_pair){.a = shut, .b = *open};
    assert(mt_contour_pair_is_valid(made));
    return MT_OK;
}

mt_status mt_close_region(const mt_rings *region, const mt_closing *c, mt_arena *arena,
                          mt_contour_pair *contours, int *count) {
    mt_outline outline;
    mt_rings drawn, ends;
    mt_status status =
        mt_fit(region, mt_grid_units(c->params->tolerance), mt_grid_units(c->params->fit), arena, &outline);
    if (status != MT_OK || outline.count == 0) return status;
    for (int i = 0; status == MT_OK && i < outline.count; i++)
        status = divide_lines(arena, &outline.contours[i]);
    if (status == MT_OK) status = flatten_all(&outline, arena, &drawn);
    if (status == MT_OK) status = find_ends(&drawn, c, arena, &ends);
    for (int i = 0; status == MT_OK && i < drawn.count; i++)
        status = pair_of(&outline.contours[i], &ends.rings[i], c->in_a, arena, &contours[(*count)++]);
    return status;
}
