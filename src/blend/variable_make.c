/* A variable font: the glyphs that it has, each on every step of the axis, and all of it as data. */
#include "blend/variable_job.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "blend/metadata.h"
#include "geometry/limits.h"
#include "sfnt/axis.h"

typedef struct mt_making {
    mt_variable *variable;
    mt_course course;
    mt_arena arena;
    mt_glyf *glyphs;
    mt_glyph_moves *moves;
    int step;       /* at hand */
    double *values; /* what users set for each font */
} mt_making;

/* ---- the steps ----------------------------------------------------------------------------------------- */

static int place_of_stop(const mt_course *course, int stop) {
    return (int)(((int64_t)MT_PLACE_ONE * stop + course->step_count / 2) / course->step_count);
}

/* An mt_progress of the step at hand: each is the same part of the whole. */
static void pass_progress(int done, int all, void *user) {
    const mt_making *making = user;
    const mt_variable *variable = making->variable;
    variable->progress(making->step * all + done, making->course.step_count * all, variable->progress_user);
}

static mt_status run_step(mt_making *making, mt_job *job) {
    int count = mt_job_worker_count(job);
    mt_worker *workers = mt_arena_new(&making->arena, (size_t)count, sizeof *workers);
    if (!workers) return MT_NO_MEMORY;
    job->workers = workers;
    job->worker_count = count;
    return mt_job_run(job, workers, count);
}

static mt_status start_step(mt_making *making, int step) {
    const mt_course *course = &making->course;
    mt_blend *blend = making->variable->steps[step];
    mt_job *job = &making->course.jobs[step];
    mt_blend_on_progress(blend, making->variable->progress ? pass_progress : NULL, making);
    *job = (mt_job){.blend = blend,
                    .make = mt_job_moving_glyph,
                    .charset = &course->charsets.steps[step],
                    .units = course->units,
                    .from = course->stops[step] + (step > 0),
                    .to = course->stops[step + 1]};
    job->passages = mt_arena_new(&making->arena, (size_t)course->glyph_count, sizeof *job->passages);
    return job->passages ? mt_job_start(job, &making->arena) : MT_NO_MEMORY;
}

static mt_status run_steps(mt_making *making) {
    mt_course *course = &making->course;
    mt_status status = MT_OK;
    for (int i = 0; i < course->step_count && status == MT_OK; i++) status = start_step(making, i);
    if (status == MT_OK) status = mt_course_composites(course, &making->arena);
    for (int i = 0; i < course->step_count && status == MT_OK; i++) {
        making->step = i;
        status = run_step(making, &course->jobs[i]);
    }
    return status;
}

static void release_steps(mt_making *making) {
    for (int i = 0; i < making->course.step_count; i++) {
        mt_job *job = &making->course.jobs[i];
        for (int k = 0; k < job->worker_count; k++) mt_arena_release(&job->workers[k].kept);
    }
}

/* ---- the glyphs ---------------------------------------------------------------------------------------- */

/* A glyph whose points or moves are more than a font has room for is blank, and reported. */
static mt_status join_glyph(mt_making *making, int glyph) {
    mt_status status =
        mt_course_join(&making->course, glyph, &making->arena, &making->glyphs[glyph], &making->moves[glyph]);
    if (status != MT_TOO_LARGE) return status;
    mt_job *job = &making->course.jobs[0];
    if (job->blend->failed && glyph != 0)
        job->blend->failed(job->charset->glyphs[glyph].code_point, status, job->blend->failed_user);
    return MT_OK;
}

static mt_status join_glyphs(mt_making *making) {
    size_t count = (size_t)making->course.glyph_count;
    making->glyphs = mt_arena_new(&making->arena, count, sizeof *making->glyphs);
    making->moves = mt_arena_new(&making->arena, count, sizeof *making->moves);
    if (!making->glyphs || !making->moves) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (int i = 0; i < making->course.glyph_count && status == MT_OK; i++) status = join_glyph(making, i);
    if (status != MT_OK) return status;
    return mt_course_overlaps(&making->course, making->glyphs, making->moves, &making->arena);
}

/* ---- the axis ------------------------------------------------------------------------------------------ */

static mt_status find_values(mt_making *making) {
    const mt_variable *variable = making->variable;
    making->values = mt_arena_new(&making->arena, (size_t)variable->count, sizeof *making->values);
    if (!making->values) return MT_NO_MEMORY;
    for (int i = 0; i < variable->count; i++)
        making->values[i] = mt_axis_map_value(&variable->map, making->course.stops[i]);
    return MT_OK;
}

/* Adds a place, unless one has its name. */
static mt_status name_place(double value, mt_arena *arena, mt_named_place *named, int *count) {
    enum { NAME_ROOM = 32 };
    char *name = mt_arena_new(arena, NAME_ROOM, 1);
    if (!name) return MT_NO_MEMORY;
    snprintf(name, NAME_ROOM, MT_AXIS_NAME " %.4g", value);
    for (int i = 0; i < *count; i++)
        if (strcmp(named[i].name, name) == 0) return MT_OK;
    named[(*count)++] = (mt_named_place){value, name};
    return MT_OK;
}

