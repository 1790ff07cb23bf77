/* Glyphs of one font, drawn for users of the library. */
#include "geometry/limits.h"
#include "source/handle.h"

static bool has_cubics(const mt_outline *outline) {
    for (int i = 0; i < outline->count; i++)
        for (int k = 0; k < outline->contours[i].count; k++)
            if (outline->contours[i].segments[k].degree == 3) return true;
    return false;
}

mt_status mt_font_draw(mt_font *font, uint32_t glyph, const mt_draw *draw, void *user, double *advance) {
    mt_arena arena = {0};
    mt_outline outline;
    double width, scale = (double)font->units / MT_EM;
    mt_status status = glyph < (uint32_t)mt_font_glyph_count(font) ? MT_OK : MT_NO_GLYPH;
    if (font->face == NULL) status = MT_NO_MEMORY;
    if (status == MT_OK) status = mt_font_outline(font, glyph, &arena, &outline, &width);
    if (status == MT_OK && !draw->cubic_to && has_cubics(&outline)) status = MT_BAD_PARAMETER;
    if (status == MT_OK) {
        mt_outline_draw(&outline, scale, draw, user);
        *advance = width * scale;
    }
    mt_arena_release(&arena);
    return status;
}
