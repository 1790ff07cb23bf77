/* Parts that come apart on the way, though an end holds them together, are drawn together. */
#ifndef MT_TOGETHER_H
#define MT_TOGETHER_H

#include "morph/check/mend.h"

/* Where contours that are one component at an end are more in between than at either, lets those of the smaller part come nearer
 * half-way (mt_masters.aside), as far as closes the gap, when the glyph strays less for it.
 * As mt_morph_blend. */
mt_status mt_draw_together(mt_mending *m);

#endif
