/* A font's bytes to the outlines of its glyphs, with their advances, references and places on a vertical line. */
#include "fuzz.h"

#include "source/font.h"

enum { GLYPHS = 64 };

static void read_glyph(mt_font *font, uint32_t glyph, mt_arena *arena) {
    mt_outline outline;
    mt_references references;
    mt_vertical vertical;
    double advance;
    fuzz_bound(arena, 0.1);
    if (mt_font_outline(font, glyph, arena, &outline, &advance) == MT_OK)
        fuzz_require(mt_outline_is_valid(&outline));
    if (mt_font_references(font, glyph, arena, &references) == MT_OK)
        for (int i = 0; i < references.count; i++)
            fuzz_require(references.list[i].glyph < (uint32_t)mt_font_glyph_count(font));
    (void)mt_font_vertical(font, glyph, &vertical);
    mt_arena_reset(arena);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length) {
    mt_font *font = fuzz_font(bytes, length);
    mt_arena arena = {0};
    if (!font) return 0;
    int count = mt_font_glyph_count(font);
    for (int i = 0; i < count && i < GLYPHS; i++) read_glyph(font, (uint32_t)i, &arena);
    mt_arena_release(&arena);
    mt_font_close(font);
    return 0;
}
