/* A source's own tables as bytes, whatever container they came in, and its place on the axes: for the layout, which
 * FreeType does not read. */
#include "source/handle.h"

#include <string.h>

#include FT_TRUETYPE_TABLES_H

/* The tables that a font without layout has not. */
static bool is_layout(uint32_t tag) {
    return tag == MT_TAG('G', 'S', 'U', 'B') || tag == MT_TAG('G', 'P', 'O', 'S') ||
           tag == MT_TAG('G', 'D', 'E', 'F') || tag == MT_TAG('k', 'e', 'r', 'n');
}

void mt_font_drop_layout(mt_font *font) {
    font->without_layout = true;
}

bool mt_font_is_without_layout(const mt_font *font) {
    return font->without_layout;
}

mt_status mt_font_table(const mt_font *font, uint32_t tag, mt_arena *arena, mt_bytes *table) {
    FT_ULong length = 0;
    *table = (mt_bytes){0};
    if (!font->face || !FT_IS_SFNT(font->face) || (font->without_layout && is_layout(tag))) return MT_OK;
    if (FT_Load_Sfnt_Table(font->face, tag, 0, NULL, &length) != 0 || length == 0) return MT_OK;
    uint8_t *bytes = mt_arena_new(arena, length, 1);
    if (!bytes) return MT_NO_MEMORY;
    if (FT_Load_Sfnt_Table(font->face, tag, 0, bytes, &length) != 0) return MT_OK;
    *table = (mt_bytes){bytes, length};
    return MT_OK;
}

bool mt_font_has_table(const mt_font *font, uint32_t tag) {
    FT_ULong length = 0;
    if (!font->face || !FT_IS_SFNT(font->face) || (font->without_layout && is_layout(tag))) return false;
    return FT_Load_Sfnt_Table(font->face, tag, 0, NULL, &length) == 0 && length > 0;
}

int mt_font_place(const mt_font *font, const int32_t **normalized) {
    *normalized = font->place;
    return font->axis_count;
}
