/* Names of glyphs. */
#pragma once

#include "source/font.h"

/* The names of 'post', CFF or Type 1, one a glyph, in the arena; NULL for a glyph without one and for one that only tells
 * a number (glyph12, cid00345). *names is NULL for a font without names. MT_NO_MEMORY. */
mt_status mt_font_glyph_names(mt_font *font, mt_arena *arena, const char ***names);
