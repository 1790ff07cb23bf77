/* The holes of two parts that are joined: paired, slit open, or closed. */
#pragma once

#include "morph/join/joining.h"

/* The counterpart of each hole, by its index among the other part's rings; 0: none. */
typedef struct mt_hole_pairs {
    int *in_b; /* of each ring of A */
    int *in_a; /* of each ring of B */
} mt_hole_pairs;

/* Pairs holes, and slits those open that have no counterpart and are open on the other side: the parts' components may have
 * fewer rings afterwards. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_pair_holes(mt_joining *j, mt_hole_pairs *pairs);

/* The ink into which a ring without a counterpart closes. */
typedef struct mt_closing {
    mt_box box; /* of the ring's glyph */
    const mt_shape *ink;
    mt_box ink_box; /* of the other glyph */
    const mt_params *params;
} mt_closing;

/* A contour pair: the ring's own contour on its side, all of it at one point of the ink on the other. *masters is empty when the ring
 * is a seam (mt_fit). As above. */
mt_status mt_close_ring(const mt_ring *ring, bool in_a, const mt_closing *closing, mt_arena *arena,
                        mt_contour_pair *masters);
