#include "motion/motion.h"

#include <math.h>

#include "geometry/limits.h"
#include "morph/model/params.h"

/* ---- key frames ---------------------------------------------------------------------------------------- */

static bool has_drawing(const mt_motion_request *request) {
    for (int i = 0; i < request->key_count; i++)
        if (!request->keys[i].font) return true;
    return false;
}

static bool is_valid(const mt_motion_request *request) {
    int keys = request->key_count, colours = request->colour_count;
    return keys >= 2 && keys <= MT_VARIABLE_FONTS_MAX && mt_params_check(&request->params) == MT_OK &&
           mt_timing_is_valid(&request->timing) && (colours == 1 || colours == 2 || colours == keys) &&
           !(request->hints && has_drawing(request));
}

static mt_status read_figure(mt_motion *motion, const mt_key *key, mt_figure *figure, int *lacking) {
    double tolerance = motion->request.params.tolerance;
    return key->font ? mt_figure_read(key->font, &key->text, tolerance, &motion->arena, figure, lacking)
                     : mt_figure_of_drawing(key->drawing, tolerance, &motion->arena, figure);
}

static mt_status read_figures(mt_motion *motion, mt_motion_fault *fault) {
    const mt_motion_request *request = &motion->request;
    motion->figures = mt_arena_new(&motion->arena, (size_t)request->key_count, sizeof *motion->figures);
    if (!motion->figures) return MT_NO_MEMORY;
    for (int i = 0; i < request->key_count; i++) {
        mt_motion_fault at = {.key = i, .lacking = -1};
        mt_status status = read_figure(motion, &request->keys[i], &motion->figures[i], &at.lacking);
        if (status == MT_OK) continue;
        if (status != MT_NO_MEMORY) *fault = at;
        return status;
    }
    return MT_OK;
}

/* ---- stretches ----------------------------------------------------------------------------------------- */

/* A pair of parts, to be prepared by a worker. */
typedef struct mt_part_task {
    mt_stretch *stretch;
    int pair;
    mt_hints hints;
} mt_part_task;

typedef struct mt_part_tasks {
    const mt_params *params;
    int count;
    mt_part_task *list;
} mt_part_tasks;

/* The part that a run is, NULL for nothing; several are one in the arena. */
static mt_status part_of(const mt_figure *figure, mt_part_run run, mt_arena *arena, mt_figure_part *group,
                         const mt_figure_part **part) {
    *part = run.count == 0 ? NULL : run.count == 1 ? &figure->parts[run.first] : group;
    return run.count > 1 ? mt_group_parts(figure, run.first, run.count, arena, group) : MT_OK;
}

static mt_status prepare_part(int index, mt_arena *scratch, mt_arena *kept, void *user) {
    const mt_part_tasks *tasks = user;
    const mt_part_task *task = &tasks->list[index];
    mt_part_pair pair = task->stretch->pairs.pairs[task->pair];
    mt_figure_part groups[2];
    const mt_figure_part *a, *b;
    mt_status status = part_of(task->stretch->a, pair.a, scratch, &groups[0], &a);
    if (status == MT_OK) status = part_of(task->stretch->b, pair.b, scratch, &groups[1], &b);
    if (status != MT_OK) return status;
    return mt_moving_part_make(a, b, &task->hints, tasks->params, scratch, kept,
                               &task->stretch->parts[task->pair]);
}

static mt_status pair_figures(mt_motion *motion) {
    motion->stretch_count = motion->request.key_count - 1;
    motion->stretches =
        mt_arena_new(&motion->arena, (size_t)motion->stretch_count, sizeof *motion->stretches);
    if (!motion->stretches) return MT_NO_MEMORY;
    for (int i = 0; i < motion->stretch_count; i++) {
        mt_stretch *stretch = &motion->stretches[i];
        *stretch = (mt_stretch){.a = &motion->figures[i], .b = &motion->figures[i + 1]};
        mt_status status = mt_pair_parts(stretch->a, stretch->b, &motion->arena, &stretch->pairs);
        if (status != MT_OK) return status;
        stretch->parts = mt_arena_new(&motion->arena, (size_t)stretch->pairs.count, sizeof *stretch->parts);
        if (!stretch->parts) return MT_NO_MEMORY;
    }
    return MT_OK;
}

/* The hints are about characters that both fonts have, drawn by one glyph each. */
static mt_hints hints_for(const mt_hint_index *index, const mt_stretch *stretch, mt_part_pair pair) {
    if (pair.a.count != 1 || pair.b.count != 1) return (mt_hints){0};
    uint32_t a = stretch->a->parts[pair.a.first].glyph, b = stretch->b->parts[pair.b.first].glyph;
    return a == MT_SEVERAL_GLYPHS || b == MT_SEVERAL_GLYPHS ? (mt_hints){0} : mt_hint_index_find(index, a, b);
}

static mt_status list_tasks(mt_motion *motion, const mt_row *row, mt_part_tasks *tasks) {
    bool hinted = !has_drawing(&motion->request);
    size_t count = 0;
    for (int i = 0; i < motion->stretch_count; i++) count += (size_t)motion->stretches[i].pairs.count;
    *tasks =
        (mt_part_tasks){&motion->request.params, 0, mt_arena_new(&motion->arena, count, sizeof *tasks->list)};
    if (!tasks->list) return MT_NO_MEMORY;
    for (int i = 0; i < motion->stretch_count; i++) {
        mt_stretch *stretch = &motion->stretches[i];
        for (int k = 0; k < stretch->pairs.count; k++)
            tasks->list[tasks->count++] = (mt_part_task){
                stretch, k,
                hinted ? hints_for(row->hints[i], stretch, stretch->pairs.pairs[k]) : (mt_hints){0}};
    }
    return MT_OK;
}

