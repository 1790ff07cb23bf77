/* GSUB and GPOS at one place on a font's axes. */
#pragma once

#include "base/memory.h"
#include "morphotype.h"
#include "sfnt/sfnt.h"

/* A table of version 1.0 with the features that hold at the place on the axes, as mt_font_place gives it, and without the
 * features' parameters, which name entries of the font's 'name'. Empty for a table that has no features or whose offsets
 * would not do. MT_NO_MEMORY. */
mt_status mt_layout_place(mt_bytes table, const int32_t *place, int axis_count, mt_arena *arena,
                          mt_bytes *placed);
