#include "glyphset/match.h"

enum { UNKNOWN, BLANK, INKED };

mt_status mt_glyph_match_new(mt_font *a, mt_font *b, mt_arena *arena, mt_glyph_match *match) {
    mt_glyph_match made = {.a = a, .b = b};
    made.count_a = mt_font_glyph_count(a);
    made.count_b = mt_font_glyph_count(b);
    made.partner = mt_arena_new(arena, (size_t)made.count_a + 1, sizeof *made.partner);
    made.origin = mt_arena_new(arena, (size_t)made.count_a + 1, sizeof *made.origin);
    made.taken = mt_arena_new(arena, (size_t)made.count_b + 1, sizeof *made.taken);
    made.ink_a = mt_arena_new(arena, (size_t)made.count_a + 1, sizeof *made.ink_a);
    made.ink_b = mt_arena_new(arena, (size_t)made.count_b + 1, sizeof *made.ink_b);
    if (!made.partner || !made.origin || !made.taken || !made.ink_a || !made.ink_b) return MT_NO_MEMORY;
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

/* A glyph that cannot be read counts as inked. */
static uint8_t find_ink(mt_glyph_match *match, mt_font *font, uint32_t glyph, uint8_t *known) {
    mt_arena arena = {0};
    mt_outline outline;
    double advance;
    if (*known != UNKNOWN) return *known;
    mt_status status = mt_font_outline(font, glyph, &arena, &outline, &advance);
    if (status == MT_NO_MEMORY) match->status = status;
    *known = status == MT_OK && outline.count == 0 ? BLANK : INKED;
    mt_arena_release(&arena);
    return *known;
}

bool mt_match_form(mt_glyph_match *match, uint32_t a, uint32_t b, uint32_t origin) {
    if (a >= (uint32_t)match->count_a || b >= (uint32_t)match->count_b) return false;
    if (match->partner[a] != MT_NO_PARTNER) return false;
    bool alike =
        find_ink(match, match->a, a, &match->ink_a[a]) == find_ink(match, match->b, b, &match->ink_b[b]);
    return alike && mt_match_pair(match, a, b, origin);
}
