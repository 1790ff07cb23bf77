/* Pair adjustment, static or varying, as subtables of a lookup. */
#pragma once

#include "kerning/mix.h"
#include "layout/lookup_builder.h"
#include "sfnt/sfnt.h"

/* PairPosFormat1 for the listed pairs, then PairPosFormat2 for the matrix: as many of each as 16-bit offsets ask for.
 * No left glyph is in two of the second format. No subtables where every value is 0. What varies goes into the store;
 * NULL where there is one place. In the arena. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_pairs_write(const mt_mixed_pairs *mixed, mt_var_store *store, mt_arena *arena,
                         mt_bytes **subtables, int *count);
