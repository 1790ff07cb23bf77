/* The joint method for a glyph: joined with one set of settings after the other, mended, and the soundest taken. */
#ifndef MT_MORPH_TRIALS_H
#define MT_MORPH_TRIALS_H

#include "morph/model/hints.h"
#include "morph/model/morph.h"

/* Joins a morph whose components are matched so that it does not stray on the way or, where it does in all settings, as little as
 * was found with MT_EFFORT. As mt_morph_prepare. */
mt_status mt_join_best(mt_morph *morph, const mt_hints *hints, const mt_params *params, mt_arena *arena);

/* How many corners of blends are looked at for a glyph, at most, but for what one set of them takes: two to four seconds. Of 100 Han
 * glyphs that are hard, none or one could be mended with twice as much and not with this. */
enum { MT_EFFORT = 2000000 };

#endif
