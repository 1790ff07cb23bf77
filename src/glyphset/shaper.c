#include "glyphset/shaper.h"

#include <hb-ot.h>
#include <math.h>

#include "geometry/limits.h"
#include "sfnt/sfnt.h"
#include "source/spec.h"

enum { UNKNOWN = INT32_MIN };

static hb_bool_t nominal_glyph(hb_font_t *hb, void *data, hb_codepoint_t code, hb_codepoint_t *glyph,
                               void *user) {
    const mt_shaper *shaper = data;
    (void)hb;
    (void)user;
    *glyph = mt_font_glyph(shaper->font, code);
    return *glyph != 0;
}

int32_t mt_shaper_advance(mt_shaper *shaper, uint32_t glyph) {
    double advance = 0;
    if (glyph >= (uint32_t)shaper->tables.glyph_count) return 0;
    if (shaper->advances[glyph] != UNKNOWN) return shaper->advances[glyph];
    if (mt_font_advance(shaper->font, glyph, &advance) == MT_NO_MEMORY) shaper->status = MT_NO_MEMORY;
    shaper->advances[glyph] = (int32_t)lround(advance * mt_font_units_per_em(shaper->font) / MT_EM);
    return shaper->advances[glyph];
}

static hb_position_t glyph_advance(hb_font_t *hb, void *data, hb_codepoint_t glyph, void *user) {
    (void)hb;
    (void)user;
    return mt_shaper_advance(data, glyph);
}

static bool has_latin(const mt_gsub *gsub) {
    for (int i = 0; i < gsub->layout.system_count; i++)
        if (gsub->layout.systems[i].script == MT_TAG('l', 'a', 't', 'n')) return true;
    return false;
}

/* On the axes of a variable font. */
static void set_place(const mt_shaper *shaper) {
    const int32_t *place;
    int coords[MT_SPEC_AXES], count = mt_font_place(shaper->font, &place);
    for (int i = 0; i < count; i++) coords[i] = place[i] >> 2;
    if (count) hb_font_set_var_coords_normalized(shaper->hb, coords, (unsigned)count);
}

static bool make_font(mt_shaper *shaper) {
    shaper->face = mt_face_make(&shaper->tables);
    if (!shaper->face) return false;
    hb_font_funcs_t *functions = hb_font_funcs_create();
    shaper->hb = hb_font_create(shaper->face);
    shaper->buffer = hb_buffer_create();
    hb_font_funcs_set_nominal_glyph_func(functions, nominal_glyph, NULL, NULL);
    hb_font_funcs_set_glyph_h_advance_func(functions, glyph_advance, NULL, NULL);
    hb_font_set_funcs(shaper->hb, functions, shaper, NULL);
    hb_font_funcs_destroy(functions);
    set_place(shaper);
    hb_buffer_set_cluster_level(shaper->buffer, HB_BUFFER_CLUSTER_LEVEL_MONOTONE_CHARACTERS);
    shaper->has_classes = hb_ot_layout_has_glyph_classes(shaper->face);
    return hb_buffer_allocation_successful(shaper->buffer);
}

mt_status mt_shaper_open(mt_font *font, const mt_gsub *gsub, mt_arena *arena, mt_shaper *shaper) {
    int count = mt_font_glyph_count(font);
    *shaper = (mt_shaper){.font = font, .has_latin = has_latin(gsub)};
    shaper->advances = mt_arena_new(arena, (size_t)count + 1, sizeof *shaper->advances);
    if (!shaper->advances) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) shaper->advances[i] = UNKNOWN;
    shaper->tables = (mt_face_tables){.gsub = gsub->table, .glyph_count = count};
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

/* Substitutions of a damaged font lead to glyphs that it has not: there it shows glyph 0. */
static void drop_unknown(hb_glyph_info_t *glyphs, unsigned count, uint32_t glyph_count) {
    for (unsigned i = 0; i < count; i++)
        if (glyphs[i].codepoint >= glyph_count) glyphs[i].codepoint = 0;
}

mt_shaped_text mt_shaper_shape(mt_shaper *shaper, const uint32_t *codes, int count) {
    hb_buffer_t *buffer = shaper->buffer;
    mt_shaped_text shaped = {0};
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
    shaped.backward = HB_DIRECTION_IS_BACKWARD(hb_buffer_get_direction(buffer));
    if (shaped.backward) hb_buffer_reverse(buffer);
    hb_glyph_info_t *glyphs = hb_buffer_get_glyph_infos(buffer, &shaped.count);
    drop_unknown(glyphs, shaped.count, (uint32_t)shaper->tables.glyph_count);
    shaped.glyphs = glyphs;
    shaped.at = hb_buffer_get_glyph_positions(buffer, NULL);
    return shaped;
}

bool mt_shaper_is_mark(const mt_shaper *shaper, uint32_t glyph) {
    return hb_ot_layout_get_glyph_class(shaper->face, glyph) == HB_OT_LAYOUT_GLYPH_CLASS_MARK;
}

bool mt_shaper_same_class(mt_shaper *a, uint32_t in_a, mt_shaper *b, uint32_t in_b) {
    if (!a->has_classes || !b->has_classes) return true;
    bool mark_a = mt_shaper_is_mark(a, in_a), mark_b = mt_shaper_is_mark(b, in_b);
    if (mark_a == mark_b) return true;
    return (mark_a ? mt_shaper_advance(a, in_a) : mt_shaper_advance(b, in_b)) != 0;
}
