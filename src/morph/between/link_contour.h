/* A link as one contour pair. */
#pragma once

#include "morph/model/morph.h"

/* The Minkowski sum rP ⊕ (1 - r)Q of two convex pieces for all r at once: masters P and Q with the same lines and quadratics fitted to
 * both, each within `tolerance` grid units. `flatness` is the tolerance that the pieces' curves were flattened with. MT_NO_MEMORY,
 * MT_TOO_LARGE. */
mt_status mt_link_contour(const mt_ring *p, const mt_ring *q, double flatness, double tolerance,
                          mt_arena *arena, mt_contour_pair *masters);
