#include "glyphset/places.h"

mt_between mt_between_at(const mt_places *places, int i) {
    double at = places->at[i];
    int last = places->font_count - 2, first = at < last ? (int)at : last;
    return (mt_between){first, at - first};
}

mt_status mt_font_glyphs_make(const mt_charset *charsets, int font_count, mt_arena *arena,
                              mt_font_glyphs *glyphs) {
    mt_font_glyphs made = {.font_count = font_count, .glyph_count = charsets->glyph_count};
    for (int k = 0; k < font_count; k++) {
        const mt_charset *charset = &charsets[k ? k - 1 : 0];
        uint32_t *of = mt_arena_new(arena, (size_t)made.glyph_count, sizeof *of);
        if (!of) return MT_NO_MEMORY;
        for (int i = 0; i < made.glyph_count; i++) of[i] = k ? charset->glyphs[i].b : charset->glyphs[i].a;
        made.of[k] = of;
    }
    *glyphs = made;
    return MT_OK;
}
