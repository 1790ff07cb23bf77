#include "glyphset/inks.h"

enum { UNKNOWN, BLANK, INKED };

mt_status mt_inks_open(mt_font *font, mt_arena *arena, mt_inks *inks) {
    *inks = (mt_inks){.font = font, .count = (uint32_t)mt_font_glyph_count(font)};
    inks->known = mt_arena_new(arena, (size_t)inks->count + 1, sizeof *inks->known);
    return inks->known ? MT_OK : MT_NO_MEMORY;
}

static bool is_blank(mt_inks *inks, uint32_t glyph) {
    bool blank;
    mt_status status = mt_font_is_blank(inks->font, glyph, &blank);
    if (status != MT_OK) inks->status = status;
    return blank;
}

bool mt_inks_blank(mt_inks *inks, uint32_t glyph) {
    if (glyph >= inks->count) return mt_font_composed(inks->font, glyph) && is_blank(inks, glyph);
    if (inks->known[glyph] == UNKNOWN) inks->known[glyph] = is_blank(inks, glyph) ? BLANK : INKED;
    return inks->known[glyph] == BLANK;
}
