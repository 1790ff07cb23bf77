/* Kinks of contours between two masters: found, and removed by moving nodes. */
#pragma once

#include "morph/model/morph.h"

/* A turn at a node by less than this is no kink, degrees; nor is one of two masters' headings that differ by no more. */
#define MT_KINK_TURN 0.5

/* Moves nodes at which both masters are smooth and a mix of them is not, as far as no master departs from its curve by more than
 * `tolerance` grid units. MT_NO_MEMORY, MT_TOO_LARGE where the arena's steps do not do. */
mt_status mt_contour_pair_smooth(mt_contour_pair *masters, double tolerance, mt_arena *arena);

/* Whether a contour is smooth at node k, the end of segment k. Segments without length are skipped on both sides. */
bool mt_is_smooth(const mt_contour *contour, int k);

/* The largest turn of a mix of two masters at node k, degrees; 0 where either of them has a corner there. */
double mt_kink(const mt_contour *const masters[2], int k);
