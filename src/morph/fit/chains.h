/* Runs of curves that are smooth on the whole way. */
#ifndef MT_MORPH_FIT_CHAINS_H
#define MT_MORPH_FIT_CHAINS_H

#include "geometry/spline.h"
#include "morph/model/morph.h"

/* What the masters were fitted to: the steps of an alignment, as both sides go on from there; cyclic. */
typedef struct mt_track {
    int count;
    const mt_sample *samples[2];
} mt_track;

/* Fits anew where the masters have nodes that both run smoothly through, but not the mix of them: all curves between two nodes
 * that cannot have a kink, together (geometry/chain.h). Segment i of the masters ends at step steps[i]. Where that takes too
 * many segments, the curves stay as they are. MT_NO_MEMORY. */
mt_status mt_chains_smooth(const mt_track *track, const int *steps, double tolerance, mt_arena *arena,
                           mt_contour_pair *masters);

#endif
