/* Hints that change nothing: what they say goes together did so before, or they lie too far from what they are for. */
#pragma once

#include "blend/pair.h"

/* For each hint of a prepared glyph, whether the morph is the same without it, in the arena; *idle is NULL where there are no
 * hints. Prepares the glyph once for each. As mt_pair_prepare. */
mt_status mt_pair_find_idle_hints(mt_row *row, int step, uint32_t a, uint32_t b, const mt_glyph_pair *pair,
                                  mt_arena *arena, bool **idle);
