/* White of one shape that lies on the ink of another: inlines, slits, the letter of a shadow face. */
#pragma once

#include "geometry/ring.h"

/* White in regions, each a hole and the outer rings of the components directly in it. */
typedef struct mt_white {
    int count; /* 0: there is none, and `filled` is empty */
    mt_rings *regions;
    int ring_count;  /* of all regions */
    mt_shape filled; /* the shape with this white as ink */
} mt_white;

/* The regions of a shape that lie for more than half of their area on `ink`, which is scaled into the shape's box. The rings are the
 * shape's own. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_find_white(const mt_shape *shape, const mt_shape *ink, mt_arena *arena, mt_white *white);
