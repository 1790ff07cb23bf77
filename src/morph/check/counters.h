/* Counters that break open on the way, though both ends have them closed, keep clear. */
#ifndef MT_MORPH_CHECK_COUNTERS_H
#define MT_MORPH_CHECK_COUNTERS_H

#include "morph/check/mend.h"

/* Lets the contours of holes stand aside half-way (mt_contour_pair.displacement), by as little as helps, where the glyph strays less for it.
 * As mt_morph_blend. */
mt_status mt_keep_counters(mt_mending *m);

#endif
