/* Which characters and glyphs a variable font of several fonts in a row has. */
#ifndef MT_GLYPHSET_CHARSET_ROW_H
#define MT_GLYPHSET_CHARSET_ROW_H

#include "glyphset/charset.h"

/* The same glyphs, characters and sequences in all of them, in the same order. A glyph that some font has not stays as it is in
 * the first: it has no partner anywhere, and its `a` is the first font's. */
typedef struct mt_charset_row {
    mt_charset *steps;  /* each font with the next: count - 1 of them */
    mt_charset *spokes; /* the first font with each of the others: as many */
} mt_charset_row;

/* Pairs the glyphs of the first font with those of each other one (font/charset.h), and keeps those that have a partner in all
 * of them, or all of the first font's. Where a font cannot hold all further pairs, their characters lead to the first font's
 * one. As mt_charset_make. */
mt_status mt_charset_row_make(mt_font *const *fonts, int count, const mt_charset_request *request,
                              mt_arena *arena, mt_charset_row *row);

#endif
