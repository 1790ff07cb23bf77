/* Contours that lie side by side, laid over one another a little. */
#ifndef MT_MORPH_BETWEEN_SEAM_OVERLAP_H
#define MT_MORPH_BETWEEN_SEAM_OVERLAP_H

#include "morph/model/morph.h"

/* Where a side was cut, the contours on both sides of the cut meet in a line. Their points along it are rounded one by one, and
 * a hairline would show between them. So each point of a master that lies in the ink of its side, at least twice `reach` grid
 * units from the border, moves out of its own contour by `reach`: into the ink, so that this side stays what it is. A curve's
 * control point moves where all of its curve lies in the ink. Where a segment lies in the ink, however short, so do two points
 * that are put in near its ends, as far as there is ink. The masters are copied.
 * MT_NO_MEMORY. */
mt_status mt_overlap_seams(const mt_morph *morph, double reach, mt_arena *arena, mt_variable_outline *moving);

#endif
