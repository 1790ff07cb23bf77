/* Union of polygons, by Clipper (A. Johnson; B. R. Vatti, "A generic solution to polygon clipping", 1992). */
#ifndef MT_GEOMETRY_UNION_H
#define MT_GEOMETRY_UNION_H

#include "geometry/outline.h"

/* What is ink: all that rings go around in either direction more often than in the other, as fonts are filled; or only what more
 * of them go around anticlockwise, as contours are meant whose ink lies to the left. */
typedef enum mt_rule { MT_NONZERO, MT_POSITIVE } mt_rule;

/* The ink of all rings together, as components with holes. Points that survive
 * keep their marks; where edges cross, a new one with mark MT_CROSSING appears. Points in line are dropped.
 * Each ring starts at its lowest, then leftmost point, and components come in the order of these points, as
 * do the holes of each. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_union(const mt_rings *rings, mt_rule rule, mt_arena *arena, mt_shape *shape);

/* The same without marks: all are 0. For who only counts or measures: finding marks takes long. As mt_union. */
mt_status mt_union_unmarked(const mt_rings *rings, mt_rule rule, mt_arena *arena, mt_shape *shape);

/* The nonzero union of an outline flattened within `tolerance` grid units, and whether the outline was its own
 * union already, but for running the other way round as a whole: whether no area was covered twice. As mt_flatten and mt_union. */
mt_status mt_outline_resolve(const mt_outline *outline, double tolerance, mt_arena *arena, mt_shape *shape,
                             bool *clean);

#endif
