#include "blend/named_hints.h"

#include <string.h>

#include "base/memory.h"
#include "glyphset/charset.h"
#include "glyphset/naming.h"

/* The lines by name, and the first font's glyph for each. */
typedef struct mt_named_lines {
    int count;
    const mt_hint_line *lines;
    uint32_t *firsts;
} mt_named_lines;

static mt_status find_names(mt_font *first, const mt_named_lines *named, mt_hint_error *error) {
    mt_naming *naming;
    mt_status status = mt_naming_open(first, &naming);
    if (status != MT_OK) return status;
    for (int i = 0; i < named->count && status == MT_OK; i++) {
        const mt_hint_line *line = &named->lines[i];
        if (i > 0 && line->name == line[-1].name)
            named->firsts[i] = named->firsts[i - 1];
        else
            status = mt_naming_find(naming, line->name, strlen(line->name), &named->firsts[i]);
        if (status != MT_NO_GLYPH) continue;
        if (error) *error = (mt_hint_error){line->name_line, "the first font has no glyph of that name"};
        status = MT_BAD_HINTS;
    }
    mt_naming_close(naming);
    return status;
}

/* Of each step, the glyphs that go together with the first font's. */
static mt_status pair(mt_font *const *fonts, int count, const mt_given_pairs *pairs,
                      const mt_named_lines *named, mt_arena *arena, mt_hint_glyphs **glyphs) {
    uint32_t *partners[MT_VARIABLE_FONTS_MAX];
    mt_status status = mt_row_partners(fonts, count, pairs, named->firsts, named->count, arena, partners);
    for (int step = 0; status == MT_OK && step + 1 < count; step++) {
        glyphs[step] = mt_arena_new(arena, (size_t)named->count, sizeof *glyphs[step]);
        if (!glyphs[step]) return MT_NO_MEMORY;
        for (int i = 0; i < named->count; i++) {
            uint32_t a = partners[step][i], b = partners[step + 1][i];
            glyphs[step][i] = (mt_hint_glyphs){a != MT_NO_PARTNER && b != MT_NO_PARTNER, a, b};
        }
    }
    return status;
}

mt_status mt_named_hints_find(mt_font *const *fonts, int count, const mt_given_pairs *pairs,
                              const mt_hint_table *table, mt_arena *arena, mt_hint_glyphs **glyphs,
                              mt_hint_error *error) {
    mt_named_lines named = {.count = table->count - table->character_count};
    if (named.count == 0) return MT_OK;
    named.lines = table->lines + table->character_count;
    named.firsts = mt_arena_new(arena, (size_t)named.count, sizeof *named.firsts);
    if (!named.firsts) return MT_NO_MEMORY;
    mt_status status = find_names(fonts[0], &named, error);
    return status == MT_OK && count > 1 ? pair(fonts, count, pairs, &named, arena, glyphs) : status;
}