static mt_status prepare_parts(mt_motion *motion, const mt_row *row) {
    const mt_motion_request *request = &motion->request;
    mt_part_tasks tasks;
    mt_status status = list_tasks(motion, row, &tasks);
    if (status != MT_OK) return status;
    const mt_work work = {.count = tasks.count,
                          .task = prepare_part,
                          .user = &tasks,
                          .kept = &motion->kept,
                          .threads = request->params.threads,
                          .progress = request->progress,
                          .progress_user = request->progress_user};
    status = mt_work_run(&work);
    for (int i = 0; status == MT_OK && i < motion->stretch_count; i++)
        motion->stretches[i].steps = mt_stretch_steps(&motion->stretches[i]);
    return status;
}

/* The key frames' fonts as a row, for its hints; with a drawing among them there is none, and so are there no hints. */
static mt_status open_row(const mt_motion_request *request, mt_row *row, mt_hint_error *error) {
    mt_font *fonts[MT_VARIABLE_FONTS_MAX];
    for (int i = 0; i < request->key_count; i++) fonts[i] = request->keys[i].font;
    mt_status status = mt_row_open(fonts, request->key_count, &request->params, row);
    return status == MT_OK ? mt_row_set_hints(row, request->hints, error) : status;
}

static mt_status prepare(mt_motion *motion, mt_motion_fault *fault) {
    mt_row row = {0};
    mt_status status = has_drawing(&motion->request) ? MT_OK : open_row(&motion->request, &row, &fault->hint);
    if (status == MT_OK) status = pair_figures(motion);
    if (status == MT_OK) status = prepare_parts(motion, &row);
    mt_row_close(&row);
    return status;
}

/* ---- the canvas ---------------------------------------------------------------------------------------- */

/* How far the motion overshoots 0 and 1, by its easing. */
static void find_reach(const mt_easing *easing, double *low, double *high) {
    enum { LOOKS = 256 };
    *low = 0;
    *high = 1;
    for (int i = 1; i < LOOKS; i++) {
        double progress = mt_easing_at(easing, (double)i / LOOKS);
        *low = fmin(*low, progress);
        *high = fmax(*high, progress);
    }
}

static mt_status take_in_moment(const mt_motion *motion, mt_moment moment, bool exact, mt_bounds *bounds) {
    mt_arena arena = {0};
    mt_drawing drawing;
    mt_status status = mt_motion_draw(motion, moment, exact, &arena, &drawing);
    if (status == MT_OK) mt_bounds_take_in(bounds, &drawing);
    mt_arena_release(&arena);
    return status;
}

/* Between two bends of its contours a stretch stays in the box around both. */
static mt_status find_bounds(const mt_motion *motion, mt_bounds *bounds) {
    double low, high;
    int last = motion->stretch_count - 1;
    mt_status status = MT_OK;
    *bounds = mt_bounds_of_nothing();
    for (int i = 0; i <= last; i++)
        for (int k = 0; k <= motion->stretches[i].steps && status == MT_OK; k++)
            status =
                take_in_moment(motion, (mt_moment){i, (double)k / motion->stretches[i].steps}, true, bounds);
    find_reach(&motion->request.timing.easing, &low, &high);
    /* Eased as a whole, the share over the end is of all stretches. */
    double reach = motion->request.timing.whole ? motion->stretch_count : 1;
    if (status == MT_OK && low < 0)
        status = take_in_moment(motion, (mt_moment){0, low * reach}, false, bounds);
    if (status == MT_OK && high > 1)
        status = take_in_moment(motion, (mt_moment){last, 1 + (high - 1) * reach}, false, bounds);
    return status;
}

static mt_status lay_page(mt_motion *motion) {
    mt_bounds bounds;
    mt_status status = find_bounds(motion, &bounds);
    return status == MT_OK ? mt_page_lay(&motion->request.page, bounds, &motion->page) : status;
}

mt_status mt_motion_open(const mt_motion_request *request, mt_motion *motion, mt_motion_fault *fault) {
    *motion = (mt_motion){.request = *request};
    *fault = (mt_motion_fault){.key = -1, .lacking = -1};
    if (!is_valid(request)) return MT_BAD_PARAMETER;
    mt_status status = read_figures(motion, fault);
    if (status == MT_OK) status = prepare(motion, fault);
    if (status == MT_OK)
        status = mt_timeline_make(&request->timing, motion->stretch_count, &motion->arena, &motion->timeline);
    return status == MT_OK ? lay_page(motion) : status;
}

void mt_motion_close(mt_motion *motion) {
    mt_arena_release(&motion->arena);
    mt_thread_arenas_release(&motion->kept);
}

/* ---- moments ------------------------------------------------------------------------------------------- */

mt_status mt_motion_draw(const mt_motion *motion, mt_moment moment, bool exact, mt_arena *arena,
                         mt_drawing *drawing) {
    const mt_stretch *stretch = &motion->stretches[moment.stretch];
    if (exact && moment.t == 0) return mt_figure_drawing(stretch->a, arena, drawing);
    if (exact && moment.t == 1) return mt_figure_drawing(stretch->b, arena, drawing);
    return mt_stretch_at(stretch, moment.t, arena, drawing);
}

static mt_colour key_colour(const mt_motion *motion, int key) {
    const mt_motion_request *request = &motion->request;
    int last = request->key_count - 1;
    if (request->colour_count == request->key_count) return request->colours[key];
    if (request->colour_count == 1) return request->colours[0];
    return mt_colour_mix(request->colours[0], request->colours[1], (double)key / last);
}

mt_colour mt_motion_colour(const mt_motion *motion, mt_moment moment) {
    return mt_colour_mix(key_colour(motion, moment.stretch), key_colour(motion, moment.stretch + 1),
                         moment.t);
}
