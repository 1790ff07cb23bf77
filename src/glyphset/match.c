#include "glyphset/match.h"

mt_status mt_glyph_match_new(mt_font *a, mt_font *b, mt_arena *arena, mt_glyph_match *match) {
    mt_glyph_match made = {.a = a, .b = b};
    made.count_a = mt_font_glyph_count(a);
    made.count_b = mt_font_glyph_count(b);
    made.partner = mt_arena_new(arena, (size_t)made.count_a + 1, sizeof *made.partner);
    made.origin = mt_arena_new(arena, (size_t)made.count_a + 1, sizeof *made.origin);
    made.taken = mt_arena_new(arena, (size_t)made.count_b + 1, sizeof *made.taken);
    if (!made.partner || !made.origin || !made.taken) return MT_NO_MEMORY;
    mt_status status = mt_inks_open(a, arena, &made.ink_a);
    if (status == MT_OK) status = mt_inks_open(b, arena, &made.ink_b);
    if (status != MT_OK) return status;
    for (int i = 0; i < made.count_a; i++) made.partner[i] = MT_NO_PARTNER;
    mt_match_pair(&made, 0, 0, 0);
    *match = made;
    return MT_OK;
}

static bool are_glyphs(const mt_glyph_match *match, uint32_t a, uint32_t b) {
    return a < (uint32_t)match->count_a && (b < (uint32_t)match->count_b || mt_font_composed(match->b, b));
}

bool mt_match_pair(mt_glyph_match *match, uint32_t a, uint32_t b, uint32_t origin) {
    if (!are_glyphs(match, a, b)) return false;
    if (match->partner[a] != MT_NO_PARTNER) return false;
    match->partner[a] = b;
    match->origin[a] = origin;
    if (b < (uint32_t)match->count_b) match->taken[b] = true;
    return true;
}

bool mt_match_form(mt_glyph_match *match, uint32_t a, uint32_t b, uint32_t origin) {
    if (!are_glyphs(match, a, b)) return false;
    if (match->partner[a] != MT_NO_PARTNER) return false;
    bool matters = !match->reached || match->reached[a];
    if (matters && mt_inks_blank(&match->ink_a, a) != mt_inks_blank(&match->ink_b, b)) return false;
    return mt_match_pair(match, a, b, origin);
}
