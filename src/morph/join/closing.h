/* Rings without a counterpart: they close on the middle line of what they enclose. */
#pragma once

#include "morph/join/carrier.h"

/* Of a ring's glyph and the other: how places move, and the ink that white has to end in. */
typedef struct mt_closing {
    bool in_a; /* the ring is A's */
    mt_carrier carrier;
    const mt_shape *ink; /* of the other glyph; NULL for black, which may end anywhere */
    const mt_params *params;
} mt_closing;

/* Contour pairs, one for each ring of a region, black or white: the ring's own contour on its side; on the other, each of its places is where
 * the middle of the largest disc goes that touches the ring there and lies in the region, or, where that would leave it open, where its
 * spine goes. White that would end beside the ink ends on its border. rings[0] is the outermost. Seams (mt_fit) have no contour pair.
 * Appends to contours[*count]. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_close_region(const mt_rings *region, const mt_closing *closing, mt_arena *arena,
                          mt_contour_pair *contours, int *count);
