/* One glyph of a variable font between two neighbouring fonts: its morph as contours that move. Where there is no morph, both
 * fonts' own outlines, one after the other. */
#include "blend/job.h"

#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "morph/between/variable_outline.h"
#include "morph/prepare.h"
#include "sfnt/axis.h"

/* With rotation, how far a point may be from the way that formula (5) takes it, 1/1000 em. */
#define TURN_WITHIN 1.0

static int *new_places(mt_worker *worker, int count) {
    return mt_arena_new(&worker->kept, (size_t)count, sizeof(int));
}

static mt_status new_spans(mt_worker *worker, int count, mt_passage *passage) {
    passage->spans = mt_arena_new(&worker->kept, (size_t)count, sizeof *passage->spans);
    if (!passage->spans) return MT_NO_MEMORY;
    passage->span_count = count;
    return MT_OK;
}

/* ---- outlines that stay -------------------------------------------------------------------------------- */

/* An outline that stays as it is between two places. */
static mt_status stay(mt_worker *worker, const mt_outline *outline, int from, int to, mt_span *span) {
    int *places = new_places(worker, 2);
    const mt_outline both[2] = {*outline, *outline};
    if (!places) return MT_NO_MEMORY;
    places[0] = from;
    places[1] = to;
    return mt_span_make(both, places, 2, worker->job->units, &worker->kept, &worker->scratch, span);
}

static mt_status stay_as(mt_worker *worker, const mt_shape *shape, int from, int to, mt_span *span) {
    mt_outline outline, blank = {0};
    mt_status status = mt_shape_outline(shape, &worker->job->blend->params, &worker->scratch, &outline);
    if (status == MT_OK) status = stay(worker, &outline, from, to, span);
    return status == MT_TOO_LARGE ? stay(worker, &blank, from, to, span) : status;
}

/* A glyph that some font has not: the first font's own, on the whole axis. */
static mt_status keep_own(mt_worker *worker, const mt_glyph_pair *pair, mt_passage *passage) {
    mt_status status = new_spans(worker, 1, passage);
    if (status != MT_OK) return status;
    return stay_as(worker, &pair->a, 0, MT_PLACE_ONE, &passage->spans[0]);
}

/* The nearer font's own outline; half-way, B's. */
static mt_status fall_back(mt_worker *worker, const mt_glyph_pair *pair, mt_passage *passage) {
    const mt_job *job = worker->job;
    int half = job->from + (job->to - job->from + 1) / 2;
    mt_status status = new_spans(worker, 2, passage);
    if (status == MT_OK) status = stay_as(worker, &pair->a, job->from, half - 1, &passage->spans[0]);
    if (status == MT_OK) status = stay_as(worker, &pair->b, half, job->to, &passage->spans[1]);
    return status;
}

/* ---- contours that move -------------------------------------------------------------------------------- */

/* Whether the contours lie over one another, or themselves, at one of some places on the way. */
static mt_status find_overlap(mt_worker *worker, const mt_morph *morph, const mt_variable_outline *moving,
                              bool *overlaps) {
    enum { LOOKS = 4 };
    mt_outline outline;
    mt_shape shape;
    double tolerance = mt_grid_units(worker->job->blend->params.tolerance) / MT_OVERLAP_CARE;
    bool clean = true;
    for (int i = 0; i <= LOOKS && clean; i++) {
        mt_arena_place before = mt_arena_mark(&worker->scratch);
        mt_weights weights = mt_weights_at((double)i / LOOKS);
        mt_status status = mt_variable_outline_at(morph, moving, weights, &worker->scratch, &outline);
        if (status == MT_OK)
            status = mt_outline_resolve(&outline, tolerance, &worker->scratch, &shape, &clean);
        mt_arena_rewind(&worker->scratch, before);
        if (status != MT_OK) return status;
    }
    *overlaps = !clean;
    return MT_OK;
}

static mt_status draw_steps(mt_worker *worker, const mt_morph *morph, const mt_variable_outline *moving,
                            int steps, mt_span *span) {
    const mt_job *job = worker->job;
    int *places = new_places(worker, steps + 1);
    mt_outline *drawn = mt_arena_new(&worker->scratch, (size_t)steps + 1, sizeof *drawn);
    if (!places || !drawn) return MT_NO_MEMORY;
    for (int i = 0; i <= steps; i++) {
        mt_weights weights = mt_weights_at((double)i / steps);
        mt_status status = mt_variable_outline_at(morph, moving, weights, &worker->scratch, &drawn[i]);
        if (status != MT_OK) return status;
        places[i] = job->from + (int)((int64_t)(job->to - job->from) * i / steps);
    }
    return mt_span_make(drawn, places, steps + 1, job->units, &worker->kept, &worker->scratch, span);
}

static mt_status move(mt_worker *worker, const mt_morph *morph, mt_passage *passage) {
    mt_variable_outline moving;
    mt_status status =
        mt_variable_outline_make(morph, &worker->job->blend->params, &worker->scratch, &moving);
    if (status == MT_OK) status = new_spans(worker, 1, passage);
    if (status != MT_OK) return status;
    int steps = mt_variable_outline_steps(morph, &moving, mt_grid_units(TURN_WITHIN));
    status = draw_steps(worker, morph, &moving, steps, &passage->spans[0]);
    if (status == MT_OK) status = find_overlap(worker, morph, &moving, &passage->spans[0].overlaps);
    return status;
}

/* ---- all of it ----------------------------------------------------------------------------------------- */

static mt_status draw(mt_worker *worker, mt_glyph_pair *pair, int glyph, mt_passage *passage) {
    mt_pairing p = worker->job->charset->glyphs[glyph];
    const mt_blend *blend = worker->job->blend;
    mt_hints hints = mt_hint_index_find(blend->hints, p.a, p.b);
    bool alone = p.b == MT_NO_PARTNER;
    mt_status status = mt_job_read_shapes(worker, p, pair);
    if (status == MT_OK && alone) status = keep_own(worker, pair, passage);
    if (status == MT_OK && !alone)
        status = mt_morph_prepare(&pair->a, &pair->b, &hints, &blend->params, &worker->scratch, &pair->morph);
    if (status == MT_OK && !alone) status = move(worker, &pair->morph, passage);
    if (status == MT_OK || status == MT_NO_MEMORY) return status;
    worker->job->failed[glyph] = true;
    mt_job_report(worker->job, glyph, status);
    return fall_back(worker, pair, passage);
}

mt_status mt_job_moving_glyph(mt_worker *worker, int glyph) {
    mt_job *job = worker->job;
    mt_passage *passage = &job->passages[glyph];
    mt_glyph_pair pair = {0};
    if (job->from > 0 && job->charset->glyphs[glyph].b == MT_NO_PARTNER)
        return MT_OK; /* the first step has it */
    mt_status status = mt_job_read_metrics(worker, job->charset->glyphs[glyph], &pair);
    if (status == MT_OK && job->composites[glyph].count == 0) status = draw(worker, &pair, glyph, passage);
    passage->advance_a = pair.advance_a;
    passage->advance_b = pair.advance_b;
    passage->vertical_a = pair.vertical_a;
    passage->vertical_b = pair.vertical_b;
    return status;
}
