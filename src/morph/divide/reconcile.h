/* Cutting two glyphs until their parts correspond one to one, as far as they can. */
#pragma once

#include "morph/divide/division.h"

/* Divides both sides into parts (division.h), and the parts without a good partner again by themselves; parts that are left on both
 * sides at last are paired at any cost. `hints` is not NULL. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_reconcile(const mt_side *a, const mt_side *b, const mt_hints *hints, const mt_settings *settings,
                       mt_arena *arena, mt_cut_side *cut_a, mt_cut_side *cut_b);
