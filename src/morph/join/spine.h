/* The spine of a region: lines along its middle, branched as the region is. */
#pragma once

#include "geometry/outline.h"

/* The contours of a region again, with nodes that may stand on one another, and the same contours closed on the region's spine: going around
 * the region, they go along each of its lines on both sides, and enclose no area. `region`: contours of lines and quadratics that
 * do not cross, contours[0] the outermost; `left`: whether the region lies to the left of them. Nodes should not be much further apart than the region is wide. MT_NO_MEMORY,
 * MT_TOO_LARGE, MT_BAD_GEOMETRY where the chords of the contours cross. */
mt_status mt_spine_of(const mt_outline *region, bool left, mt_arena *arena, mt_outline *open,
                      mt_outline *shut);
