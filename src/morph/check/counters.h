/* Counters that break open on the way, though both ends have them closed, keep clear. */
#ifndef MT_COUNTERS_H
#define MT_COUNTERS_H

#include "morph/check/mend.h"

/* Lets the contours of holes stand aside half-way (mt_masters.aside), by as little as helps, where the glyph strays less for it.
 * As mt_morph_blend. */
mt_status mt_keep_counters(mt_mending *m);

#endif
