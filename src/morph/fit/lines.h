/* Lines of two masters as a designer would leave them. */
#ifndef MT_MORPH_FIT_LINES_H
#define MT_MORPH_FIT_LINES_H

#include "morph/model/morph.h"

/* Drops the nodes in the middle of what is one line in both masters, within `tolerance` grid units, and segments that have no
 * length in either; makes curves of lines that are too short to be seen as such and continue curves smoothly, so that they can
 * bend with these on the way. steps[i], which goes with the end of segment i, is dropped with it. */
void mt_contour_pair_tidy_lines(mt_contour_pair *masters, int *steps, double tolerance);

#endif
