#include "motion/shaped_line.h"

#include <math.h>

#include "geometry/limits.h"
#include "sfnt/layout_face.h"
#include "sfnt/sfnt.h"

/* ---- the font as HarfBuzz takes it ----------------------------------------------------------------------- */

static hb_bool_t nominal_glyph(hb_font_t *hb, void *data, hb_codepoint_t code, hb_codepoint_t *glyph,
                               void *user) {
    (void)hb, (void)user;
    *glyph = mt_font_glyph(data, code);
    return *glyph != 0;
}

static hb_position_t glyph_advance(hb_font_t *hb, void *data, hb_codepoint_t glyph, void *user) {
    double advance = 0;
    (void)hb, (void)user;
    return mt_font_advance(data, glyph, &advance) == MT_OK ? (hb_position_t)lround(advance) : 0;
}

static mt_status read_tables(mt_font *font, mt_arena *arena, mt_face_tables *tables) {
    *tables = (mt_face_tables){.glyph_count = mt_font_glyph_count(font)};
    mt_status status = mt_font_table(font, MT_TAG('G', 'S', 'U', 'B'), arena, &tables->gsub);
    if (status == MT_OK) status = mt_font_table(font, MT_TAG('G', 'D', 'E', 'F'), arena, &tables->gdef);
    if (status == MT_OK) status = mt_font_table(font, MT_TAG('G', 'P', 'O', 'S'), arena, &tables->gpos);
    return status == MT_OK ? mt_font_kern(font, arena, &tables->kern) : status;
}

/* HarfBuzz takes places as 2.14. */
static void set_place(const mt_font *font, hb_font_t *hb) {
    const int32_t *normalized;
    int coordinates[64], count = mt_font_place(font, &normalized);
    if (count > 64) count = 64;
    for (int i = 0; i < count; i++) coordinates[i] = (normalized[i] + 2) >> 2;
    if (count > 0) hb_font_set_var_coords_normalized(hb, coordinates, (unsigned)count);
}

/* A font whose positions are grid units; NULL without memory. */
static hb_font_t *open_font(mt_font *font, mt_face_tables *tables) {
    hb_face_t *face = mt_face_make(tables);
    if (!face) return NULL;
    hb_face_set_upem(face, (unsigned)mt_font_units_per_em(font));
    hb_font_funcs_t *functions = hb_font_funcs_create();
    hb_font_t *hb = hb_font_create(face);
    hb_font_funcs_set_nominal_glyph_func(functions, nominal_glyph, NULL, NULL);
    hb_font_funcs_set_glyph_h_advance_func(functions, glyph_advance, NULL, NULL);
    hb_font_set_funcs(hb, functions, font, NULL);
    hb_font_set_scale(hb, MT_EM, MT_EM);
    set_place(font, hb);
    hb_font_funcs_destroy(functions);
    hb_face_destroy(face);
    return hb;
}

/* ---- the line -------------------------------------------------------------------------------------------- */

/* How many characters the cluster has that starts at `first`: up to the next cluster's first. */
static int cluster_length(const hb_glyph_info_t *infos, unsigned count, uint32_t first, int characters) {
    uint32_t next = (uint32_t)characters;
    for (unsigned i = 0; i < count; i++)
        if (infos[i].cluster > first && infos[i].cluster < next) next = infos[i].cluster;
    return (int)(next - first);
}

static mt_status read_line(hb_buffer_t *buffer, int characters, mt_arena *arena, mt_shaped_line *line) {
    unsigned count;
    const hb_glyph_info_t *infos = hb_buffer_get_glyph_infos(buffer, &count);
    const hb_glyph_position_t *positions = hb_buffer_get_glyph_positions(buffer, NULL);
    if (count > MT_LINE_MAX) return MT_TOO_LARGE;
    mt_shaped_line made = {(int)count, mt_arena_new(arena, (size_t)count + 1, sizeof *made.glyphs), 0};
    if (!made.glyphs) return MT_NO_MEMORY;
    double x = 0, y = 0;
    for (unsigned i = 0; i < count; i++) {
        int first = (int)infos[i].cluster;
        made.glyphs[i] = (mt_line_glyph){infos[i].codepoint, first,
                                         cluster_length(infos, count, infos[i].cluster, characters),
                                         x + positions[i].x_offset, y + positions[i].y_offset};
        x += positions[i].x_advance;
        y += positions[i].y_advance;
    }
    made.advance = x;
    *line = made;
    return MT_OK;
}

mt_status mt_shape_line(mt_font *font, const uint32_t *codes, int count, mt_arena *arena,
                        mt_shaped_line *line) {
    mt_face_tables tables;
    mt_status status = read_tables(font, arena, &tables);
    hb_font_t *hb = status == MT_OK ? open_font(font, &tables) : NULL;
    if (!hb) return status == MT_OK ? MT_NO_MEMORY : status;
    hb_buffer_t *buffer = hb_buffer_create();
    hb_buffer_set_flags(buffer, HB_BUFFER_FLAG_REMOVE_DEFAULT_IGNORABLES);
    hb_buffer_add_codepoints(buffer, codes, count, 0, count);
    bool filled = hb_buffer_allocation_successful(buffer);
    hb_buffer_guess_segment_properties(buffer);
    if (HB_DIRECTION_IS_VERTICAL(hb_buffer_get_direction(buffer)))
        hb_buffer_set_direction(buffer, HB_DIRECTION_LTR); /* Mongolian and the like: on a line of the page */
    hb_buffer_set_language(buffer, HB_LANGUAGE_INVALID);
    hb_shape(hb, buffer, NULL, 0);
    if (!filled)
        status = MT_NO_MEMORY;
    else if (!hb_buffer_allocation_successful(buffer))
        status = MT_ENDLESS_LOOKUPS;
    else
        status = read_line(buffer, count, arena, line);
    hb_buffer_destroy(buffer);
    hb_font_destroy(hb);
    return status;
}
