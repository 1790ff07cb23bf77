/* Where lines are drawn: around what is seen, where one part stands before another, and at creases. */
#pragma once

#include "scene/samples.h"

/* Lines are drawn this many samples to each side of where they are. */
enum { MT_LINE_REACH = 2 };

/* Sets ink[i] for each sample that a line covers; lines that begin outside of the samples are not known. `marks` has room for a byte a
 * sample. */
void mt_lines_find(const mt_seen_mesh *seen, const mt_samples *samples, uint8_t *marks, uint8_t *ink);
