/* Variation sequences: a character and a selector after it, and the glyph that they lead to ('cmap' format 14). */
#pragma once

#include "base/memory.h"
#include "source/font.h"

typedef struct mt_variation_sequence {
    uint32_t selector, code_point;
    uint32_t glyph;
    bool by_default; /* the character's own glyph */
} mt_variation_sequence;

typedef struct mt_variation_sequences {
    int count;
    mt_variation_sequence *list; /* by selector, then by character */
} mt_variation_sequences;

/* The font's sequences, at most MT_VARIATION_SEQUENCES_MAX, in the arena. MT_NO_MEMORY. */
mt_status mt_font_variation_sequences(mt_font *font, mt_arena *arena, mt_variation_sequences *variants);

/* The sequence of a selector and a character; NULL when there is none. */
const mt_variation_sequence *mt_variation_sequences_find(const mt_variation_sequences *variants,
                                                         uint32_t selector, uint32_t code_point);
