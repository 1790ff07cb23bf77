/* Names of glyphs. */
#ifndef MT_SOURCE_GLYPH_NAMES_H
#define MT_SOURCE_GLYPH_NAMES_H

#include "glyphset/charset.h"

/* The names of 'post', CFF or Type 1, one a glyph, in the arena; NULL for a glyph without one and for one that only tells
 * a number (glyph12, cid00345). *names is NULL for a font without names. MT_NO_MEMORY. */
mt_status mt_font_glyph_names(mt_font *font, mt_arena *arena, const char ***names);

/* The new font's names, one a glyph, each once: A's where they are letters, digits, dots and underscores, otherwise made of
 * the character (uni0041, u1F600), otherwise of the number. *names is NULL where A has none. MT_NO_MEMORY. */
mt_status mt_glyph_names_make(mt_font *a, const mt_charset *charset, mt_arena *arena, const char ***names);

#endif
