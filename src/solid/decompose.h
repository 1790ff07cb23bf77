/* A solid cut into pieces that are convex, or nearly. */
#pragma once

#include "solid/cells.h"
#include "solid/depth.h"

/* Cuts and merges cells until each is a ball whose hull leaves it by no more than `depth` grid units, or is convex but for rounding when
 * `depth` is 0. Cells have new
 * numbers then. MT_TOO_LARGE for too many pieces, MT_BAD_GEOMETRY when no plane
 * cuts a cell that is not yet so, MT_NO_MEMORY. */
mt_status mt_cells_decompose(mt_cells *cells, double depth);

/* Whether a part is such a piece; where it is a ball that is not near enough to convex, `found` is a deep place. MT_NO_MEMORY. */
mt_status mt_part_is_done(mt_arena *arena, const mt_cells *cells, const mt_part *part, double depth,
                          bool *done, mt_depth *found);
