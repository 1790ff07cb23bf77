/* Contours that meet at a cut made to overlap. */
#pragma once

#include "morph/model/morph.h"

/* Moves the points of all contours that lie in the ink of their side, and so on a cut, out of their own contour by `reach` grid units.
 * The ink of each side stays the same. The masters are copied. MT_NO_MEMORY. */
mt_status mt_overlap_seams(const mt_morph *morph, double reach, mt_arena *arena,
                           mt_variable_outline *variable);
