/* Joining two matched components, or parts of components: one contour pair for each pair of rings. */
#pragma once

#include "morph/join/joining.h"

/* Joins two parts: their outer rings and those holes that have a counterpart are aligned, and a contour is fitted to each pair.
 * A hole without a counterpart is slit open, or closes to a point inside the other part's ink. Appends to contours[*count]
 * at most as many contours as both have rings; none when aligning a pair of rings costs more than `most`, or the half-way
 * contours overlap themselves or each other too much. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_join(mt_part a, mt_part b, double most, const mt_join_context *context, mt_arena *arena,
                  mt_contour_pair *contours, int *count);
