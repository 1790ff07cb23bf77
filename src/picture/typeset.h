/* The font at one T, made by the blend and read back by HarfBuzz: pictures show what the font file gives. */
#pragma once

#include "picture/picture.h"

#include <cairo.h>
#include <hb.h>

/* What became of a glyph of the first font's. */
typedef struct mt_first_glyph {
    bool kept;
    uint32_t number;     /* in the instances */
    uint32_t code_point; /* as mt_origin */
} mt_first_glyph;

typedef struct mt_typeset {
    uint8_t *bytes;
    mt_first_glyph *firsts; /* of each of the first font's glyphs; the first instance of several has them */
    hb_font_t *font;
    hb_draw_funcs_t *draw;
    mt_at at;
    double units;           /* per em */
    double ascent, descent; /* em, from the baseline; descent is positive */
} mt_typeset;

/* Instances of some characters and glyphs, one for each T; sets the blend's characters and glyphs to these. Once they are made
 * `made` is called, unless NULL, and what it returns is returned. MT_NO_GLYPH when one of the fonts lacks a character,
 * MT_NO_MEMORY, and what mt_blend_fonts gives. */
mt_status mt_typesets_new(mt_blend *blend, const mt_choice *choices, int choice_count, const double *at,
                          int count, mt_fonts_made made, void *user, mt_typeset **instances);
void mt_typesets_free(mt_typeset *instances, int count); /* NULL is fine */

/* The glyph of a choice; false when the font has none. */
bool mt_typeset_glyph(const mt_typeset *instance, const mt_choice *choice, uint32_t *glyph);

/* An upright box of ink around an origin, em, y upwards; `advance` is how far the pen moves on. */
typedef struct mt_extents {
    double left, right, bottom, top, advance;
} mt_extents;

/* A line of text, shaped: its script, direction and language guessed by HarfBuzz from the text. Left to right
 * on the page. Named glyphs stay what they are: no substitution takes one in, and kerning and marks do. */
typedef struct mt_line {
    hb_buffer_t *buffer;
    mt_extents extents;
} mt_line;
mt_status mt_line_shape(const mt_typeset *instance, const mt_choice *text, int length, mt_line *line);
void mt_line_free(mt_line *line); /* all zero is fine */

mt_extents mt_glyph_extents(const mt_typeset *instance, uint32_t glyph);

/* Fills with the current colour, nonzero; (x, y) is the origin on the page and `size` the em. */
void mt_line_draw(const mt_typeset *instance, const mt_line *line, cairo_t *cairo, double x, double y,
                  double size);
void mt_glyph_draw(const mt_typeset *instance, uint32_t glyph, cairo_t *cairo, double x, double y,
                   double size);
