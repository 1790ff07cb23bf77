/* Separating parts that touch in between, though they are apart at both ends. */
#pragma once

#include "morph/check/mend.h"

/* Displaces the contours of the smaller part half-way (mt_contour_pair.displacement), by as little as keeps the two apart, where that
 * leaves less error. As mt_morph_blend. */
mt_status mt_separate_parts(mt_mending *m);
