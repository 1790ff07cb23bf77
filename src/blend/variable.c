/* A variable font: the tracks of each glyph joined, the axis named, all of it as data. */
#include "blend/variable.h"

#include "blend/assemble.h"
#include "blend/family.h"
#include "blend/join.h"
#include "blend/masters.h"
#include "blend/metadata.h"
#include "blend/varying_tables.h"
#include "geometry/limits.h"
#include "sfnt/axis_names.h"
#include "write/mirror.h"

typedef struct mt_variable_maker {
    mt_variable *variable;
    mt_making making;
    mt_outlines outlines;
    mt_glyf *glyphs;
    mt_glyph_path *paths;
    double *values; /* what users set for each font */
} mt_variable_maker;

/* ---- the glyphs ---------------------------------------------------------------------------------------- */

/* A glyph whose points or moves are more than a font has room for is blank, and reported. */
static mt_status join_glyphs(mt_variable_maker *maker) {
    mt_making *making = &maker->making;
    size_t count = (size_t)making->glyph_count;
    maker->glyphs = mt_arena_new(&making->arena, count, sizeof *maker->glyphs);
    maker->paths = mt_arena_new(&making->arena, count, sizeof *maker->paths);
    if (!maker->glyphs || !maker->paths) return MT_NO_MEMORY;
    for (int i = 0; i < making->glyph_count; i++) {
        mt_status status = mt_tracks_join(making, &maker->outlines, i, &maker->glyphs[i], &maker->paths[i]);
        if (status == MT_TOO_LARGE)
            mt_making_report(making, i, -1, status);
        else if (status != MT_OK)
            return status;
    }
    return MT_OK;
}

/* ---- overlaps ------------------------------------------------------------------------------------------ */

/* The box around the contours at all places. */
static mt_bounds sweep_contours(const mt_glyf *glyph, const mt_glyph_path *path) {
    mt_bounds sweep = mt_no_bounds;
    for (int i = 0; i < mt_glyf_point_count(glyph); i++) {
        int x = glyph->points[i].x, y = glyph->points[i].y;
        sweep = mt_bounds_join(sweep, (mt_bounds){x, y, x, y});
        for (int k = 0; k < path->place_count; k++) {
            mt_font_point p = path->at[k][i];
            sweep = mt_bounds_join(sweep, (mt_bounds){p.x, p.y, p.x, p.y});
        }
    }
    return sweep;
}

/* The box around a part at all places, from the one around the glyph that it is. */
static mt_bounds sweep_part(const mt_glyf *glyph, const mt_glyph_path *path, int i, mt_bounds part) {
    mt_bounds sweep = mt_bounds_move(part, glyph->references[i].dx, glyph->references[i].dy);
    for (int k = 0; k < path->place_count; k++)
        sweep = mt_bounds_join(sweep, mt_bounds_move(part, path->at[k][i].x, path->at[k][i].y));
    return sweep;
}

/* A composite whose parts all are blank is blank itself. The room in the line stays; its phantom points come first now. */
static mt_status make_blank(mt_glyf *glyph, mt_glyph_path *path, mt_arena *arena) {
    mt_font_point **at = mt_arena_new(arena, (size_t)path->place_count, sizeof *at);
    if (!at) return MT_NO_MEMORY;
    for (int i = 0; i < path->place_count; i++) at[i] = path->at[i] + glyph->reference_count;
    path->at = at;
    glyph->reference_count = 0;
    return MT_OK;
}

/* `sweeps` has the boxes around the glyphs of lower depth. */
static mt_status look_at_parts(mt_variable_maker *maker, int index, mt_bounds *sweeps) {
    mt_arena *arena = &maker->making.arena;
    mt_glyf *glyph = &maker->glyphs[index];
    mt_glyph_path *path = &maker->paths[index];
    mt_bounds *parts = mt_arena_new(arena, (size_t)glyph->reference_count, sizeof *parts);
    if (!parts) return MT_NO_MEMORY;
    for (int i = 0; i < glyph->reference_count; i++) {
        int part = glyph->references[i].glyph;
        parts[i] = sweep_part(glyph, path, i, sweeps[part]);
        glyph->overlaps = glyph->overlaps || maker->glyphs[part].overlaps;
        sweeps[index] = mt_bounds_join(sweeps[index], parts[i]);
    }
    glyph->overlaps = glyph->overlaps || mt_boxes_meet(parts, glyph->reference_count);
    return mt_bounds_empty(sweeps[index]) ? make_blank(glyph, path, arena) : MT_OK;
}

/* Tells which composites have parts that may overlap on the way. */
static mt_status find_overlaps(mt_variable_maker *maker) {
    mt_making *making = &maker->making;
    mt_bounds *sweeps = mt_arena_new(&making->arena, (size_t)making->glyph_count, sizeof *sweeps);
    mt_status status = sweeps ? MT_OK : MT_NO_MEMORY;
    for (int turn = 0; turn < making->glyph_count && status == MT_OK; turn++) {
        int i = making->order[turn];
        sweeps[i] = sweep_contours(&maker->glyphs[i], &maker->paths[i]);
        if (maker->glyphs[i].reference_count > 0) status = look_at_parts(maker, i, sweeps);
    }
    return status;
}

