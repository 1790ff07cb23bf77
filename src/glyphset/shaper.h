/* A font's own shaping by HarfBuzz: which glyphs a text leads to. */
#pragma once

#include <hb.h>

#include "base/memory.h"
#include "gsub/gsub.h"
#include "sfnt/layout_face.h"
#include "source/font.h"

typedef struct mt_shaper {
    mt_font *font;
    mt_face_tables tables;
    hb_face_t *face;
    hb_font_t *hb;
    hb_buffer_t *buffer;
    bool has_latin, has_classes;
    bool endless; /* HarfBuzz gave up on a text, which had become 64 times as long, and over 16,384 glyphs */
    int32_t *advances; /* of each glyph, font units, where it has been asked for */
    mt_status status;  /* MT_NO_MEMORY once there was none for that */
} mt_shaper;

/* The glyphs of a shaped text in the order of its characters; they belong to the shaper until it shapes the next one. */
typedef struct mt_shaped_text {
    unsigned count;
    const hb_glyph_info_t
        *glyphs; /* codepoint: the glyph, one of the font's; cluster: the place of its first character */
    const hb_glyph_position_t *at; /* font units */
    bool backward;                 /* the line runs from the last glyph to the first */
} mt_shaped_text;

/* The shaper refers to itself: it stays where it is. `gsub` and the arena outlive it. MT_NO_MEMORY. */
mt_status mt_shaper_open(mt_font *font, const mt_gsub *gsub, mt_arena *arena, mt_shaper *shaper);
void mt_shaper_close(mt_shaper *shaper); /* all zero is fine */

/* Shapes with the features that are on by default. Signs of no script are shaped as Latin where the font has it. No glyphs
 * for a text that has no end, and for all after it. */
mt_shaped_text mt_shaper_shape(mt_shaper *shaper, const uint32_t *codes, int count);

/* The glyph's advance in font units; 0 where it cannot be read. */
int32_t mt_shaper_advance(mt_shaper *shaper, uint32_t glyph);

/* Whether GDEF has the glyph as a mark. */
bool mt_shaper_is_mark(const mt_shaper *shaper, uint32_t glyph);

/* Whether GDEF has both glyphs as marks or neither, as far as it is known. A mark that has an advance, such as an Indic vowel sign,
 * goes with any glyph. */
bool mt_shaper_same_class(mt_shaper *a, uint32_t in_a, mt_shaper *b, uint32_t in_b);
