/* Parts that come apart on the way, though an end holds them together, are drawn together. */
#ifndef MT_MORPH_CHECK_RECONNECT_H
#define MT_MORPH_CHECK_RECONNECT_H

#include "morph/check/mend.h"

/* Where contours that are one component at an end are more in between than at either, lets those of the smaller part come nearer
 * half-way (mt_contour_pair.displacement), as far as closes the gap, when the glyph strays less for it.
 * As mt_morph_blend. */
mt_status mt_reconnect_parts(mt_mending *m);

#endif
