#include "glyphset/match.h"

mt_status mt_glyph_match_new(const mt_font *a, const mt_font *b, mt_arena *arena, mt_glyph_match *match) {
    mt_glyph_match made = {.count_a = mt_font_glyph_count(a), .count_b = mt_font_glyph_count(b)};
    made.partner = mt_arena_new(arena, (size_t)made.count_a + 1, sizeof *made.partner);
    made.origin = mt_arena_new(arena, (size_t)made.count_a + 1, sizeof *made.origin);
    made.taken = mt_arena_new(arena, (size_t)made.count_b + 1, sizeof *made.taken);
    if (!made.partner || !made.origin || !made.taken) return MT_NO_MEMORY;
    for (int i = 0; i < made.count_a; i++) made.partner[i] = MT_NO_PARTNER;
    mt_match_pair(&made, 0, 0, 0);
    *match = made;
    return MT_OK;
}

bool mt_match_pair(mt_glyph_match *match, uint32_t a, uint32_t b, uint32_t origin) {
    if (a >= (uint32_t)match->count_a || b >= (uint32_t)match->count_b) return false;
    if (match->partner[a] != MT_NO_PARTNER) return false;
    match->partner[a] = b;
    match->origin[a] = origin;
    match->taken[b] = true;
    return true;
}
