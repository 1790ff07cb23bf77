#include "glyphset/match.h"

#include "source/glyph_names.h"

/* The names of B's free glyphs, of which .notdef is none. */
static mt_status index_free(const mt_glyph_match *match, const char *const *names, mt_arena *arena,
                            mt_name_index *index) {
    *index = (mt_name_index){0, mt_arena_new(arena, (size_t)match->count_b + 1, sizeof *index->list)};
    if (!index->list) return MT_NO_MEMORY;
    for (int i = 0; i < match->count_b; i++)
        if (names[i] && !match->taken[i])
            index->list[index->count++] = (mt_named_glyph){names[i], (uint32_t)i};
    mt_name_index_sort(index);
    return MT_OK;
}

mt_status mt_match_names(mt_glyph_match *match, mt_font *a, mt_font *b, mt_arena *arena) {
    const char **names_a, **names_b;
    mt_name_index free_names;
    mt_status status = mt_font_glyph_names(a, arena, &names_a);
    if (status == MT_OK) status = mt_font_glyph_names(b, arena, &names_b);
    if (status != MT_OK || !names_a || !names_b) return status;
    status = index_free(match, names_b, arena, &free_names);
    for (int i = 0; status == MT_OK && i < match->count_a; i++) {
        uint32_t found = names_a[i] ? mt_name_index_find(&free_names, names_a[i]) : 0;
        if (found && !match->taken[found]) mt_match_form(match, (uint32_t)i, found, 0);
    }
    return status;
}
