/* Lines of two masters, tidied. */
#pragma once

#include "morph/model/morph.h"

/* Drops the nodes within a line that both masters have, within `tolerance` grid units, and segments without length in both; makes
 * curves of short lines that continue curves smoothly, so that they can bend with these in between. steps[i] belongs to the end of
 * segment i and is dropped with it. */
void mt_contour_pair_tidy_lines(mt_contour_pair *masters, int *steps, double tolerance);
