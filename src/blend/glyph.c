/* One glyph of a blend at every T: built from its parts where it can be, else sent through the morph; else the nearer
 * font's own. */
#include "blend/assemble.h"
#include "blend/job.h"
#include "morph/between/instance.h"
#include "morph/prepare.h"

/* ---- what the fonts have ------------------------------------------------------------------------------- */

/* A side's metrics; 0 where they cannot be read. */
static mt_status read_metrics(mt_font *font, uint32_t glyph, double *advance, mt_vertical *vertical) {
    mt_status across = mt_font_advance(font, glyph, advance);
    mt_status down = mt_font_vertical(font, glyph, vertical);
    return across == MT_NO_MEMORY || down == MT_NO_MEMORY ? MT_NO_MEMORY : MT_OK;
}

mt_status mt_job_read_metrics(mt_worker *worker, mt_pairing p, mt_glyph_pair *pair) {
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

mt_status mt_job_read_shapes(mt_worker *worker, mt_pairing p, mt_glyph_pair *pair) {
    mt_job *job = worker->job;
    const mt_params *params = &job->blend->params;
    mt_status in_b = MT_OK;
    pthread_mutex_lock(&job->fonts);
    mt_status in_a =
        mt_glyph_shape(job->blend->a, p.a, params->tolerance, &worker->scratch, &pair->a, &pair->advance_a);
    if (p.b != MT_NO_PARTNER)
        in_b = mt_glyph_shape(job->blend->b, p.b, params->tolerance, &worker->scratch, &pair->b,
                              &pair->advance_b);
    pthread_mutex_unlock(&job->fonts);
    return in_a != MT_OK ? in_a : in_b;
}

/* ---- what is kept -------------------------------------------------------------------------------------- */

static mt_vertical mixed_vertical(const mt_glyph_pair *pair, double t) {
    const mt_vertical *a = &pair->vertical_a, *b = &pair->vertical_b;
    return (mt_vertical){(1 - t) * a->advance + t * b->advance, (1 - t) * a->origin + t * b->origin};
}

/* The outline, with the metrics at the i-th T. */
static mt_status make_glyf(mt_worker *worker, const mt_outline *outline, const mt_glyph_pair *pair, int i,
                           mt_glyf *glyf) {
    mt_job *job = worker->job;
    double t = job->t[i];
    mt_status status = mt_outline_glyf(outline, mt_mixed_advance(pair, t), job->units, &worker->kept, glyf);
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
static mt_status keep_own(mt_worker *worker, const mt_glyph_pair *pair, int glyph) {
    mt_job *job = worker->job;
    mt_outline outline = {0};
    mt_status status = mt_shape_outline(&pair->a, &job->blend->params, &worker->scratch, &outline);
    for (int i = 0; i < job->t_count && status == MT_OK; i++)
        status = keep_outline(worker, &outline, pair, glyph, i);
    return status;
}

/* Nobody asks for .notdef by name. */
void mt_job_report(mt_job *job, int glyph, mt_status why) {
    if (glyph == 0) return;
    pthread_mutex_lock(&job->fonts);
    if (job->blend->failed)
        job->blend->failed(job->charset->glyphs[glyph].code_point, why, job->blend->failed_user);
    pthread_mutex_unlock(&job->fonts);
}

static mt_status draw_whole(mt_worker *worker, mt_glyph_pair *pair, int glyph) {
    mt_pairing p = worker->job->charset->glyphs[glyph];
    const mt_blend *blend = worker->job->blend;
    mt_hints hints = mt_hint_index_find(blend->hints, p.a, p.b);
    bool alone = p.b == MT_NO_PARTNER;
    mt_status status = mt_job_read_shapes(worker, p, pair);
    if (status == MT_OK && alone) status = keep_own(worker, pair, glyph);
    if (status == MT_OK && !alone)
        status = mt_morph_prepare(&pair->a, &pair->b, &hints, &blend->params, &worker->scratch, &pair->morph);
    if (status == MT_OK && !alone) status = blend_pair(worker, pair, glyph);
    if (status == MT_OK || status == MT_NO_MEMORY) return status;
    worker->job->failed[glyph] = true;
    mt_job_report(worker->job, glyph, status);
    return fall_back(worker, pair, glyph);
}

mt_status mt_job_glyph(mt_worker *worker, int glyph) {
    mt_glyph_pair pair = {0};
    bool whole = false;
    mt_status status = mt_job_read_metrics(worker, worker->job->charset->glyphs[glyph], &pair);
    if (status == MT_OK) status = assemble(worker, &pair, glyph, &whole);
    return status == MT_OK && whole ? draw_whole(worker, &pair, glyph) : status;
}
