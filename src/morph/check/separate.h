/* Parts that touch on the way, though both ends hold them apart, make way for each other. */
#ifndef MT_ASIDE_H
#define MT_ASIDE_H

#include "morph/check/mend.h"

/* Where contours whose components are apart at both ends touch in between, lets those of the smaller one stand aside half-way
 * (mt_masters.aside), by as little as keeps them apart, when the glyph strays less for it.
 * As mt_morph_blend. */
mt_status mt_stand_aside(mt_mending *m);

#endif
