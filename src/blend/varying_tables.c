/* GPOS, MATH and GDEF, HVAR and VVAR, MVAR: values at each font of the row, of which the tables' writers make deltas. */
#include "blend/varying_tables.h"

#include "blend/family.h"
#include "blend/masters.h"
#include "blend/metadata.h"
#include "layout/gdef.h"
#include "sfnt/sfnt.h"
#include "write/varying.h"

/* GSUB is the first font's, and there already; GPOS and MATH vary by the store that GDEF has. */
static mt_status add_layout(mt_making *making, const mt_stops *stops, mt_font_data *font) {
    mt_at at[MT_STOPS_MAX];
    mt_var_store store = mt_var_store_make(stops);
    mt_places places = mt_places_of_fonts(at, &store);
    mt_bytes gpos, math, gdef;
    mt_status status = mt_positions_write_varying(making->positions, &store, &making->arena, &gpos);
    if (status == MT_OK) status = mt_math_write(making->math, &places, &making->arena, &math);
    if (status == MT_OK) status = mt_gdef_vary(making->layout.gdef, &store, &making->arena, &gdef);
    mt_var_store_free(&store);
    if (status != MT_OK) return status;
    mt_add_extra(font, MT_TAG('G', 'P', 'O', 'S'), gpos);
    mt_add_extra(font, MT_TAG('G', 'D', 'E', 'F'), gdef);
    mt_add_extra(font, MT_TAG('M', 'A', 'T', 'H'), math);
    return MT_OK;
}

/* The glyphs at each stop, without outlines. */
static mt_status list_rooms(mt_making *making, const mt_outlines *outlines, const mt_font_data *font,
                            mt_glyf ***rooms) {
    const mt_stops *stops = &outlines->stops;
    size_t fonts = (size_t)stops->count, glyphs = (size_t)making->glyph_count;
    *rooms = mt_arena_new(&making->arena, fonts, sizeof **rooms);
    if (!*rooms) return MT_NO_MEMORY;
    for (size_t i = 0; i < fonts; i++) {
        (*rooms)[i] = mt_arena_new(&making->arena, glyphs, sizeof(mt_glyf));
        if (!(*rooms)[i]) return MT_NO_MEMORY;
        int place = stops->at[mt_stops_font(stops, (int)i)];
        for (size_t k = 0; k < glyphs; k++)
            mt_glyph_room_at(&font->glyphs[k], &font->variation->paths[k], place, &(*rooms)[i][k]);
    }
    return MT_OK;
}

static mt_status add_rooms(mt_making *making, const mt_outlines *outlines, mt_font_data *font) {
    mt_glyf **rooms;
    mt_bytes hvar, vvar = {0};
    const mt_stops *stops = &outlines->stops;
    mt_status status = list_rooms(making, outlines, font, &rooms);
    if (status == MT_OK) status = mt_hvar_write(rooms, stops, making->glyph_count, &making->arena, &hvar);
    if (status == MT_OK && font->metrics.vertical)
        status = mt_vvar_write(rooms, stops, making->glyph_count, &making->arena, &vvar);
    if (status != MT_OK) return status;
    mt_add_extra(font, MT_TAG('H', 'V', 'A', 'R'), hvar);
    mt_add_extra(font, MT_TAG('V', 'V', 'A', 'R'), vvar);
    return MT_OK;
}

/* The font's own are those of the first stop, with the lines that can vary. */
static mt_status add_figures(mt_making *making, const mt_stops *stops, const mt_variable *variable,
                             mt_font_data *font) {
    int count = stops->count;
    const mt_axis *axis = &font->variation->axis;
    mt_metrics *metrics = mt_arena_new(&making->arena, (size_t)count, sizeof *metrics);
    if (!metrics) return MT_NO_MEMORY;
    bool vertical = false;
    for (int i = 0; i < count; i++) {
        int at_font = mt_stops_font(stops, i), first = at_font ? at_font - 1 : 0;
        mt_font *const *fonts = making->row->fonts + first;
        mt_font_data at = {.units = making->units};
        mt_metadata_fill(fonts[0], fonts[1], mt_at_both(at_font - first), &at);
        metrics[i] = at.metrics;
        mt_metadata_axis(axis, mt_variable_value(variable, at_font), at.units, &metrics[i]);
        vertical = vertical || at.metrics.vertical;
    }
    for (int i = 0; i < count; i++) metrics[i].vertical = vertical;
    mt_varying_lines(metrics, count);
    mt_varying_caret(metrics, count);
    mt_bytes mvar;
    mt_status status = mt_mvar_write(metrics, stops, &making->arena, &mvar);
    if (status != MT_OK) return status;
    font->metrics = metrics[0];
    mt_add_extra(font, MT_TAG('M', 'V', 'A', 'R'), mvar);
    return MT_OK;
}

mt_status mt_varying_tables_add(mt_making *making, const mt_outlines *outlines, const mt_variable *variable,
                                mt_font_data *font) {
    mt_status status = add_layout(making, &outlines->stops, font);
    if (status == MT_OK) status = add_figures(making, &outlines->stops, variable, font);
    return status == MT_OK ? add_rooms(making, outlines, font) : status;
}
