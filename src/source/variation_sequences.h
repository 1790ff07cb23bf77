/* Variation sequences: a character and a selector after it, and the glyph that they lead to ('cmap' format 14). */
#ifndef MT_VARIANTS_H
#define MT_VARIANTS_H

#include "base/memory.h"
#include "source/font.h"

typedef struct mt_variant {
    uint32_t selector, code_point;
    uint32_t glyph;
    bool by_default; /* the character's own glyph */
} mt_variant;

typedef struct mt_variants {
    int count;
    mt_variant *list; /* by selector, then by character */
} mt_variants;

/* The font's sequences, at most MT_VARIANTS_MAX, in the arena. MT_NO_MEMORY. */
mt_status mt_font_variants(mt_font *font, mt_arena *arena, mt_variants *variants);

/* The sequence of a selector and a character; NULL when there is none. */
const mt_variant *mt_variants_find(const mt_variants *variants, uint32_t selector, uint32_t code_point);

#endif
