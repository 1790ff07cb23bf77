/* What a variable font has beside outlines: substitutions, positions, room in the line and figures of the whole font. Each table
 * has what holds at the first font, and what every other font adds to it. */
#include "blend/variable_job.h"

#include "blend/metadata.h"
#include "sfnt/sfnt.h"
#include "write/varying.h"

/* GSUB is the first font's; GPOS and GDEF vary. */
static mt_status add_positions(const mt_course *course, mt_arena *arena, mt_font_data *data) {
    const mt_layout_tables *layout = &course->jobs[0].layout;
    mt_bytes gpos, gdef;
    mt_status status = mt_positions_write_varying(course->positions, layout->gdef, arena, &gpos, &gdef);
    if (status != MT_OK) return status;
    mt_add_extra(data, MT_TAG('G', 'S', 'U', 'B'), layout->gsub);
    mt_add_extra(data, MT_TAG('G', 'P', 'O', 'S'), gpos);
    mt_add_extra(data, MT_TAG('G', 'D', 'E', 'F'), gdef);
    return MT_OK;
}

/* The glyphs at each stop, without outlines. */
static mt_status list_rooms(const mt_course *course, const mt_font_data *data, mt_arena *arena,
                            mt_glyf ***rooms) {
    size_t stops = (size_t)course->step_count + 1, glyphs = (size_t)course->glyph_count;
    *rooms = mt_arena_new(arena, stops, sizeof **rooms);
    if (!*rooms) return MT_NO_MEMORY;
    for (size_t i = 0; i < stops; i++) {
        (*rooms)[i] = mt_arena_new(arena, glyphs, sizeof(mt_glyf));
        if (!(*rooms)[i]) return MT_NO_MEMORY;
        for (size_t k = 0; k < glyphs; k++)
            mt_glyph_room_at(&data->glyphs[k], &data->variation->moves[k], course->stops[i], &(*rooms)[i][k]);
    }
    return MT_OK;
}

static mt_status add_rooms(const mt_course *course, mt_arena *arena, mt_font_data *data) {
    mt_glyf **rooms;
    mt_bytes hvar, vvar = {0};
    int stops = course->step_count + 1;
    mt_status status = list_rooms(course, data, arena, &rooms);
    if (status == MT_OK) status = mt_hvar_write(rooms, stops, course->glyph_count, arena, &hvar);
    if (status == MT_OK && data->metrics.vertical)
        status = mt_vvar_write(rooms, stops, course->glyph_count, arena, &vvar);
    if (status != MT_OK) return status;
    mt_add_extra(data, MT_TAG('H', 'V', 'A', 'R'), hvar);
    mt_add_extra(data, MT_TAG('V', 'V', 'A', 'R'), vvar);
    return MT_OK;
}

/* The font's own are those of the first stop, with the lines that can vary. */
static mt_status add_figures(const mt_course *course, mt_arena *arena, mt_font_data *data) {
    int stops = course->step_count + 1;
    mt_metrics *metrics = mt_arena_new(arena, (size_t)stops, sizeof *metrics);
    if (!metrics) return MT_NO_MEMORY;
    bool vertical = false;
    for (int i = 0; i < stops; i++) {
        const mt_blend *blend = course->jobs[i ? i - 1 : 0].blend;
        mt_font_data stop = {.units = course->units};
        mt_status status = mt_metadata_fill(blend->a, blend->b, i ? 1 : 0, data->family, arena, &stop);
        if (status != MT_OK) return status;
        metrics[i] = stop.metrics;
        vertical = vertical || stop.metrics.vertical;
    }
    for (int i = 0; i < stops; i++) metrics[i].vertical = vertical;
    mt_varying_lines(metrics, stops);
    mt_bytes mvar;
    mt_status status = mt_mvar_write(metrics, stops, arena, &mvar);
    if (status != MT_OK) return status;
    data->metrics = metrics[0];
    mt_add_extra(data, MT_TAG('M', 'V', 'A', 'R'), mvar);
    return MT_OK;
}

mt_status mt_course_layout(const mt_course *course, mt_arena *arena, mt_font_data *data) {
    mt_status status = add_positions(course, arena, data);
    if (status == MT_OK) status = add_figures(course, arena, data);
    return status == MT_OK ? add_rooms(course, arena, data) : status;
}
