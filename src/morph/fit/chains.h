/* Kinks of contours between two masters removed by fitting runs of curves anew. */
#pragma once

#include "geometry/spline.h"
#include "morph/model/morph.h"

/* The samples that the masters were fitted to: of each step of an alignment, with the heading out of it; cyclic. */
typedef struct mt_track {
    int count;
    const mt_sample *samples[2];
} mt_track;

/* Fits curves anew where a node is smooth in both masters, but not in a mix of them: all curves between two nodes that cannot have a
 * kink, together (geometry/chain.h). Segment i of the masters ends at step steps[i]. Where that takes too many segments, the curves
 * stay as they are. MT_NO_MEMORY, MT_TOO_LARGE where the arena's steps do not do. */
mt_status mt_chains_smooth(const mt_track *track, const int *steps, double tolerance, mt_arena *arena,
                           mt_contour_pair *masters);
