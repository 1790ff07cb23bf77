/* The blend of two fonts: pairs their glyphs, sends each pair through the morph, or builds it from its parts, and writes
 * the fonts.
 *
 * A glyph is the unit of work. Workers take the next one from a counter; each has an arena for the glyph at
 * hand, emptied after it, and one for the results. A glyph is read and prepared once for all values of T.
 * Results stand in the order of the glyphs, whoever made them, so that the fonts do not depend on the number
 * of workers. Composites wait until all of their parts are made: they are made depth by depth.
 */
#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <unistd.h>

#include "font/assemble.h"
#include "font/charset.h"
#include "font/composite.h"
#include "font/glyph_names.h"
#include "font/pair.h"
#include "font/recipe.h"
#include "font/review.h"
#include "font/save.h"
#include "font/sfnt.h"
#include "geometry/limits.h"
#include "layout/gsub_subset.h"
#include "layout/kerning.h"

struct mt_blend {
    mt_font *a, *b;
    mt_params params;
    mt_hint_index *hints; /* NULL: none */
    char *family;         /* NULL: made from the sources' */
    uint32_t *wanted;
    int wanted_count;
    mt_glyph_set set;
    int unblended; /* glyphs of the last fonts */
    mt_glyph_failed failed;
    mt_progress progress;
    void *failed_user, *progress_user;
};

/* ---- the handle ---------------------------------------------------------------------------------------- */

mt_status mt_blend_new(mt_font *a, mt_font *b, const mt_params *params, mt_blend **blend) {
    mt_status status = mt_params_check(params);
    if (status != MT_OK) return status;
    mt_blend *made = mt_new(1, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    *made = (mt_blend){.a = a, .b = b, .params = *params};
    *blend = made;
    return MT_OK;
}

void mt_blend_free(mt_blend *blend) {
    if (!blend) return;
    mt_hint_index_free(blend->hints);
    mt_free(blend->family);
    mt_free(blend->wanted);
    mt_free(blend);
}

void mt_blend_on_failure(mt_blend *blend, mt_glyph_failed call, void *user) {
    blend->failed = call;
    blend->failed_user = user;
}

void mt_blend_on_progress(mt_blend *blend, mt_progress call, void *user) {
    blend->progress = call;
    blend->progress_user = user;
}

mt_status mt_blend_set_family(mt_blend *blend, const char *name) {
    char *copy = name ? mt_copy_text(name) : NULL;
    if (name && !copy) return MT_NO_MEMORY;
    mt_free(blend->family);
    blend->family = copy;
    return MT_OK;
}

mt_status mt_blend_warnings(const mt_blend *blend, mt_warning call, void *user) {
    return mt_review(blend->a, blend->b, blend->family, call, user);
}

mt_status mt_blend_set_chars(mt_blend *blend, const uint32_t *code_points, int count) {
    uint32_t *copy = count > 0 ? mt_new((size_t)count, sizeof *copy) : NULL;
    if (count > 0 && !copy) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) copy[i] = code_points[i];
    mt_free(blend->wanted);
    blend->wanted = copy;
    blend->wanted_count = count > 0 ? count : 0;
    return MT_OK;
}

void mt_blend_set_glyphs(mt_blend *blend, mt_glyph_set set) {
    blend->set = set;
}

int mt_blend_unblended(const mt_blend *blend) {
    return blend->unblended;
}

mt_status mt_blend_set_hints(mt_blend *blend, const mt_hint_table *table, mt_hint_error *error) {
    mt_hint_index *index = NULL;
    mt_status status = table ? mt_hint_index_new(table, blend->a, blend->b, &index, error) : MT_OK;
    if (status != MT_OK) return status;
    mt_hint_index_free(blend->hints);
    blend->hints = index;
    return MT_OK;
}

const mt_hint_index *mt_blend_hints(const mt_blend *blend) {
    return blend->hints;
}

int mt_blend_units_per_em(const mt_blend *blend) {
    return mt_recipe_units(blend->a, blend->b);
}

/* ---- one glyph ----------------------------------------------------------------------------------------- */

static bool is_place(double t) {
    return t >= 0 && t <= 1; /* false for a NaN */
}

static double mixed_advance(const mt_glyph_pair *pair, double t) {
    return (1 - t) * pair->advance_a + t * pair->advance_b;
}

