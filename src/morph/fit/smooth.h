/* No kinks on the way. */
#ifndef MT_MORPH_FIT_SMOOTH_H
#define MT_MORPH_FIT_SMOOTH_H

#include "morph/model/morph.h"

/* Where both masters run smoothly through a node but head differently, the contour between them has a kink there, unless
 * the handles on both sides of the node have the same ratio in both masters: then the mixed handles stay in line for
 * every T. Moves such nodes along their own tangents to a common ratio, as far as no master departs from its curve by more
 * than `tolerance` (grid units), and no handle is used up. Ends and order of the segments stay; so does everything when A and B are swapped.
 * MT_NO_MEMORY. */
mt_status mt_contour_pair_smooth(mt_contour_pair *masters, double tolerance, mt_arena *arena);

/* Whether a contour runs smoothly through node k, the end of segment k; where it waits, from what is before to what is after. */
bool mt_is_smooth(const mt_contour *contour, int k);

/* By how many degrees the mix of two masters turns at node k, the most on the way from one to the other; 0 where either of them
 * has a corner there. */
double mt_kink(const mt_contour *const masters[2], int k);

#endif
