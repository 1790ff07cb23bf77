/* Several neighbouring parts of a key frame as one, where they become one part of the next. */
#pragma once

#include "motion/figure.h"

/* The parts from `first` on, together about the origin of the first: their shape alone, in the arena. MT_TOO_LARGE where they lie too far
 * apart, MT_NO_MEMORY, and as mt_union. */
mt_status mt_group_parts(const mt_figure *figure, int first, int count, mt_arena *arena,
                         mt_figure_part *group);
