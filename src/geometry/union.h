/* Union of polygons, by Clipper (A. Johnson; B. R. Vatti, "A generic solution to polygon clipping", 1992). */
#pragma once

#include "geometry/outline.h"

/* The rule of ink: where the winding number is not 0, as fonts are filled; or where it is above 0, for contours whose ink lies to the
 * left; or where it is odd, as some drawings are filled. */
typedef enum mt_rule { MT_NONZERO, MT_POSITIVE, MT_EVEN_ODD } mt_rule;

/* The ink of all rings together, as components with holes. Points that survive
 * keep their marks; where edges cross, a new one with mark MT_CROSSING appears. Points in line are dropped.
 * Each ring starts at its lowest, then leftmost point, and components come in the order of these points, as
 * do the holes of each. MT_NO_MEMORY; MT_BAD_GEOMETRY where Clipper gives up; MT_TOO_LARGE, also where the arena is bounded and crossings take more steps than it has left. */
mt_status mt_union(const mt_rings *rings, mt_rule rule, mt_arena *arena, mt_shape *shape);

/* The same without marks: all are 0. For counting and measuring: finding marks takes long. As mt_union. */
mt_status mt_union_unmarked(const mt_rings *rings, mt_rule rule, mt_arena *arena, mt_shape *shape);

/* The nonzero union of an outline flattened within `tolerance` grid units, and whether the outline was its own
 * union already, in either orientation as a whole: no area was covered twice. As mt_flatten and mt_union. */
mt_status mt_outline_resolve(const mt_outline *outline, double tolerance, mt_arena *arena, mt_shape *shape,
                             bool *clean);
