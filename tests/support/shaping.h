/* What HarfBuzz makes of a text: where each glyph lies, and what it is attached to. */
#pragma once

#include <hb.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { MT_SHAPED_MAX = 8 };

/* Of each character, in the order of the text. */
typedef struct mt_shaped {
    int count;
    double x[MT_SHAPED_MAX], y[MT_SHAPED_MAX]; /* the glyph's origin, font units */
    double advance[MT_SHAPED_MAX];
    int attached_to[MT_SHAPED_MAX]; /* the character that GPOS attaches its glyph to; -1 for none */
} mt_shaped;

/* A file's face at a place of its weight axis (0 for none), without GSUB, so that each character is one glyph. */
hb_font_t *mt_shaping_open(const char *path, float weight);
/* The same of a font in memory, which has to stay. */
hb_font_t *mt_shaping_font(const uint8_t *bytes, size_t length);

/* Shapes up to MT_SHAPED_MAX characters, each by its own glyph: nothing is composed or decomposed. */
mt_shaped mt_shape_text(hb_font_t *font, hb_script_t script, const uint32_t *text, int count);
