/* Reconnecting parts that separate in between, though an end has them in one component. */
#pragma once

#include "morph/check/mend.h"

/* Displaces the contours of the smaller part half-way (mt_contour_pair.displacement), just as far as closes the gap, where that leaves
 * less error. As mt_morph_blend. */
mt_status mt_reconnect_parts(mt_mending *m);
