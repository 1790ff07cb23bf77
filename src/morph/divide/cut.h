/* Cutting a triangulated component along some of its diagonals. */
#ifndef MT_MORPH_DIVIDE_CUT_H
#define MT_MORPH_DIVIDE_CUT_H

#include "geometry/triangulate.h"

/* A component with the vertices that its rings had (`drawn`), and the diagonals to cut along (`cut`, both half-edges of each). */
typedef struct mt_stencil {
    const mt_mesh *mesh;
    const bool *drawn; /* each vertex */
    const bool *cut;   /* each half-edge */
} mt_stencil;

/* What comes of it: a cut from one ring to another opens a hole, one from a ring to itself parts the component. Each part is a
 * component, outer ring first; together they have the same ink, but for what the rounding of a
 * cut's ends on slanted edges makes of it. Both ends of a cut are corners of both parts, and vertices that
 * were not drawn are left out but for these. part_of[t] is the part of triangle t. MT_NO_MEMORY. */
mt_status mt_cut(const mt_stencil *ink, mt_arena *arena, mt_shape *parts, int *part_of);

#endif
