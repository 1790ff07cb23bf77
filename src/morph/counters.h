/* Counters that break open on the way, though both ends have them closed, keep clear. */
#ifndef MT_COUNTERS_H
#define MT_COUNTERS_H

#include "morph/census.h"

/* Lets the contours of holes stand aside half-way (mt_masters.aside), by as little as helps, where the glyph strays less for it.
 * *by: how it strays, before and after. As mt_morph_blend. */
mt_status mt_keep_counters(mt_morph *morph, const mt_params *params, mt_arena *arena, mt_straying *by);

#endif
