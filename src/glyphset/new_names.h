/* Names of the new font's glyphs. */
#pragma once

#include "glyphset/charset.h"

/* The new font's names, one a glyph, each once: A's where they are names in PostScript, otherwise made of
 * the character (uni0041, u1F600), otherwise of the number. *names is NULL where A has none. MT_NO_MEMORY. */
mt_status mt_glyph_names_make(mt_font *a, const mt_charset *charset, mt_arena *arena, const char ***names);
