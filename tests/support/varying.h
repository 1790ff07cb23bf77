/* Fonts that vary along one axis, put together by the tests. */
#pragma once

#include <hb.h>

#include "base/memory.h"
#include "gpos/positions.h"
#include "source/font.h"

/* An 'fvar' of the one axis MORF, 0 … 100, by default 0. */
mt_bytes mt_test_fvar(mt_arena *arena);

/* A 'gvar' of that axis by which no outline varies; FreeType wants one. */
mt_bytes mt_test_gvar(int glyph_count, mt_arena *arena);

/* The GPOS of `font_count` fonts that varies, and the GDEF `plain` with its store. As mt_positions_write_varying. */
mt_status mt_test_write_varying(const mt_positions *positions, int font_count, mt_bytes plain,
                                mt_arena *arena, mt_bytes *gpos, mt_bytes *gdef);

/* Puts the font at a place of the axis, 0 … 1. */
void mt_test_place_on_axis(hb_font_t *font, double place);
