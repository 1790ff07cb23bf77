/* Narrow white: inlines, slits, the gap of a shadow. */
#pragma once

#include "geometry/ring.h"

/* Narrow white that one of two shapes has more of than the other, in regions, each a hole and the outer rings of the components directly in
 * it. */
typedef struct mt_white {
    bool in_a; /* the shape that has it */
    int count; /* 0: there is none, and `filled` is empty */
    mt_rings *regions;
    int ring_count;  /* of all regions */
    mt_shape filled; /* the shape with this white as ink */
} mt_white;

/* The narrowest regions of the shape with more holes, as many as it has holes more, without those that are wider than WHITE_MOST in the
 * mean. The rings are the shape's own. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_find_white(const mt_shape *a, const mt_shape *b, mt_arena *arena, mt_white *white);