static mt_vertical mixed_vertical(const mt_glyph_pair *pair, double t) {
    const mt_vertical *a = &pair->vertical_a, *b = &pair->vertical_b;
    return (mt_vertical){(1 - t) * a->advance + t * b->advance, (1 - t) * a->origin + t * b->origin};
}

static void draw_contour(const mt_contour *contour, double scale, const mt_draw *draw, void *user) {
    mt_point start = contour->segments[contour->count - 1].end;
    draw->move_to(start.x * scale, start.y * scale, user);
    for (int i = 0; i < contour->count; i++) {
        const mt_segment *s = &contour->segments[i];
        if (s->degree == 1)
            draw->line_to(s->end.x * scale, s->end.y * scale, user);
        else
            draw->quadratic_to(s->control[0].x * scale, s->control[0].y * scale, s->end.x * scale,
                               s->end.y * scale, user);
    }
    draw->close(user);
}

mt_status mt_blend_glyph(mt_blend *blend, uint32_t code_point, double t, const mt_draw *draw, void *user,
                         double *advance) {
    if (!is_place(t)) return MT_BAD_PARAMETER;
    mt_arena arena = {0};
    mt_glyph_pair pair;
    mt_outline outline;
    mt_status status =
        mt_glyph_pair_prepare(blend->a, blend->b, code_point, blend->hints, &blend->params, &arena, &pair);
    if (status == MT_OK)
        status = mt_morph_outline(&pair.morph, mt_weights_at(t), &blend->params, &arena, &outline);
    if (status == MT_OK) {
        double scale = (double)mt_blend_units_per_em(blend) / MT_EM;
        for (int i = 0; i < outline.count; i++) draw_contour(&outline.contours[i], scale, draw, user);
        *advance = mixed_advance(&pair, t) * scale;
    }
    mt_arena_release(&arena);
    return status;
}

/* ---- workers ------------------------------------------------------------------------------------------- */

typedef struct mt_job {
    mt_blend *blend;
    const mt_charset *charset;
    const double *t;
    int t_count, units;
    mt_font_ready ready;
    void *user;
    mt_layout_tables layout;
    const char **glyph_names; /* NULL: none */
    mt_positions *positions;
    mt_glyf **glyphs;    /* for each T, one for each glyph of the charset */
    mt_extent **extents; /* as many */
    bool *failed;        /* for each glyph: it could not be blended */
    mt_composite *composites;
    int *order; /* the glyphs by depth */
    int end;    /* of the depth at hand, in the order */
    atomic_int next, done;
    atomic_int status;     /* the first that stops everything */
    pthread_mutex_t fonts; /* FreeType's faces are not for two threads at once; neither are the callbacks */
} mt_job;

typedef struct mt_worker {
    mt_job *job;
    mt_arena scratch, kept;
} mt_worker;

/* A side's metrics; 0 where they cannot be read. */
static mt_status read_metrics(mt_font *font, uint32_t glyph, double *advance, mt_vertical *vertical) {
    mt_status across = mt_font_advance(font, glyph, advance);
    mt_status down = mt_font_vertical(font, glyph, vertical);
    return across == MT_NO_MEMORY || down == MT_NO_MEMORY ? MT_NO_MEMORY : MT_OK;
}

/* A glyph that B has not has A's on both sides. */
static mt_status read_both_metrics(mt_worker *worker, mt_pairing p, mt_glyph_pair *pair) {
    mt_job *job = worker->job;
    bool alone = p.b == MT_NO_PARTNER;
    pthread_mutex_lock(&job->fonts);
    mt_status in_a = read_metrics(job->blend->a, p.a, &pair->advance_a, &pair->vertical_a);
    mt_status in_b = alone ? MT_OK : read_metrics(job->blend->b, p.b, &pair->advance_b, &pair->vertical_b);
    pthread_mutex_unlock(&job->fonts);
    if (alone) pair->advance_b = pair->advance_a;
    if (alone) pair->vertical_b = pair->vertical_a;
    return in_a != MT_OK ? in_a : in_b;
}

