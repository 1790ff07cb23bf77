#include "glyphset/shaper.h"

#include <hb-ot.h>

#include "sfnt/sfnt.h"

static hb_bool_t nominal_glyph(hb_font_t *hb, void *data, hb_codepoint_t code, hb_codepoint_t *glyph,
                               void *user) {
    (void)hb;
    (void)user;
    *glyph = mt_font_glyph(data, code);
    return *glyph != 0;
}

static bool has_latin(const mt_gsub *gsub) {
    for (int i = 0; i < gsub->layout.system_count; i++)
        if (gsub->layout.systems[i].script == MT_TAG('l', 'a', 't', 'n')) return true;
    return false;
}

static bool make_font(mt_shaper *shaper) {
    shaper->face = mt_face_make(&shaper->tables);
    if (!shaper->face) return false;
    hb_font_funcs_t *functions = hb_font_funcs_create();
    shaper->hb = hb_font_create(shaper->face);
    shaper->buffer = hb_buffer_create();
    hb_font_funcs_set_nominal_glyph_func(functions, nominal_glyph, NULL, NULL);
    hb_font_set_funcs(shaper->hb, functions, (void *)(uintptr_t)shaper->font, NULL);
    hb_font_funcs_destroy(functions);
    hb_buffer_set_cluster_level(shaper->buffer, HB_BUFFER_CLUSTER_LEVEL_MONOTONE_CHARACTERS);
    shaper->has_classes = hb_ot_layout_has_glyph_classes(shaper->face);
    return hb_buffer_allocation_successful(shaper->buffer);
}

mt_status mt_shaper_open(const mt_font *font, const mt_gsub *gsub, mt_arena *arena, mt_shaper *shaper) {
    *shaper = (mt_shaper){.font = font, .has_latin = has_latin(gsub)};
    shaper->tables = (mt_face_tables){.gsub = gsub->table, .glyph_count = mt_font_glyph_count(font)};
    mt_status status = mt_font_table(font, MT_TAG('G', 'D', 'E', 'F'), arena, &shaper->tables.gdef);
    if (status == MT_OK)
        status = mt_font_table(font, MT_TAG('G', 'P', 'O', 'S'), arena, &shaper->tables.gpos);
    return status == MT_OK && !make_font(shaper) ? MT_NO_MEMORY : status;
}

void mt_shaper_close(mt_shaper *shaper) {
    hb_buffer_destroy(shaper->buffer);
    hb_font_destroy(shaper->hb);
    hb_face_destroy(shaper->face);
    *shaper = (mt_shaper){0};
}

mt_shaped_text mt_shaper_shape(mt_shaper *shaper, const uint32_t *codes, int count) {
    hb_buffer_t *buffer = shaper->buffer;
    mt_shaped_text shaped = {0, NULL};
    if (shaper->endless) return shaped;
    hb_buffer_clear_contents(buffer);
    hb_buffer_set_flags(buffer, HB_BUFFER_FLAG_REMOVE_DEFAULT_IGNORABLES);
    hb_buffer_add_codepoints(buffer, codes, count, 0, count);
    hb_buffer_guess_segment_properties(buffer);
    hb_script_t script = hb_buffer_get_script(buffer);
    bool none = script == HB_SCRIPT_INVALID || script == HB_SCRIPT_COMMON || script == HB_SCRIPT_INHERITED;
    if (none && shaper->has_latin) hb_buffer_set_script(buffer, HB_SCRIPT_LATIN);
    hb_buffer_set_language(buffer, HB_LANGUAGE_INVALID);
    hb_shape(shaper->hb, buffer, NULL, 0);
    shaper->endless = !hb_buffer_allocation_successful(buffer);
    if (shaper->endless) return shaped;
    if (HB_DIRECTION_IS_BACKWARD(hb_buffer_get_direction(buffer))) hb_buffer_reverse(buffer);
    shaped.glyphs = hb_buffer_get_glyph_infos(buffer, &shaped.count);
    return shaped;
}

bool mt_shaper_same_class(const mt_shaper *a, uint32_t in_a, const mt_shaper *b, uint32_t in_b) {
    if (!a->has_classes || !b->has_classes) return true;
    bool mark_a = hb_ot_layout_get_glyph_class(a->face, in_a) == HB_OT_LAYOUT_GLYPH_CLASS_MARK;
    bool mark_b = hb_ot_layout_get_glyph_class(b->face, in_b) == HB_OT_LAYOUT_GLYPH_CLASS_MARK;
    return mark_a == mark_b;
}
