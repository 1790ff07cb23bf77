/* Lengthening parts into each other's ink beyond the cut between them. */
#pragma once

#include "morph/divide/division.h"

/* Where two parts of one side meet at a cut and their partners on the other side have a gap, lengthens the part that ends at the cut
 * by that gap into the ink of the other, so that the two separate half-way and not at once. in_a and in_b are the ink of both sides
 * before they were cut; the union of a side's parts stays the same. MT_NO_MEMORY. */
mt_status mt_extend_cuts(const mt_shape *in_a, mt_cut_side *a, const mt_shape *in_b, mt_cut_side *b,
                         mt_arena *arena);