/* Both sides' shapes; a side that cannot be read has none, and its status is returned. */
static mt_status read_sides(mt_worker *worker, mt_pairing p, mt_glyph_pair *pair) {
    mt_job *job = worker->job;
    const mt_params *params = &job->blend->params;
    pthread_mutex_lock(&job->fonts);
    mt_status in_a =
        mt_glyph_shape(job->blend->a, p.a, params->tolerance, &worker->scratch, &pair->a, &pair->advance_a);
    mt_status in_b =
        mt_glyph_shape(job->blend->b, p.b, params->tolerance, &worker->scratch, &pair->b, &pair->advance_b);
    pthread_mutex_unlock(&job->fonts);
    return in_a != MT_OK ? in_a : in_b;
}

/* The outline, with the metrics at the i-th T. */
static mt_status make_glyf(mt_worker *worker, const mt_outline *outline, const mt_glyph_pair *pair, int i,
                           mt_glyf *glyf) {
    mt_job *job = worker->job;
    double t = job->t[i];
    mt_status status = mt_outline_glyf(outline, mixed_advance(pair, t), job->units, &worker->kept, glyf);
    if (status == MT_OK) mt_glyf_hang(mixed_vertical(pair, t), job->units, glyf);
    return status;
}

static mt_status keep_outline(mt_worker *worker, const mt_outline *outline, const mt_glyph_pair *pair,
                              int glyph, int i) {
    mt_glyf *kept = &worker->job->glyphs[i][glyph];
    mt_status status = make_glyf(worker, outline, pair, i, kept);
    return status == MT_OK ? mt_glyf_extent(kept, NULL, &worker->job->extents[i][glyph]) : status;
}

/* ---- composites ---------------------------------------------------------------------------------------- */

static bool is_assembled(const mt_job *job, int glyph, int i) {
    return job->glyphs[i][glyph].reference_count > 0;
}

static mt_assembly assembly_at(const mt_job *job, int i) {
    double t = job->t[i];
    return (mt_assembly){.units = job->units,
                         .tolerance = job->blend->params.tolerance,
                         .unit_a = (1 - t) * job->units / mt_font_units(job->blend->a),
                         .unit_b = t * job->units / mt_font_units(job->blend->b),
                         .glyphs = job->glyphs[i],
                         .extents = job->extents[i]};
}

static bool has_failed_part(const mt_job *job, const mt_composite *composite) {
    for (int k = 0; k < composite->count; k++)
        if (job->failed[composite->references[k].glyph]) return true;
    return false;
}

/* Makes the composite wherever it can be one. A blended part was turned by itself, so that with a rotation the whole is
 * not its parts. *whole: the drawing is wanted, for some T. */
static mt_status assemble(mt_worker *worker, const mt_glyph_pair *pair, int glyph, bool *whole) {
    mt_job *job = worker->job;
    const mt_composite *composite = &job->composites[glyph];
    *whole = composite->count == 0 || has_failed_part(job, composite) ||
             job->blend->params.rotation != MT_ROTATION_NONE;
    if (*whole) return MT_OK;
    for (int i = 0; i < job->t_count; i++) {
        mt_assembly font = assembly_at(job, i);
        mt_glyf made;
        mt_extent *extent = &job->extents[i][glyph];
        mt_status status = make_glyf(worker, &(mt_outline){0}, pair, i, &made);
        if (status == MT_OK)
            status = mt_composite_assemble(composite, &font, &worker->kept, &worker->scratch, &made, extent);
        if (status == MT_NO_MEMORY) return status;
        if (status == MT_OK && made.reference_count > 0) job->glyphs[i][glyph] = made;
        *whole = *whole || !is_assembled(job, glyph, i);
    }
    return MT_OK;
}

/* ---- drawings ------------------------------------------------------------------------------------------ */

static mt_status blend_pair(mt_worker *worker, const mt_glyph_pair *pair, int glyph) {
    for (int i = 0; i < worker->job->t_count; i++) {
        if (is_assembled(worker->job, glyph, i)) continue;
        mt_outline outline;
        mt_weights weights = mt_weights_at(worker->job->t[i]);
        mt_status status =
            mt_morph_outline(&pair->morph, weights, &worker->job->blend->params, &worker->scratch, &outline);
        if (status == MT_OK) status = keep_outline(worker, &outline, pair, glyph, i);
        if (status != MT_OK) return status;
    }
    return MT_OK;
}

