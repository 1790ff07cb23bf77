/* Which glyphs of a font are blank. */
#pragma once

#include "base/memory.h"
#include "source/font.h"

typedef struct mt_inks {
    mt_font *font;
    uint32_t count;   /* of its glyphs */
    uint8_t *known;   /* of each glyph, where that has been looked at */
    mt_status status; /* MT_NO_MEMORY once there was none for that */
} mt_inks;

/* MT_NO_MEMORY. */
mt_status mt_inks_open(mt_font *font, mt_arena *arena, mt_inks *inks);

/* A glyph that cannot be read, or that the font has not, counts as inked. */
bool mt_inks_blank(mt_inks *inks, uint32_t glyph);
