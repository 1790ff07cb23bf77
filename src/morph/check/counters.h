/* Keeping holes closed that break open in between, though both ends have them. */
#pragma once

#include "morph/check/mend.h"

/* Lets the contours of holes stand aside half-way (mt_contour_pair.displacement), by as little as helps, where that leaves less error.
 * As mt_morph_blend. */
mt_status mt_keep_counters(mt_mending *m);
