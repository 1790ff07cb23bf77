/* Making compatible masters of two aligned rings, and going between them. */
#ifndef MT_MORPH_FIT_CONTOUR_PAIR_H
#define MT_MORPH_FIT_CONTOUR_PAIR_H

#include "geometry/outline.h"
#include "morph/align/align.h"

/* Fits the same lines and quadratics to two aligned rings, each within `tolerance` grid units of its own, and a tenth of that
 * more. They end where either ring has a corner, where both begin or end to follow a line, and at the extrema that both have;
 * nodes that both run through smoothly stay smooth on the way (chains.h), where the curves can be made so. MT_NO_MEMORY. */
mt_status mt_contour_pair_fit(const mt_ring_samples *a, const mt_ring_samples *b,
                              const mt_alignment *alignment, double tolerance, mt_arena *arena,
                              mt_contour_pair *masters);

/* The contour at these weights. MT_NO_MEMORY. */
mt_status mt_contour_pair_mix(const mt_contour_pair *masters, mt_weights weights, mt_arena *arena,
                              mt_contour *contour);

/* The area of the polygon of its nodes half-way, grid units squared: negative for a hole. */
double mt_contour_pair_area(const mt_contour_pair *masters);

#endif
