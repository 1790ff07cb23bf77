/* From the pair adjustment of several fonts to one structure. */
#pragma once

#include "kerning/pairs.h"

/* `most` is how many cells the new classes of two fonts may make, MT_PAIR_CELLS_MAX at most, and of more fonts the
 * fewer; `steps` is what is left of the steps, and
 * is taken from; there is a source for each font. MT_TOO_LARGE for more than that, MT_NO_MEMORY. */
mt_status mt_pairs_prepare(const mt_pair_source *const *sources, const mt_font_glyphs *glyphs, int most,
                           int64_t *steps, mt_arena *arena, mt_pairs *pairs);
