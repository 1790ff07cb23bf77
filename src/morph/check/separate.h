/* Parts that touch on the way, though both ends hold them apart, make way for each other. */
#ifndef MT_MORPH_CHECK_SEPARATE_H
#define MT_MORPH_CHECK_SEPARATE_H

#include "morph/check/mend.h"

/* Where contours whose components are apart at both ends touch in between, lets those of the smaller one stand aside half-way
 * (mt_contour_pair.displacement), by as little as keeps them apart, when the glyph strays less for it.
 * As mt_morph_blend. */
mt_status mt_separate_parts(mt_mending *m);

#endif
