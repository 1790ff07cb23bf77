#include "source/given_pairs.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"

/* Rows by their first glyph, which is where they begin. */
static int by_first(const void *p, const void *q) {
    uint32_t x = *(const uint32_t *)p, y = *(const uint32_t *)q;
    return (x > y) - (x < y);
}

static bool are_glyphs(const uint32_t *row, mt_font *const *fonts, int font_count) {
    for (int i = 0; i < font_count; i++)
        if (row[i] == 0 || row[i] >= (uint32_t)mt_font_glyph_count(fonts[i])) return false;
    return true;
}

static bool is_good(const mt_given_pairs *pairs, mt_font *const *fonts) {
    for (int i = 0; i < pairs->count; i++) {
        const uint32_t *row = pairs->glyphs + (size_t)i * (size_t)pairs->font_count;
        if (!are_glyphs(row, fonts, pairs->font_count)) return false;
        if (i > 0 && row[0] == row[-pairs->font_count]) return false;
    }
    return true;
}

mt_status mt_given_pairs_make(const uint32_t *glyphs, int count, mt_font *const *fonts, int font_count,
                              mt_given_pairs *pairs) {
    size_t width = (size_t)font_count * sizeof *glyphs;
    mt_given_pairs made = {font_count, count, NULL};
    made.glyphs = mt_new((size_t)count + 1, width);
    if (!made.glyphs) return MT_NO_MEMORY;
    if (count > 0) memcpy(made.glyphs, glyphs, (size_t)count * width);
    if (count > 0) qsort(made.glyphs, (size_t)count, width, by_first);
    if (is_good(&made, fonts)) {
        *pairs = made;
        return MT_OK;
    }
    mt_given_pairs_free(&made);
    return MT_BAD_PARAMETER;
}

void mt_given_pairs_free(mt_given_pairs *pairs) {
    mt_free(pairs->glyphs);
    *pairs = (mt_given_pairs){0};
}

uint32_t mt_given_partner(const mt_given_pairs *pairs, uint32_t first, int font) {
    if (!pairs || !pairs->count) return 0;
    size_t width = (size_t)pairs->font_count * sizeof *pairs->glyphs;
    const uint32_t *row = bsearch(&first, pairs->glyphs, (size_t)pairs->count, width, by_first);
    return row ? row[font] : 0;
}

uint32_t mt_given_glyph(const mt_given_pairs *pairs, mt_font *const *fonts, int font, uint32_t code_point) {
    uint32_t given = mt_given_partner(pairs, mt_font_glyph(fonts[0], code_point), font);
    return given ? given : mt_font_glyph(fonts[font], code_point);
}
