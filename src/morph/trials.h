/* The joint method for a glyph: joined with one set of settings after the other, repaired, and the best taken. */
#pragma once

#include "morph/model/hints.h"
#include "morph/model/morph.h"

/* Joins a morph whose components are matched, with the least topology error that MT_EFFORT finds. As mt_morph_prepare. */
mt_status mt_join_best(mt_morph *morph, const mt_hints *hints, const mt_params *params, mt_arena *arena);

/* The corners of blends that are looked at for a glyph, at most, but for one set of settings: two to four seconds. Of 100 hard Han
 * glyphs, twice as much repaired at most one more. */
enum { MT_EFFORT = 2000000 };
