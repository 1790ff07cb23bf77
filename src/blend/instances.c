/* Instances: a sink that makes of each glyph what it is at every T, built from its parts where it can be, else drawn out of
 * the morph; else the nearer font's own. */
#include "blend/instances.h"

#include <math.h>

#include "blend/assemble.h"
#include "blend/contours.h"
#include "blend/metadata.h"
#include "gpos/kerning.h"
#include "morph/between/instance.h"
#include "morph/check/reach.h"
#include "sfnt/sfnt.h"

typedef struct mt_instances {
    const double *t;
    int count;
    mt_reach wanted;     /* the least T and the most, or 0 and 1 */
    mt_glyf **glyphs;    /* at each T, all glyphs */
    mt_extent **extents; /* as many */
    bool *failed;        /* of each glyph: it could not be blended */
} mt_instances;

static mt_status start(mt_making *making, void *user) {
    mt_instances *fonts = user;
    size_t count = (size_t)fonts->count, glyphs = (size_t)making->glyph_count;
    fonts->glyphs = mt_arena_new(&making->arena, count, sizeof *fonts->glyphs);
    fonts->extents = mt_arena_new(&making->arena, count, sizeof *fonts->extents);
    fonts->failed = mt_arena_new(&making->arena, glyphs, sizeof *fonts->failed);
    if (!fonts->glyphs || !fonts->extents || !fonts->failed) return MT_NO_MEMORY;
    for (size_t i = 0; i < count; i++) {
        fonts->glyphs[i] = mt_arena_new(&making->arena, glyphs, sizeof(mt_glyf));
        fonts->extents[i] = mt_arena_new(&making->arena, glyphs, sizeof(mt_extent));
        if (!fonts->glyphs[i] || !fonts->extents[i]) return MT_NO_MEMORY;
    }
    return MT_OK;
}

static mt_status take_room(const mt_glyph_task *task, double t, mt_glyf *glyf) {
    mt_glyph_room room = mt_room_between(&task->pair.room_a, &task->pair.room_b, t);
    return mt_glyf_take_room(room, task->making->units, glyf);
}

/* ---- composites ---------------------------------------------------------------------------------------- */

static bool is_assembled(const mt_instances *fonts, int glyph, int i) {
    return fonts->glyphs[i][glyph].reference_count > 0;
}

static bool has_failed_part(const mt_instances *fonts, const mt_composite *composite) {
    for (int k = 0; k < composite->count; k++)
        if (fonts->failed[composite->references[k].glyph]) return true;
    return false;
}

/* Builds the glyph from its parts at every T where it can; *wanted: it has to be drawn, for some T. */
static mt_status begin(mt_glyph_task *task, void *user, bool *wanted) {
    mt_instances *fonts = user;
    const mt_composite *composite = &task->making->composites[task->glyph];
    *wanted = composite->count == 0 || has_failed_part(fonts, composite);
    if (*wanted) return MT_OK;
    for (int i = 0; i < fonts->count; i++) {
        mt_assembly font = {task->making->row, fonts->t[i], task->making->units, fonts->glyphs[i],
                            fonts->extents[i]};
        mt_glyf made = {0};
        mt_extent *extent = &fonts->extents[i][task->glyph];
        mt_status status = take_room(task, fonts->t[i], &made);
        if (status == MT_OK)
            status = mt_composite_assemble(composite, &font, task->kept, task->scratch, &made, extent);
        if (status == MT_NO_MEMORY) return status;
        if (status == MT_OK && made.reference_count > 0) fonts->glyphs[i][task->glyph] = made;
        *wanted = *wanted || !is_assembled(fonts, task->glyph, i);
    }
    return MT_OK;
}

/* ---- drawings ------------------------------------------------------------------------------------------ */

static mt_status keep(const mt_glyph_task *task, mt_instances *fonts, int i, double t,
                      const mt_outline *outline) {
    mt_glyf made = {0}, *kept = &fonts->glyphs[i][task->glyph];
    mt_status status = mt_outline_glyf(outline, task->making->units, task->kept, &made);
    if (status == MT_OK) status = take_room(task, t, &made);
    if (status != MT_OK) return status;
    *kept = made;
    return mt_glyf_extent(kept, NULL, &fonts->extents[i][task->glyph]);
}

/* T within the reach. */
static double held(mt_reach reach, double t) {
    return fmin(fmax(t, reach.from), reach.to);
}

/* Half-way, the nearer one is B's. */
static const mt_shape *nearer_shape(const mt_glyph_task *task, double t) {
    return t < 0.5 || task->b == MT_NO_PARTNER ? &task->pair.a : &task->pair.b;
}

static mt_status draw_at(const mt_glyph_task *task, mt_instances *fonts, int i, double t) {
    const mt_params *params = &task->making->row->params;
    mt_outline outline;
    mt_status status =
        task->b == MT_NO_PARTNER
            ? mt_shape_outline(&task->pair.a, params, task->scratch, &outline)
            : mt_morph_outline(&task->pair.morph, mt_weights_at(t), params, task->scratch, &outline);
    return status == MT_OK ? keep(task, fonts, i, t, &outline) : status;
}

