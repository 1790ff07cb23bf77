#include "glyphset/spelling.h"

#include <string.h>

enum { ROUNDS_MAX = 16 };

bool mt_spell_append(const mt_spellings *spellings, uint32_t glyph, uint32_t *text, int *length) {
    mt_spelling spelling = glyph < (uint32_t)spellings->glyph_count ? spellings->of[glyph] : (mt_spelling){0};
    if (!spelling.count || *length + spelling.count > MT_SPELLING_MAX) return false;
    memcpy(text + *length, spelling.codes, (size_t)spelling.count * sizeof *text);
    *length += spelling.count;
    return true;
}

/* Spells those outputs that have no spelling yet. *found is set when there was one. */
static mt_status spell_outputs(const mt_spellings *spellings, const mt_substitution *substitution,
                               mt_arena *arena, bool *found) {
    const uint16_t *outputs = substitution->glyphs + substitution->inputs;
    uint32_t text[MT_SPELLING_MAX], *kept = NULL;
    int length = 0;
    bool missing = false;
    for (int i = 0; i < substitution->outputs; i++) missing |= !spellings->of[outputs[i]].count;
    for (int i = 0; i < substitution->inputs && missing; i++)
        missing = mt_spell_append(spellings, substitution->glyphs[i], text, &length);
    if (!missing) return MT_OK;
    kept = mt_arena_new(arena, (size_t)length, sizeof *kept);
    if (!kept) return MT_NO_MEMORY;
    memcpy(kept, text, (size_t)length * sizeof *kept);
    for (int i = 0; i < substitution->outputs; i++)
        if (!spellings->of[outputs[i]].count) spellings->of[outputs[i]] = (mt_spelling){length, kept};
    *found = true;
    return MT_OK;
}

static mt_status spell_lookup(const mt_spellings *spellings, const mt_gsub_lookup *lookup, mt_arena *arena,
                              bool *found) {
    mt_status status = MT_OK;
    for (int i = 0; i < lookup->subtable_count; i++)
        for (int k = 0; k < lookup->subtables[i].count && status == MT_OK; k++)
            status = spell_outputs(spellings, &lookup->subtables[i].list[k], arena, found);
    return status;
}

mt_status mt_spell(const mt_font *font, const mt_gsub *gsub, const uint32_t *chars, int count,
                   mt_arena *arena, mt_spellings *spellings) {
    /* A font whose FreeType ran out of memory counts no glyphs any more. */
    mt_spellings made = {.glyph_count = gsub->glyph_count};
    made.of = mt_arena_new(arena, (size_t)made.glyph_count + 1, sizeof *made.of);
    if (!made.of) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) {
        mt_spelling *spelling = &made.of[mt_font_glyph(font, chars[i])];
        if (!spelling->count) *spelling = (mt_spelling){1, &chars[i]};
    }
    made.of[0] = (mt_spelling){0};
    mt_status status = MT_OK;
    bool found = true;
    for (int round = 0; round < ROUNDS_MAX && found && status == MT_OK; round++) {
        found = false;
        for (int i = 0; i < gsub->layout.lookup_count && status == MT_OK; i++)
            status = spell_lookup(&made, &gsub->lookups[i], arena, &found);
    }
    if (status == MT_OK) *spellings = made;
    return status;
}