/* The nearer font's own outline instead of the blend; nothing, where that cannot be had either. */
static mt_status fall_back(mt_worker *worker, const mt_glyph_pair *pair, int glyph) {
    for (int i = 0; i < worker->job->t_count; i++) {
        if (is_assembled(worker->job, glyph, i)) continue;
        const mt_shape *nearer = worker->job->t[i] < 0.5 ? &pair->a : &pair->b;
        mt_outline outline = {0}, blank = {0};
        mt_status status = mt_shape_outline(nearer, &worker->job->blend->params, &worker->scratch, &outline);
        if (status == MT_OK) status = keep_outline(worker, &outline, pair, glyph, i);
        if (status == MT_TOO_LARGE) status = keep_outline(worker, &blank, &(mt_glyph_pair){0}, glyph, i);
        if (status != MT_OK) return status;
    }
    return MT_OK;
}

/* A glyph that B has not: A's own, at all T. */
static mt_status keep_own(mt_worker *worker, mt_pairing p, mt_glyph_pair *pair, int glyph) {
    mt_job *job = worker->job;
    const mt_params *params = &job->blend->params;
    mt_outline outline = {0};
    pthread_mutex_lock(&job->fonts);
    mt_status status =
        mt_glyph_shape(job->blend->a, p.a, params->tolerance, &worker->scratch, &pair->a, &pair->advance_a);
    pthread_mutex_unlock(&job->fonts);
    if (status == MT_OK) status = mt_shape_outline(&pair->a, params, &worker->scratch, &outline);
    for (int i = 0; i < job->t_count && status == MT_OK; i++)
        status = keep_outline(worker, &outline, pair, glyph, i);
    return status;
}

static void report_failure(mt_job *job, uint32_t code_point, mt_status why) {
    pthread_mutex_lock(&job->fonts);
    if (job->blend->failed) job->blend->failed(code_point, why, job->blend->failed_user);
    pthread_mutex_unlock(&job->fonts);
}

static mt_status draw_whole(mt_worker *worker, mt_glyph_pair *pair, int glyph) {
    mt_pairing p = worker->job->charset->glyphs[glyph];
    const mt_blend *blend = worker->job->blend;
    mt_hints hints = mt_hint_index_find(blend->hints, p.a, p.b);
    bool alone = p.b == MT_NO_PARTNER;
    mt_status status = alone ? keep_own(worker, p, pair, glyph) : read_sides(worker, p, pair);
    if (status == MT_OK && !alone)
        status = mt_morph_prepare(&pair->a, &pair->b, &hints, &blend->params, &worker->scratch, &pair->morph);
    if (status == MT_OK && !alone) status = blend_pair(worker, pair, glyph);
    if (status == MT_OK || status == MT_NO_MEMORY) return status;
    worker->job->failed[glyph] = true;
    if (glyph != 0) report_failure(worker->job, p.code_point, status); /* nobody asks for .notdef by name */
    return fall_back(worker, pair, glyph);
}

static mt_status do_glyph(mt_worker *worker, int glyph) {
    mt_glyph_pair pair = {0};
    bool whole = false;
    mt_status status = read_both_metrics(worker, worker->job->charset->glyphs[glyph], &pair);
    if (status == MT_OK) status = assemble(worker, &pair, glyph, &whole);
    return status == MT_OK && whole ? draw_whole(worker, &pair, glyph) : status;
}

static void report_progress(mt_job *job) {
    int done = atomic_fetch_add(&job->done, 1) + 1, all = job->charset->glyph_count;
    if (!job->blend->progress || (done % 64 != 0 && done != all)) return;
    pthread_mutex_lock(&job->fonts);
    job->blend->progress(done, all, job->blend->progress_user);
    pthread_mutex_unlock(&job->fonts);
}

static void *work(void *argument) {
    mt_worker *worker = argument;
    mt_job *job = worker->job;
    for (;;) {
        int turn = atomic_fetch_add(&job->next, 1);
        if (turn >= job->end || atomic_load(&job->status) != MT_OK) break;
        mt_status status = do_glyph(worker, job->order[turn]);
        mt_arena_reset(&worker->scratch);
        if (status != MT_OK)
            atomic_store(&job->status, (int)status);
        else
            report_progress(job);
    }
    return NULL;
}

