/* A key frame as it is drawn: a text of a font, glyphs by their names, in parts that move one by one.
 *
 * A part is what one cluster of the text draws: a letter with its marks, a ligature, a syllable. Parts without ink are left out. */
#pragma once

#include "geometry/outline.h"
#include "source/font.h"

/* Where a part has several glyphs, and so none that hints are about. */
#define MT_SEVERAL_GLYPHS UINT32_MAX

typedef struct mt_figure_part {
    uint32_t glyph;       /* its only one, or MT_SEVERAL_GLYPHS */
    const uint32_t *text; /* its characters, NULL for a glyph by its name */
    int text_length;
    mt_outline drawing; /* as its font draws it, about an origin of its own */
    mt_shape shape;     /* the same, resolved */
    mt_vector place;    /* of the origin, grid units, from the middle of the figure's line */
} mt_figure_part;

typedef struct mt_figure {
    int count;             /* at least one */
    mt_figure_part *parts; /* in the order of the page */
    double advance;        /* grid units */
} mt_figure;

/* Reads what `text` asks for, with chords within `tolerance` (1/1000 em), in the arena:
 *
 *     Word        shaped by HarfBuzz, UTF-8
 *     /a/b.alt    glyphs by their names, side by side
 *     //b, /      a text that begins with a slash
 *
 * Not for two threads at once with one font. MT_BAD_PARAMETER for what is no UTF-8, MT_NO_GLYPH, MT_BLANK when there is no ink,
 * MT_TOO_LARGE, and what mt_shape_line and mt_outline_shape give. *lacking: with MT_NO_GLYPH, where in the text the font has no
 * glyph. */
mt_status mt_figure_read(mt_font *font, const char *text, double tolerance, mt_arena *arena,
                         mt_figure *figure, const char **lacking);