/* ---- the axis ------------------------------------------------------------------------------------------ */

static mt_status find_values(mt_variable_maker *maker) {
    int fonts = maker->variable->row.font_count;
    maker->values = mt_arena_new(&maker->making.arena, (size_t)fonts, sizeof *maker->values);
    if (!maker->values) return MT_NO_MEMORY;
    const mt_variable *variable = maker->variable;
    for (int i = 0; i < fonts; i++)
        maker->values[i] = variable->values
                               ? variable->values[i]
                               : mt_axis_user(&variable->axis,
                                              mt_axis_map_value(&variable->map, maker->outlines.stops.at[i]));
    return MT_OK;
}

/* ---- the font ------------------------------------------------------------------------------------------ */

/* The style of the font as it stands. NULL for want of memory. */
static const char *home_style(mt_variable_maker *maker, const mt_axis_data *variation) {
    const mt_axis *axis = &variation->axis;
    for (int i = 0; i < variation->named_count && maker->variable->values; i++)
        if (variation->named[i].value == axis->home) return variation->named[i].name;
    return mt_axis_place_name(axis, axis->from, &maker->making.arena);
}

/* The names; those of the axis must be known. */
static mt_status name_font(mt_variable_maker *maker, mt_font_data *data) {
    const mt_row *row = &maker->variable->row;
    const mt_axis *axis = &maker->variable->axis;
    mt_arena *arena = &maker->making.arena;
    mt_status status =
        mt_metadata_axis_names(row->fonts, maker->values, row->font_count, row->family, arena, data);
    const char *style = row->style_count ? row->styles[0] : home_style(maker, data->variation);
    if (status == MT_OK && !style) status = MT_NO_MEMORY;
    if (status == MT_OK) mt_metadata_style(style, data);
    if (status == MT_OK && maker->variable->values)
        mt_metadata_axis(axis, axis->home, data->units, &data->metrics);
    return status;
}

static mt_status mirror_tables(mt_variable_maker *maker, mt_font_data *data) {
    mt_status status = MT_OK;
    for (int i = 0; i < data->extra_count && status == MT_OK; i++)
        status = mt_mirror_table(data->extras[i].tag, &maker->making.arena, &data->extras[i].data);
    return status;
}

/* The font as it stands: at one of the row. */
static void fill_home(const mt_variable_maker *maker, mt_font_data *data) {
    const mt_row *row = &maker->variable->row;
    int home = maker->outlines.stops.home, first = home + 1 < row->font_count ? home : home - 1;
    mt_metadata_fill(row->fonts[first], row->fonts[first + 1], mt_at_both(home - first), data);
}

static mt_status hand_over(mt_variable_maker *maker, bool masters, mt_font_ready ready, void *user) {
    const mt_variable *variable = maker->variable;
    const mt_row *row = &variable->row;
    mt_axis_data variation = {.axis = variable->axis,
                              .paths = maker->paths,
                              .map = variable->map,
                              .slope = mt_variable_slope(variable)};
    mt_font_data data = mt_making_font(&maker->making, maker->glyphs);
    data.variation = &variation;
    mt_status status = find_values(maker);
    if (status == MT_OK)
        status = mt_variable_name_places(variable, maker->values, row->font_count, &maker->making.arena,
                                         &variation);
    fill_home(maker, &data);
    if (status == MT_OK) status = mt_varying_tables_add(&maker->making, &maker->outlines, variable, &data);
    if (status == MT_OK) status = name_font(maker, &data);
    if (status == MT_OK && mt_axis_goes_down(&variable->axis)) status = mirror_tables(maker, &data);
    status = mt_row_verdict(row, status);
    if (status != MT_OK) return status;
    return masters ? mt_masters_make(&maker->making, &maker->outlines, &data, ready, user)
                   : ready(&data, 0, user);
}

static mt_status make(mt_variable *variable, const mt_sink *also, bool masters, mt_font_ready ready,
                      void *user) {
    mt_variable_maker maker = {
        .variable = variable, .making = {.varies = true}, .outlines = {.stops = mt_variable_stops(variable)}};
    mt_making *making = &maker.making;
    making->sinks[making->sink_count++] = mt_outlines_sink(&maker.outlines);
    if (also) making->sinks[making->sink_count++] = *also;
    mt_status status = mt_making_begin_font(making, &variable->row);
    if (status == MT_OK) status = mt_making_run(making);
    if (status == MT_OK) status = mt_row_verdict(&variable->row, join_glyphs(&maker));
    if (status == MT_OK) status = mt_row_verdict(&variable->row, find_overlaps(&maker));
    if (status == MT_OK) status = hand_over(&maker, masters, ready, user);
    mt_making_end(making);
    return mt_row_verdict(&variable->row, status);
}

mt_status mt_variable_make(mt_variable *variable, const mt_sink *also, mt_font_ready ready, void *user) {
    return make(variable, also, false, ready, user);
}

mt_status mt_variable_masters(mt_variable *variable, const mt_sink *also, mt_font_ready ready, void *user) {
    return make(variable, also, true, ready, user);
}
