/* Where the places of a glyph are, as boundaries are compared. */
#pragma once

#include "geometry/ring.h"

/* Places are taken relative to the glyph's box, (0, 0) in its middle, 1 for its width or height. Of two glyphs, one's are carried to
 * where the other has them, by what both as a whole differ in: the place (u, v) on a boundary whose normal is (n, m), to the right of its
 * heading, is seen at (x[0] + x[1] u + x[2] v + x[3] n, y[0] + y[1] u + y[2] v + y[3] m), and a heading (p, q) as
 * (heading[0] p + heading[1] q, heading[2] p + heading[3] q). */
typedef struct mt_frame {
    mt_box box; /* grid units */
    double x[4], y[4];
    double heading[4];
} mt_frame;

/* The frame of a box by itself, which carries nothing. */
mt_frame mt_frame_of_box(mt_box box);

/* The side of a box that places on it are taken relative to, from that side and the one across it: a thin box counts as thicker, since a
 * stem that is all of one glyph is only the middle of the same glyph with serifs. */
double mt_frame_side(double side, double across);

/* Whether all numbers are finite, the box is not turned about, and headings are neither mirrored nor flattened. In constant time. */
bool mt_frame_is_valid(const mt_frame *frame);
