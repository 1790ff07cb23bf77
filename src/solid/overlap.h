/* Pieces made to overlap a little where they were cut apart. */
#pragma once

#include "solid/cells.h"

/* By how much each point of a part moves, grid units, so that its walls to other cells come to lie MT_OVERLAP units beyond the cut, and
 * nothing leaves the solid that was within it. MT_NO_MEMORY. */
mt_status mt_part_overlap(mt_arena *arena, const mt_cells *cells, const mt_part *part, mt_vector3 **moves);

/* Sums of two pieces that only touch may touch no more when their coordinates are rounded to a file's 24 bits, which is a grid unit: there
 * would be a seam. Six units on both sides are twelve, and 4e-7 of the solid's longest side. */
#define MT_OVERLAP 6.0
