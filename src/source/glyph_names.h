/* Names of glyphs. */
#pragma once

#include "source/font.h"

/* The names of 'post', CFF or Type 1, one a glyph, in the arena; NULL for a glyph without one and for one that only tells
 * a number (glyph12, cid00345). *names is NULL for a font without names. MT_NO_MEMORY. */
mt_status mt_font_glyph_names(mt_font *font, mt_arena *arena, const char ***names);

/* A glyph and its name, whatever that tells. */
typedef struct mt_named_glyph {
    const char *name;
    uint32_t glyph;
} mt_named_glyph;

typedef struct mt_name_index {
    int count; /* 0 for a font without names */
    mt_named_glyph *
        list; /* by name; of glyphs that share one, which is against the rules, the first before the others */
} mt_name_index;

/* Puts a list in that order. */
void mt_name_index_sort(mt_name_index *index);
/* All names of the font, in the arena. MT_NO_MEMORY. */
mt_status mt_name_index_make(mt_font *font, mt_arena *arena, mt_name_index *index);
/* The first glyph of that name; 0 where there is none. */
uint32_t mt_name_index_find(const mt_name_index *index, const char *name);
