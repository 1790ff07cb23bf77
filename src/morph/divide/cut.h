/* Cutting a triangulated component along some of its diagonals. */
#pragma once

#include "geometry/triangulate.h"

/* A triangulated component, the vertices that its rings had, and the diagonals to cut along. */
typedef struct mt_cut_plan {
    const mt_half_edges *mesh;
    const bool *drawn; /* of each vertex */
    const bool *cut;   /* of each half-edge; both of a diagonal agree */
} mt_cut_plan;

/* Cuts the component into parts, each a component with its outer ring first. Together they have the same ink, but for the rounding of
 * a cut's ends on slanted edges. Both ends of a cut are corners of both parts; other vertices that were not drawn are left out.
 * part_of[t] is the part of triangle t. MT_NO_MEMORY. */
mt_status mt_cut(const mt_cut_plan *plan, mt_arena *arena, mt_shape *parts, int *part_of);