static mt_status draw(mt_glyph_task *task, mt_instances *fonts) {
    const mt_params *params = &task->making->row->params;
    mt_reach reach = fonts->wanted;
    mt_status status = task->b == MT_NO_PARTNER
                           ? MT_OK
                           : mt_pair_reach(&task->pair, fonts->wanted, params, task->scratch, &reach);
    for (int i = 0; i < fonts->count && status == MT_OK; i++) {
        double t = held(reach, fonts->t[i]);
        if (is_assembled(fonts, task->glyph, i)) continue;
        status = draw_at(task, fonts, i, t);
        if (status == MT_OK && t != fonts->t[i]) mt_task_report_held(task, t);
    }
    return status;
}

/* The nearer font's own outline instead of the blend; nothing, and no room, where that does not fit either. */
static mt_status fall_back(mt_glyph_task *task, mt_instances *fonts) {
    const mt_params *params = &task->making->row->params;
    const mt_reach ends = {0, 1};
    for (int i = 0; i < fonts->count; i++) {
        if (is_assembled(fonts, task->glyph, i)) continue;
        mt_outline outline = {0};
        mt_status status = mt_shape_outline(nearer_shape(task, fonts->t[i]), params, task->scratch, &outline);
        status = mt_arena_verdict(task->scratch, status);
        if (status == MT_OK) status = keep(task, fonts, i, held(ends, fonts->t[i]), &outline);
        if (status != MT_OK && status != MT_TOO_LARGE && status != MT_TOO_COSTLY) return status;
        if (status == MT_OK) continue;
        fonts->glyphs[i][task->glyph] = (mt_glyf){0};
        fonts->extents[i][task->glyph] = (mt_extent){0};
    }
    return MT_OK;
}

static mt_status take(mt_glyph_task *task, mt_status prepared, void *user) {
    mt_instances *fonts = user;
    mt_status status = prepared == MT_OK ? mt_arena_verdict(task->scratch, draw(task, fonts)) : prepared;
    if (status == MT_OK || status == MT_NO_MEMORY) return status;
    fonts->failed[task->glyph] = true;
    mt_task_report(task, status);
    mt_pair_allow(task->making->row, task->scratch);
    return fall_back(task, fonts);
}

/* ---- the fonts ----------------------------------------------------------------------------------------- */

/* As GPOS, and as groups and pairs. */
static mt_status add_positions(const mt_positions *positions, double t, mt_arena *arena, mt_font_data *data) {
    mt_bytes gpos;
    mt_kerning *kerning = mt_arena_new(arena, 1, sizeof *kerning);
    if (!kerning) return MT_NO_MEMORY;
    mt_status status = mt_positions_write(positions, t, arena, &gpos);
    if (status == MT_OK) status = mt_positions_kerning(positions, t, arena, kerning);
    if (status != MT_OK) return status;
    mt_add_extra(data, MT_TAG('G', 'P', 'O', 'S'), gpos);
    data->kerning = kerning;
    return MT_OK;
}

static mt_status add_math(const mt_math *math, double t, mt_arena *arena, mt_font_data *data) {
    const mt_places places = {2, 1, &t, NULL};
    mt_bytes table;
    mt_status status = mt_math_write(math, &places, arena, &table);
    if (status == MT_OK) mt_add_extra(data, MT_TAG('M', 'A', 'T', 'H'), table);
    return status;
}

static mt_status hand_over(mt_making *making, const mt_instances *fonts, mt_font_ready ready, void *user) {
    const mt_row *row = making->row;
    mt_status status = MT_OK;
    for (int i = 0; i < fonts->count && status == MT_OK; i++) {
        double t = fonts->t[i];
        mt_font_data data = mt_making_font(making, fonts->glyphs[i]);
        mt_add_extra(&data, MT_TAG('G', 'D', 'E', 'F'), making->layout.gdef);
        mt_metadata_fill(row->fonts[0], row->fonts[1], t, &data);
        status = mt_metadata_names(row->fonts[0], row->fonts[1], t, row->family, &making->arena, &data);
        if (i < row->style_count) mt_metadata_style(row->styles[i], &data);
        if (status == MT_OK) status = add_positions(making->positions, t, &making->arena, &data);
        if (status == MT_OK) status = add_math(making->math, t, &making->arena, &data);
        status = mt_row_verdict(row, status);
        if (status == MT_OK) status = ready(&data, i, user);
    }
    return status;
}

mt_status mt_blend_make(mt_blend *blend, const double *t, int count, mt_font_ready ready, void *user) {
    mt_instances fonts = {.t = t, .count = count, .wanted = {0, 1}};
    for (int i = 0; i < count; i++) {
        if (!(t[i] >= -MT_REACH_MOST && t[i] <= 1 + MT_REACH_MOST)) return MT_BAD_PARAMETER;
        fonts.wanted = (mt_reach){fmin(fonts.wanted.from, t[i]), fmax(fonts.wanted.to, t[i])};
    }
    mt_making making = {.sinks = {{start, begin, take, &fonts}}, .sink_count = 1};
    mt_status status = mt_making_begin_font(&making, &blend->row);
    if (status == MT_OK) status = mt_making_run(&making);
    if (status == MT_OK) status = hand_over(&making, &fonts, ready, user);
    mt_making_end(&making);
    return mt_row_verdict(&blend->row, status);
}