static int compare_places(const void *a, const void *b) {
    double x = ((const mt_named_place *)a)->value, y = ((const mt_named_place *)b)->value;
    return (x > y) - (x < y);
}

/* The quarters of the axis, and its stops. */
static mt_status name_places(mt_making *making, mt_axis_data *variation) {
    enum { QUARTERS = 4 };
    int fonts = making->variable->count, count = 0;
    mt_status status = MT_OK;
    mt_named_place *named = mt_arena_new(&making->arena, QUARTERS + 1 + (size_t)fonts, sizeof *named);
    if (!named) return MT_NO_MEMORY;
    for (int i = 0; i <= QUARTERS && status == MT_OK; i++)
        status = name_place((double)MT_AXIS_END * i / QUARTERS, &making->arena, named, &count);
    for (int i = 0; i < fonts && status == MT_OK; i++)
        status = name_place(making->values[i], &making->arena, named, &count);
    if (status != MT_OK) return status;
    qsort(named, (size_t)count, sizeof *named, compare_places);
    variation->named = named;
    variation->named_count = count;
    return MT_OK;
}

/* ---- the font ------------------------------------------------------------------------------------------ */

/* What the font says of itself, as it stands: at the first font. */
static mt_status describe(mt_making *making, mt_font_data *data) {
    const mt_variable *variable = making->variable;
    const char *family = variable->steps[0]->family;
    mt_status status =
        mt_metadata_fill(variable->fonts[0], variable->fonts[1], 0, family, &making->arena, data);
    if (status == MT_OK)
        status = mt_metadata_axis_names(variable->fonts, making->values, variable->count, family,
                                        &making->arena, data);
    data->style = data->variation->named[0].name;
    return status;
}

static mt_status add_layout(mt_making *making, mt_font_data *data) {
    mt_course *course = &making->course;
    mt_job *job = &course->jobs[0];
    const mt_variable *variable = making->variable;
    mt_status status = mt_job_layout(job, &making->arena);
    if (status == MT_OK)
        status = mt_positions_prepare(variable->fonts, course->charsets.spokes, variable->count,
                                      course->units, &making->arena, &course->positions);
    data->glyph_names = job->glyph_names;
    return status == MT_OK ? mt_course_layout(course, &making->arena, data) : status;
}

static mt_status hand_over(mt_making *making, bool masters, mt_font_ready ready, void *user) {
    const mt_charset *charset = &making->course.charsets.spokes[0];
    mt_axis_data variation = {.tag = MT_AXIS_TAG,
                              .name = MT_AXIS_NAME,
                              .least = 0,
                              .most = MT_AXIS_END,
                              .moves = making->moves,
                              .map = making->variable->map};
    mt_font_data data = {.units = making->course.units,
                         .glyph_count = charset->glyph_count,
                         .glyphs = making->glyphs,
                         .char_count = charset->char_count,
                         .chars = charset->chars,
                         .variant_count = charset->variant_count,
                         .variants = charset->variants,
                         .variation = &variation};
    mt_status status = find_values(making);
    if (status == MT_OK) status = name_places(making, &variation);
    if (status == MT_OK) status = describe(making, &data);
    if (status == MT_OK) status = add_layout(making, &data);
    if (status != MT_OK) return status;
    return masters ? mt_course_masters(&making->course, &data, ready, user) : ready(&data, 0, user);
}

static int units_of(const mt_variable *variable) {
    int units = 0;
    for (int i = 0; i + 1 < variable->count; i++) {
        int needed = mt_metadata_units(variable->fonts[i], variable->fonts[i + 1]);
        if (needed > units) units = needed;
    }
    return units;
}

static mt_status start(mt_making *making) {
    const mt_variable *variable = making->variable;
    mt_course *course = &making->course;
    const mt_blend *first = variable->steps[0];
    mt_charset_request request = {first->wanted, first->wanted_count, first->set};
    mt_status status =
        mt_charset_row_make(variable->fonts, variable->count, &request, &making->arena, &course->charsets);
    if (status != MT_OK) return status;
    course->glyph_count = course->charsets.steps[0].glyph_count;
    course->units = units_of(variable);
    course->jobs = mt_arena_new(&making->arena, (size_t)variable->count, sizeof *course->jobs);
    course->stops = mt_arena_new(&making->arena, (size_t)variable->count, sizeof *course->stops);
    if (!course->jobs || !course->stops) return MT_NO_MEMORY;
    course->step_count = variable->count - 1;
    for (int i = 0; i < variable->count; i++) course->stops[i] = place_of_stop(course, i);
    return MT_OK;
}

static mt_status make(mt_variable *variable, bool masters, mt_font_ready ready, void *user) {
    mt_making making = {.variable = variable};
    mt_status status = start(&making);
    if (status == MT_OK) status = run_steps(&making);
    if (status == MT_OK) status = join_glyphs(&making);
    if (status == MT_OK) status = hand_over(&making, masters, ready, user);
    release_steps(&making);
    mt_arena_release(&making.arena);
    return status;
}

mt_status mt_variable_make(mt_variable *variable, mt_font_ready ready, void *user) {
    return make(variable, false, ready, user);
}

mt_status mt_variable_masters(mt_variable *variable, mt_font_ready ready, void *user) {
    return make(variable, true, ready, user);
}
