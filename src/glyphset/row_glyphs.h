/* The glyphs of a new font that lies between two fonts or more in a row: each is one glyph of every font. */
#ifndef MT_GLYPHSET_ROW_GLYPHS_H
#define MT_GLYPHSET_ROW_GLYPHS_H

#include "glyphset/charset.h"
#include "glyphset/places.h"

/* A glyph that some font has not stays as it is in the first: no other font has it here. */
typedef struct mt_row_glyphs {
    mt_charset charset;   /* the characters, and the first font's glyphs with those of the second */
    mt_font_glyphs fonts; /* the glyphs of every font */
} mt_row_glyphs;

/* Pairs the glyphs of the first font with those of each other one (charset.h), and keeps those that have a partner in all
 * of them, or all of the first font's. Where a font cannot hold all further pairs, their characters lead to the first font's
 * one. As mt_charset_make. */
mt_status mt_row_glyphs_make(mt_font *const *fonts, int count, const mt_charset_request *request,
                             mt_arena *arena, mt_row_glyphs *glyphs);

#endif
