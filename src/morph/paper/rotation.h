/* The rotation of formula (5), section 2.3. */
#pragma once

#include "morph/model/morph.h"

/* The middle of a box, about which a glyph is turned. */
mt_point mt_box_middle(mt_box box);

/* The point turned about `centre` by `degrees`, anticlockwise, rounded to the grid. Multiples of 90° are
 * exact. */
mt_point mt_turn(mt_point p, mt_point centre, double degrees);

/* A copy of the shape turned about `centre`. Points that fall together stay two. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_shape_turn(const mt_shape *shape, mt_point centre, double degrees, mt_arena *arena,
                        mt_shape *turned);

/* A point of the blend at these weights, turned by formula (5): by (1 - r) q about the blend of both boxes' middles. */
mt_point mt_morph_turn(const mt_morph *morph, mt_weights weights, mt_point p);

/* The angle q of B to A, degrees, -90 … 90: the mean over matched components of the angle between their
 * principal axes (of the second moments of area), weighted by area and by how much longer than wide both are, so
 * that round components, which have no axis, do not count. 0 when no pair has one. */
double mt_find_rotation(const mt_shape *a, const mt_shape *b, const mt_links *matches);
