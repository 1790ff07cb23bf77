/* White of one drawing that has no counterpart in another: inlines, slits, the letter of a shadow face. */
#pragma once

#include "geometry/ring.h"

/* White in regions, each a hole and the outer rings of the components directly in it. */
typedef struct mt_white {
    int count; /* 0: there is none, and `filled` is empty */
    mt_rings *regions;
    int ring_count;  /* of all regions */
    mt_shape filled; /* the shape with this white as ink */
} mt_white;

/* The white of two shapes, A's and B's, that has no counterpart in the other: each region goes with one that lies where it does, once B is
 * scaled into A's box. The rings are the shapes' own. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_find_white(const mt_shape *a, const mt_shape *b, mt_arena *arena, mt_white white[2]);