static int worker_count(const mt_job *job) {
    long cores = job->blend->params.threads ? job->blend->params.threads : sysconf(_SC_NPROCESSORS_ONLN);
    long most = cores < 1 ? 1 : cores > 256 ? 256 : cores;
    return (int)(most < job->charset->glyph_count ? most : job->charset->glyph_count);
}

/* Runs the depth at hand on workers[0 … count); the first works on this thread. A thread that cannot be had is
 * done without. */
static void run_depth(mt_worker *workers, int count) {
    pthread_t threads[256];
    bool started[256] = {false};
    for (int i = 1; i < count; i++) started[i] = pthread_create(&threads[i], NULL, work, &workers[i]) == 0;
    work(&workers[0]);
    for (int i = 1; i < count; i++)
        if (started[i]) pthread_join(threads[i], NULL);
}

static mt_status run(mt_job *job, mt_worker *workers, int count) {
    pthread_mutex_init(&job->fonts, NULL);
    for (int i = 0; i < count; i++) workers[i].job = job;
    for (int start = 0; start < job->charset->glyph_count; start = job->end) {
        int depth = job->composites[job->order[start]].depth;
        job->end = start;
        while (job->end < job->charset->glyph_count && job->composites[job->order[job->end]].depth == depth)
            job->end++;
        atomic_store(&job->next, start);
        run_depth(workers, count);
    }
    for (int i = 0; i < count; i++) mt_arena_release(&workers[i].scratch);
    pthread_mutex_destroy(&job->fonts);
    return (mt_status)atomic_load(&job->status);
}

/* ---- fonts --------------------------------------------------------------------------------------------- */

static void add_extra(mt_font_data *data, uint32_t tag, mt_bytes table) {
    if (table.length) data->extras[data->extra_count++] = (mt_extra_table){tag, table};
}

/* As GPOS, and as groups and pairs. */
static mt_status add_positions(const mt_job *job, double t, mt_arena *arena, mt_font_data *data) {
    mt_bytes gpos;
    mt_kerning *kerning = mt_arena_new(arena, 1, sizeof *kerning);
    if (!kerning) return MT_NO_MEMORY;
    mt_status status = mt_positions_write(job->positions, t, arena, &gpos);
    if (status == MT_OK) status = mt_positions_kerning(job->positions, t, arena, kerning);
    if (status != MT_OK) return status;
    add_extra(data, MT_TAG('G', 'P', 'O', 'S'), gpos);
    data->kerning = kerning;
    return MT_OK;
}

static mt_status hand_over(const mt_job *job, int i, mt_arena *arena) {
    const mt_charset *charset = job->charset;
    mt_font_data data = {.units = job->units,
                         .glyph_count = charset->glyph_count,
                         .glyphs = job->glyphs[i],
                         .char_count = charset->char_count,
                         .chars = charset->chars,
                         .variant_count = charset->variant_count,
                         .variants = charset->variants,
                         .glyph_names = job->glyph_names};
    add_extra(&data, MT_TAG('G', 'S', 'U', 'B'), job->layout.gsub);
    add_extra(&data, MT_TAG('G', 'D', 'E', 'F'), job->layout.gdef);
    mt_status status =
        mt_recipe_fill(job->blend->a, job->blend->b, job->t[i], job->blend->family, arena, &data);
    if (status == MT_OK) status = add_positions(job, job->t[i], arena, &data);
    return status == MT_OK ? job->ready(&data, i, job->user) : status;
}

static mt_status hand_over_all(const mt_job *job, mt_arena *arena) {
    mt_status status = MT_OK;
    for (int i = 0; i < job->t_count && status == MT_OK; i++) status = hand_over(job, i, arena);
    return status;
}

/* The first font's substitutions and the names, for the glyphs that are kept. */
static mt_status make_layout(mt_job *job, mt_arena *arena) {
    const mt_charset *charset = job->charset;
    uint16_t *kept = mt_arena_new(arena, (size_t)charset->primary_count, sizeof *kept);
    if (!kept) return MT_NO_MEMORY;
    for (int i = 0; i < charset->primary_count; i++) kept[i] = (uint16_t)charset->glyphs[i].a;
    mt_status status = mt_gsub_subset(job->blend->a, kept, charset->primary_count, arena, &job->layout);
    if (status == MT_OK) status = mt_charset_twins(charset, arena, &job->layout);
    if (status != MT_OK) return status;
    return mt_glyph_names_make(job->blend->a, charset, arena, &job->glyph_names);
}

