/* Outlines as they are drawn: closed contours of lines, quadratic and cubic Béziers, on the grid.
 * flatten.c turns them into rings, fit.c turns rings back into contours of lines and quadratics. */
#pragma once

#include "geometry/ring.h"

typedef struct mt_segment {
    int degree;          /* 1, 2 or 3 */
    mt_point control[2]; /* degree - 1 of them are set */
    mt_point end;        /* the segment starts where the one before it ends; the first where the last ends */
} mt_segment;

typedef struct mt_contour {
    int count;
    mt_segment *segments; /* closed: the last one ends at the contour's start */
} mt_contour;

typedef struct mt_outline {
    int count;
    mt_contour *contours;
} mt_outline;

/* Where a line or a quadratic that starts at `from` is at t, 0 … 1; grid units, not rounded. */
mt_vector mt_segment_at(mt_point from, const mt_segment *segment, double t);

/* An outline told to a drawer, places multiplied by `scale`. One with cubics asks for cubic_to. */
void mt_outline_draw(const mt_outline *outline, double scale, const mt_draw *draw, void *user);

/* Flattens each contour into a ring (not yet resolved: as drawn, overlaps and all), every point within
 * `tolerance` grid units of the curve and every curve point within it of the ring. The number of chords comes
 * from the second difference for a quadratic and from Wang's bound for a cubic (G. Wang, "The subdivision
 * method for finding the intersection between two Bézier curves or surfaces", 1984), and a curve that turns
 * by θ gets at least θ / MT_CHORD_TURN. Contours of fewer than three different points are left out.
 * MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_flatten(const mt_outline *outline, double tolerance, mt_arena *arena, mt_rings *rings);

/* Flattens two contours with as many segments of the same degrees at the same parameters, so that point k of the one goes with point k
 * of the other, and so does each mix of both: its chords are within `tolerance` grid units of the mixed curves, and rounding adds one.
 * Points that fall on the last ones in both are left out; marks are all 0. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_flatten_alike(const mt_contour *a, const mt_contour *b, double tolerance, mt_arena *arena,
                           mt_ring *in_a, mt_ring *in_b);

/* Fits a closed contour of lines and quadratic Béziers to each ring, corners kept, within `tolerance` grid
 * units of every vertex that is not a dent (MT_DENT). `chord` is the tolerance that the rings' curves were
 * flattened with: it tells a chord from a line. Seams (MT_SEAM_WIDTH) are left out. MT_NO_MEMORY. */
mt_status mt_fit(const mt_rings *rings, double chord, double tolerance, mt_arena *arena, mt_outline *outline);

/* Whether each segment has a degree of 1 to 3, and a contour at least one; an outline's contours alike. Linear. */
bool mt_contour_is_valid(const mt_contour *contour);
bool mt_outline_is_valid(const mt_outline *outline);
