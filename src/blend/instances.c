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
    mt_font_at *at;      /* where each is, and its glyphs */
    mt_glyf **glyphs;    /* at each T, all glyphs */
    mt_extent **extents; /* as many */
    bool *failed;        /* of each glyph: it could not be blended */
} mt_instances;

/* ---- places -------------------------------------------------------------------------------------------- */

static bool is_within(mt_at at) {
    const double least = -MT_REACH_MOST, most = 1 + MT_REACH_MOST;
    return at.x >= least && at.x <= most && at.y >= least && at.y <= most;
}

/* The places of the row's glyphs by themselves are the same in each font. */
static mt_status place_glyphs(mt_making *making, mt_font_at *at) {
    const mt_given_places *own = &making->row->places;
    if (own->count == 0) return MT_OK;
    mt_at *glyphs = mt_arena_new(&making->arena, (size_t)making->glyph_count, sizeof *glyphs);
    if (!glyphs) return MT_NO_MEMORY;
    for (int i = 0; i < making->glyph_count; i++)
        glyphs[i] = mt_given_place_of(own, making->origins[i].glyph, at->at);
    at->glyphs = glyphs;
    return MT_OK;
}

static mt_status place_fonts(mt_making *making, mt_instances *fonts) {
    const mt_row *row = making->row;
    fonts->at = mt_arena_new(&making->arena, (size_t)fonts->count, sizeof *fonts->at);
    mt_status status = fonts->at ? MT_OK : MT_NO_MEMORY;
    for (int i = 0; i < fonts->count && status == MT_OK; i++) {
        fonts->at[i].at = mt_row_place(row, fonts->t[i], i);
        status = place_glyphs(making, &fonts->at[i]);
    }
    return status;
}

/* Whether fonts may be at these T. */
static bool are_good(const mt_row *row, const double *t, int count) {
    const mt_given_places *own = &row->places;
    bool turned = row->params.rotation != MT_ROTATION_NONE;
    if (!mt_row_takes_heights(row, count)) return false;
    for (int i = 0; i < count; i++)
        if (!is_within(mt_row_place(row, t[i], i))) return false;
    for (int i = 0; i < own->count; i++) {
        mt_at at = own->list[i].at;
        if (!is_within(at) || (turned && at.x != at.y)) return false;
    }
    return true;
}

static mt_at place_of(const mt_instances *fonts, int i, int glyph) {
    return fonts->at[i].glyphs ? fonts->at[i].glyphs[glyph] : fonts->at[i].at;
}

/* ---- the beginning ------------------------------------------------------------------------------------- */

