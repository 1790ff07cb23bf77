/* A link as one contour that moves. */
#ifndef MT_MORPH_BETWEEN_LINK_CONTOUR_H
#define MT_MORPH_BETWEEN_LINK_CONTOUR_H

#include "morph/model/morph.h"

/* The Minkowski sum rP ⊕ (1 - r)Q of two convex pieces for all r at once: its corners are made of the same vertices of P and Q
 * for all 0 < r < 1. The masters are P, waiting at a vertex while Q moves on, and Q likewise, with the same lines and
 * quadratics fitted to both, each within `tolerance` grid units. `flatness` is what the pieces' curves were flattened within.
 * MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_link_contour(const mt_ring *p, const mt_ring *q, double flatness, double tolerance,
                          mt_arena *arena, mt_contour_pair *masters);

#endif
