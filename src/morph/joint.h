/* The joint way: matched components aligned along their boundaries, so that each becomes one moving contour
 * with its holes. */
#ifndef MT_JOINT_H
#define MT_JOINT_H

#include "morph/morph.h"

/* Joins component k of A with component l of B: aligns their outer rings and those holes that have a
 * counterpart; a hole without one closes to a point inside the other component's ink. Writes at most as many
 * contours as both have rings, and their number to *made; none when the boundaries cannot be aligned so that
 * the half-way contours keep clear of themselves and of each other. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_join(const mt_side *a, int k, const mt_side *b, int l, const mt_params *params, mt_arena *arena,
                  mt_masters *contours, int *made);

#endif