static mt_status start(mt_making *making, void *user) {
    mt_instances *fonts = user;
    mt_status status = place_fonts(making, fonts);
    if (status != MT_OK) return status;
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

static mt_status take_room(const mt_glyph_task *task, mt_at at, mt_glyf *glyf) {
    mt_glyph_room room = mt_room_between(&task->pair.room_a, &task->pair.room_b, at);
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

/* Whether all of the glyph's parts lie at its own place. */
static bool is_together(const mt_instances *fonts, int i, int glyph, const mt_composite *composite) {
    for (int k = 0; k < composite->count; k++)
        if (!mt_at_equal(place_of(fonts, i, glyph), place_of(fonts, i, composite->references[k].glyph)))
            return false;
    return true;
}

static mt_status assemble(mt_glyph_task *task, mt_instances *fonts, int i) {
    mt_at at = place_of(fonts, i, task->glyph);
    mt_assembly font = {task->making->row, at, task->making->units, fonts->glyphs[i], fonts->extents[i]};
    mt_glyf made = {0};
    mt_extent *extent = &fonts->extents[i][task->glyph];
    mt_status status = take_room(task, at, &made);
    if (status == MT_OK)
        status = mt_composite_assemble(&task->making->composites[task->glyph], &font, task->kept,
                                       task->scratch, &made, extent);
    if (status == MT_OK && made.reference_count > 0) fonts->glyphs[i][task->glyph] = made;
    return status;
}

/* Builds the glyph from its parts at every T where it can; *wanted: it has to be drawn, for some T. */
static mt_status begin(mt_glyph_task *task, void *user, bool *wanted) {
    mt_instances *fonts = user;
    const mt_composite *composite = &task->making->composites[task->glyph];
    *wanted = composite->count == 0 || has_failed_part(fonts, composite);
    if (*wanted) return MT_OK;
    for (int i = 0; i < fonts->count; i++) {
        bool together = is_together(fonts, i, task->glyph, composite);
        if (together && assemble(task, fonts, i) == MT_NO_MEMORY) return MT_NO_MEMORY;
        *wanted = *wanted || !is_assembled(fonts, task->glyph, i);
    }
    return MT_OK;
}

/* ---- drawings ------------------------------------------------------------------------------------------ */

static mt_status keep(const mt_glyph_task *task, mt_instances *fonts, int i, mt_at at,
                      const mt_outline *outline) {
    mt_glyf made = {0}, *kept = &fonts->glyphs[i][task->glyph];
    mt_status status = mt_outline_glyf(outline, task->making->units, task->kept, &made);
    if (status == MT_OK) status = take_room(task, at, &made);
    if (status != MT_OK) return status;
    *kept = made;
    return mt_glyf_extent(kept, NULL, &fonts->extents[i][task->glyph]);
}

/* Half-way, the nearer one is B's. */
static const mt_shape *nearer_shape(const mt_glyph_task *task, mt_at at) {
    return at.x + at.y < 1 || task->b == MT_NO_PARTNER ? &task->pair.a : &task->pair.b;
}

static mt_status draw_at(const mt_glyph_task *task, mt_instances *fonts, int i, mt_reach reach) {
    const mt_params *params = &task->making->row->params;
    mt_at asked = place_of(fonts, i, task->glyph), at;
    mt_outline outline;
    mt_status status = mt_pair_stand(&task->pair, reach, asked, params, task->scratch, &at);
    if (status == MT_OK)
        status = mt_morph_outline(&task->pair.morph, mt_weights_of(at), params, task->scratch, &outline);
    if (status == MT_OK) status = keep(task, fonts, i, at, &outline);
    if (status == MT_OK && !mt_at_equal(at, asked)) mt_task_report_held(task, at, asked);
    return status;
}

/* As the first font has it, at every place. */
static mt_status draw_alone(const mt_glyph_task *task, mt_instances *fonts, int i) {
    const mt_params *params = &task->making->row->params;
    mt_outline outline;
    mt_status status = mt_shape_outline(&task->pair.a, params, task->scratch, &outline);
    return status == MT_OK ? keep(task, fonts, i, place_of(fonts, i, task->glyph), &outline) : status;
}

/* How far the pair goes past its ends, as far as its places are. */
static mt_status find_reach(const mt_glyph_task *task, const mt_instances *fonts, mt_reach *reach) {
    mt_reach wanted = {0, 1};
    for (int i = 0; i < fonts->count; i++) {
        mt_at at = place_of(fonts, i, task->glyph);
        wanted = (mt_reach){fmin(wanted.from, (at.x + at.y) / 2), fmax(wanted.to, (at.x + at.y) / 2)};
    }
    return mt_pair_reach(&task->pair, wanted, &task->making->row->params, task->scratch, reach);
}

static mt_status draw(mt_glyph_task *task, mt_instances *fonts) {
    bool alone = task->b == MT_NO_PARTNER;
    mt_reach reach = {0, 1};
    mt_status status = alone ? MT_OK : find_reach(task, fonts, &reach);
    for (int i = 0; i < fonts->count && status == MT_OK; i++) {
        if (is_assembled(fonts, task->glyph, i)) continue;
        status = alone ? draw_alone(task, fonts, i) : draw_at(task, fonts, i, reach);
    }
    return status;
}

static double within(double t) {
    return fmin(fmax(t, 0), 1);
}

/* The nearer font's own outline instead of the blend; nothing, and no room, where that does not fit either. */
static mt_status fall_back(mt_glyph_task *task, mt_instances *fonts) {
    const mt_params *params = &task->making->row->params;
    for (int i = 0; i < fonts->count; i++) {
        if (is_assembled(fonts, task->glyph, i)) continue;
        mt_at at = place_of(fonts, i, task->glyph);
        mt_outline outline = {0};
        mt_status status = mt_shape_outline(nearer_shape(task, at), params, task->scratch, &outline);
        status = mt_arena_verdict(task->scratch, status);
        if (status == MT_OK) status = keep(task, fonts, i, (mt_at){within(at.x), within(at.y)}, &outline);
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
static mt_status add_positions(const mt_positions *positions, mt_font_at at, mt_arena *arena,
                               mt_font_data *data) {
    mt_bytes gpos;
    mt_kerning *kerning = mt_arena_new(arena, 1, sizeof *kerning);
    if (!kerning) return MT_NO_MEMORY;
    mt_status status = mt_positions_write(positions, at, arena, &gpos);
    if (status == MT_OK) status = mt_positions_kerning(positions, at, arena, kerning);
    if (status != MT_OK) return status;
    mt_add_extra(data, MT_TAG('G', 'P', 'O', 'S'), gpos);
    data->kerning = kerning;
    return MT_OK;
}

static mt_status add_math(const mt_math *math, mt_font_at at, mt_arena *arena, mt_font_data *data) {
    const mt_places places = mt_places_of_one(&at, 2);
    mt_bytes table;
    mt_status status = mt_math_write(math, &places, arena, &table);
    if (status == MT_OK) mt_add_extra(data, MT_TAG('M', 'A', 'T', 'H'), table);
    return status;
}

static mt_status hand_over(mt_making *making, const mt_instances *fonts, mt_font_ready ready, void *user) {
    const mt_row *row = making->row;
    mt_status status = MT_OK;
    for (int i = 0; i < fonts->count && status == MT_OK; i++) {
        mt_font_at at = fonts->at[i];
        mt_font_data data = mt_making_font(making, fonts->glyphs[i]);
        mt_add_extra(&data, MT_TAG('G', 'D', 'E', 'F'), making->layout.gdef);
        mt_metadata_fill(row->fonts[0], row->fonts[1], at.at, &data);
        status = mt_metadata_names(row->fonts[0], row->fonts[1], at.at, row->family, &making->arena, &data);
        if (i < row->style_count) mt_metadata_style(row->styles[i], &data);
        if (status == MT_OK) status = add_positions(making->positions, at, &making->arena, &data);
        if (status == MT_OK) status = add_math(making->math, at, &making->arena, &data);
        status = mt_row_verdict(row, status);
        if (status == MT_OK) status = ready(&data, i, user);
    }
    return status;
}

mt_status mt_blend_make(mt_blend *blend, const double *t, int count, mt_font_ready ready, void *user) {
    mt_instances fonts = {.t = t, .count = count};
    if (!are_good(&blend->row, t, count)) return MT_BAD_PARAMETER;
    mt_making making = {.sinks = {{start, begin, take, &fonts}}, .sink_count = 1};
    mt_status status = mt_making_begin_font(&making, &blend->row);
    if (status == MT_OK) status = mt_making_run(&making);
    if (status == MT_OK) status = hand_over(&making, &fonts, ready, user);
    mt_making_end(&making);
    return mt_row_verdict(&blend->row, status);
}
