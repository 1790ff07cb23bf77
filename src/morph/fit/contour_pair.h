/* Compatible masters of two aligned rings, and the contours between them. */
#pragma once

#include "geometry/outline.h"
#include "morph/align/align.h"

/* Fits the same lines and quadratics to two aligned rings, each within 1.1 times `tolerance` grid units of its own. They end at the
 * corners of either ring, at the ends of lines that both have, and at extrema that both have; nodes that are smooth in both masters
 * stay smooth in between (chains.h), where curves can be found for it. MT_NO_MEMORY,
 * MT_TOO_LARGE where the arena's steps do not do. */
mt_status mt_contour_pair_fit(const mt_ring_samples *a, const mt_ring_samples *b,
                              const mt_alignment *alignment, double tolerance, mt_arena *arena,
                              mt_contour_pair *masters);

/* The contour at these weights. MT_NO_MEMORY. */
mt_status mt_contour_pair_mix(const mt_contour_pair *masters, mt_weights weights, mt_arena *arena,
                              mt_contour *contour);

/* The area of the polygon of its nodes half-way, grid units squared: negative for a hole. */
double mt_contour_pair_area(const mt_contour_pair *masters);
