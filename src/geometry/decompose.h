/* Convex decomposition, section 2.1 of the paper. */
#pragma once

#include "geometry/ring.h"

/* Cuts a component into convex pieces over its own vertices: constrained Delaunay triangles, merged across
 * diagonals, longest first, while the union stays convex (S. Hertel, K. Mehlhorn, "Fast triangulation of
 * simple polygons", 1983). On MT_OK: every piece is convex, the doubled areas add up to the component's
 * exactly, and with r reflex vertices there are at most 2r + 1 pieces. MT_NO_MEMORY, MT_TOO_LARGE,
 * MT_BAD_GEOMETRY when the rings cross. */
mt_status mt_decompose(const mt_component *component, mt_arena *arena, mt_pieces *pieces);

/* The number of reflex vertices (interior angle over 180°) of a component. */
int mt_reflex_count(const mt_component *component);
