/* The pairs that any font gives one by one. */
#pragma once

#include "kerning/sides.h"

/* Fills the listed pairs: those whose value in any font is not its classes'. The matrices and classes must be there.
 * MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_pairs_list(const mt_pair_side *sides, mt_arena *arena, mt_pairs *pairs);
