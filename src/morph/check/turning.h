/* How much of a boundary turns on its way: where a stretch goes with one of another heading, the in-between is a slope that neither
 * drawing has. A cut stroke end is one, and a corner that goes with the middle of a side is another. */
#pragma once

#include "morph/model/morph.h"

/* Of the contours of a morph, whose headings are compared in the frames of both sides: 0 where all keep their headings, as in a Minkowski
 * sum; 1 where all turn right round. Swapping A and B changes nothing if the frames are swapped too. O(n). */
double mt_turning(const mt_morph *morph, const mt_frame *a, const mt_frame *b);
