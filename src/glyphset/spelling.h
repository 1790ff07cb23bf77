/* Characters that lead to a font's glyphs, as far as substitutions alone tell. */
#pragma once

#include "base/memory.h"
#include "gsub/gsub.h"
#include "source/font.h"

enum { MT_SPELLING_MAX = 16 };

typedef struct mt_spelling {
    int count; /* 0: no text is known */
    const uint32_t *codes;
} mt_spelling;

typedef struct mt_spellings {
    int glyph_count;
    mt_spelling *of; /* each glyph's */
} mt_spellings;

/* A character of `chars` spells its glyph; the inputs of a substitution spell its outputs. What stands around is not looked at.
 * In the arena. MT_NO_MEMORY. */
mt_status mt_spell(const mt_font *font, const mt_gsub *gsub, const uint32_t *chars, int count,
                   mt_arena *arena, mt_spellings *spellings);

/* Appends the glyph's spelling to a text of `length` characters with room for MT_SPELLING_MAX; false when it has none or there
 * is no room. */
bool mt_spell_append(const mt_spellings *spellings, uint32_t glyph, uint32_t *text, int *length);