/* Sorts the glyphs by depth, and keeps their order otherwise. */
static void order_glyphs(mt_job *job) {
    int count = job->charset->glyph_count, ordered = 0;
    for (int depth = 0; depth <= MT_GLYF_DEPTH_MAX; depth++)
        for (int i = 0; i < count; i++)
            if (job->composites[i].depth == depth) job->order[ordered++] = i;
}

static mt_status start_job(mt_job *job, mt_arena *arena) {
    job->blend->unblended = job->charset->unblended_count;
    size_t places = (size_t)job->t_count, glyphs = (size_t)job->charset->glyph_count;
    job->glyphs = mt_arena_new(arena, places, sizeof *job->glyphs);
    job->extents = mt_arena_new(arena, places, sizeof *job->extents);
    job->failed = mt_arena_new(arena, glyphs, sizeof *job->failed);
    job->order = mt_arena_new(arena, glyphs, sizeof *job->order);
    if (!job->glyphs || !job->extents || !job->failed || !job->order) return MT_NO_MEMORY;
    for (size_t i = 0; i < places; i++) {
        job->glyphs[i] = mt_arena_new(arena, glyphs, sizeof(mt_glyf));
        job->extents[i] = mt_arena_new(arena, glyphs, sizeof(mt_extent));
        if (!job->glyphs[i] || !job->extents[i]) return MT_NO_MEMORY;
    }
    const mt_blend *blend = job->blend;
    mt_status status =
        mt_composites_find(blend->a, blend->b, job->charset, blend->hints, arena, &job->composites);
    if (status != MT_OK) return status;
    order_glyphs(job);
    return make_layout(job, arena);
}

static mt_status make_fonts(mt_job *job, mt_arena *arena) {
    mt_charset charset;
    mt_blend *blend = job->blend;
    mt_charset_request request = {blend->wanted, blend->wanted_count, blend->set};
    mt_status status = mt_charset_make(blend->a, blend->b, &request, arena, &charset);
    job->charset = &charset;
    if (status == MT_OK) status = start_job(job, arena);
    if (status == MT_OK)
        status = mt_positions_prepare(blend->a, blend->b, &charset, job->units, arena, &job->positions);
    if (status != MT_OK) return status;
    int count = worker_count(job);
    mt_worker *workers = mt_arena_new(arena, (size_t)count, sizeof *workers);
    if (!workers) return MT_NO_MEMORY;
    status = run(job, workers, count);
    if (status == MT_OK) status = hand_over_all(job, arena);
    for (int i = 0; i < count; i++) mt_arena_release(&workers[i].kept);
    return status;
}

mt_status mt_blend_make(mt_blend *blend, const double *t, int count, mt_font_ready ready, void *user) {
    for (int i = 0; i < count; i++)
        if (!is_place(t[i])) return MT_BAD_PARAMETER;
    mt_arena arena = {0};
    mt_job job = {.blend = blend,
                  .t = t,
                  .t_count = count,
                  .units = mt_blend_units_per_em(blend),
                  .ready = ready,
                  .user = user};
    mt_status status = make_fonts(&job, &arena);
    mt_arena_release(&arena);
    return status;
}

typedef struct mt_font_bytes {
    uint8_t **bytes;
    size_t *lengths;
    int count;
} mt_font_bytes;

static mt_status keep_bytes(const mt_font_data *data, int index, void *user) {
    mt_font_bytes *fonts = user;
    mt_status status = mt_font_write(data, &fonts->bytes[index], &fonts->lengths[index]);
    if (status == MT_OK) fonts->count++;
    return status;
}

mt_status mt_blend_fonts(mt_blend *blend, const double *t, int count, uint8_t **bytes, size_t *lengths) {
    mt_font_bytes fonts = {bytes, lengths, 0};
    mt_status status = mt_blend_make(blend, t, count, keep_bytes, &fonts);
    while (status != MT_OK && fonts.count > 0) mt_bytes_free(bytes[--fonts.count]);
    return status;
}

mt_status mt_blend_font(mt_blend *blend, double t, uint8_t **bytes, size_t *length) {
    return mt_blend_fonts(blend, &t, 1, bytes, length);
}
