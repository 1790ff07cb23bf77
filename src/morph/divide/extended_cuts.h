/* Lengthening parts into each other's ink beyond the cut between them. */
#pragma once

#include "morph/divide/division.h"

/* Lengthens parts beyond their cuts, in both sides: as far as the partner of each reaches where the frames of both sides carry it, and
 * until the sides of a corner meet; or, where `is_cut_twice`, since each side has cuts where the other has gaps, by the gap. The union of a
 * side's parts stays the same. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_extend_cuts(const mt_side *a, mt_cut_side *cut_a, const mt_side *b, mt_cut_side *cut_b,
                         bool is_cut_twice, double flatness, mt_arena *arena);
