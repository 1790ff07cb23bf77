/* A line of text as its font sets it: shaped by HarfBuzz with the font's own tables at its place on the axes. */
#pragma once

#include "source/font.h"

typedef struct mt_line_glyph {
    uint32_t glyph;
    int first, count; /* the characters that it and its cluster stand for, numbers in the text */
    double x, y;      /* where its origin is, grid units from the start of the baseline */
} mt_line_glyph;

/* In the order of the page, from left to right. */
typedef struct mt_shaped_line {
    int count;
    mt_line_glyph *glyphs;
    double advance; /* grid units */
} mt_shaped_line;

/* Shapes with the features that are on by default, in the arena. Not for two threads at once with one font. MT_NO_MEMORY,
 * MT_ENDLESS_LOOKUPS where HarfBuzz gives up, MT_TOO_LARGE for more than MT_LINE_MAX glyphs. */
#define MT_LINE_MAX 1024
mt_status mt_shape_line(mt_font *font, const uint32_t *codes, int count, mt_arena *arena,
                        mt_shaped_line *line);
