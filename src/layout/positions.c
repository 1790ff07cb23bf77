#include "layout/positions.h"

#include "font/sfnt.h"
#include "layout/gpos.h"
#include "layout/pair_write.h"
#include "layout/position_data.h"

/* ---- the two fonts ------------------------------------------------------------------------------------- */

typedef struct mt_position_source {
    mt_font *font;
    mt_bytes kern;
    mt_layout layout;
    mt_variations variations;
    double scale; /* units of the new font in one of this font's */
} mt_position_source;

static mt_status open_source(mt_font *font, int units, mt_arena *arena, mt_position_source *source) {
    mt_bytes gpos, gdef;
    const int32_t *place;
    int axes = mt_font_place(font, &place);
    *source = (mt_position_source){.font = font, .scale = (double)units / mt_font_units(font)};
    mt_status status = mt_font_table(font, MT_TAG('G', 'P', 'O', 'S'), arena, &gpos);
    if (status == MT_OK) status = mt_font_table(font, MT_TAG('G', 'D', 'E', 'F'), arena, &gdef);
    if (status == MT_OK) status = mt_font_table(font, MT_TAG('k', 'e', 'r', 'n'), arena, &source->kern);
    if (status == MT_OK) status = mt_layout_open(gpos, MT_EXTENSION_GPOS, arena, &source->layout);
    if (status == MT_OK) status = mt_variations_open(gdef, place, axes, arena, &source->variations);
    return status;
}

/* What the parts of the preparation share. */
typedef struct mt_position_job {
    mt_position_source sources[2];
    mt_feature_source features[2];
    const mt_charset *charset;
    mt_arena *arena;
    mt_arena scratch;   /* of the tables, and what is read of them */
    int64_t pair_steps; /* that are left */
    mt_positions *positions;
} mt_position_job;

/* ---- pairs --------------------------------------------------------------------------------------------- */

static mt_status pair_source(const mt_position_source *source, const mt_feature_part *part, mt_arena *arena,
                             mt_pair_source *made) {
    if (part->kern_table) return mt_pair_source_kern(source->kern, source->scale, arena, made);
    return mt_pair_source_gpos(&source->layout, part->lookups, part->count, &source->variations,
                               source->scale, arena, made);
}

/* What each font's lookups make of a feature. */
static mt_status pair_sources(mt_position_job *job, const mt_feature_job *feature, mt_pair_source own[2]) {
    mt_status status = MT_OK;
    for (int s = 0; s < 2 && status == MT_OK; s++)
        status = pair_source(&job->sources[s], &feature->parts[s], &job->scratch, &own[s]);
    return status;
}

/* Each font's pairs alone; what is too large even so is left out. */
static mt_status prepare_apart(const mt_pair_source own[2], mt_position_job *job,
                               mt_pair_position *position) {
    static const mt_pair_source none;
    mt_status status = MT_OK;
    for (int s = 0; s < 2 && status == MT_OK; s++) {
        status = mt_pairs_prepare(s == 0 ? &own[0] : &none, s == 1 ? &own[1] : &none, job->charset,
                                  MT_PAIR_CELLS_MAX, &job->pair_steps, job->arena,
                                  &position->pairs[position->count]);
        if (status == MT_OK) position->count++;
        if (status == MT_TOO_LARGE) status = MT_OK;
    }
    return status;
}

enum { TOGETHER_MAX = 1 << 19 }; /* cells: a megabyte where only advances change */

static mt_status prepare_pairs(mt_position_job *job, const mt_feature_job *feature,
                               mt_pair_position *position) {
    mt_pair_source own[2];
    *position = (mt_pair_position){.head = feature->head};
    mt_status status = pair_sources(job, feature, own);
    if (status == MT_OK)
        status = mt_pairs_prepare(&own[0], &own[1], job->charset, TOGETHER_MAX, &job->pair_steps, job->arena,
                                  &position->pairs[0]);
    position->count = status == MT_OK;
    return status == MT_TOO_LARGE ? prepare_apart(own, job, position) : status;
}

static mt_status prepare_all_pairs(mt_position_job *job) {
    mt_positions *positions = job->positions;
    mt_feature_jobs found;
    mt_status status =
        mt_feature_jobs_find(job->features, &positions->systems, MT_LOOKUP_PAIR, job->arena, &found);
    if (status != MT_OK) return status;
    positions->pairs = mt_arena_new(job->arena, (size_t)found.count + 1, sizeof *positions->pairs);
    if (!positions->pairs) return MT_NO_MEMORY;
    for (int i = 0; i < found.count && status == MT_OK; i++)
        status = prepare_pairs(job, &found.list[i], &positions->pairs[positions->pair_count++]);
    return status;
}

/* The system that Latin text is set by: latn's, else DFLT's, else the first. */
static int plain_system(const mt_systems *systems) {
    static const uint32_t scripts[] = {MT_TAG('l', 'a', 't', 'n'), MT_TAG('D', 'F', 'L', 'T')};
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < systems->count; i++)
            if (systems->list[i].script == scripts[k] && systems->list[i].language == MT_LANGUAGE_DEFAULT)
                return i;
    return 0;
}

/* Kerning that is too large is left out. */
static mt_status prepare_plain_kerning(mt_position_job *job) {
    mt_feature_job feature;
    mt_pair_source own[2];
    mt_positions *positions = job->positions;
    mt_status status =
        mt_feature_job_whole(job->features, &positions->systems, plain_system(&positions->systems),
                             MT_TAG('k', 'e', 'r', 'n'), MT_LOOKUP_PAIR, job->arena, &feature);
    if (status == MT_OK) status = pair_sources(job, &feature, own);
    if (status == MT_OK)
        status = mt_pairs_prepare(&own[0], &own[1], job->charset, MT_PAIR_CELLS_MAX, &job->pair_steps,
                                  job->arena, &positions->plain_kerning);
    positions->has_plain_kerning = status == MT_OK;
    return status == MT_TOO_LARGE ? MT_OK : status;
}

/* ---- single adjustments -------------------------------------------------------------------------------- */

/* One that is too large, which no font's is, is left out. */
static mt_status prepare_single(mt_position_job *job, const mt_feature_job *feature) {
    mt_single_source own[2];
    for (int s = 0; s < 2; s++)
        own[s] =
            (mt_single_source){&job->sources[s].layout, &job->sources[s].variations, job->sources[s].scale,
                               feature->parts[s].count, feature->parts[s].lookups};
    mt_single_position *position = &job->positions->singles[job->positions->single_count];
    position->head = feature->head;
    mt_status status = mt_singles_prepare(&own[0], &own[1], job->charset, job->arena, &position->singles);
    job->positions->single_count += status == MT_OK;
    return status == MT_TOO_LARGE ? MT_OK : status;
}

static mt_status prepare_singles(mt_position_job *job) {
    mt_positions *positions = job->positions;
    mt_feature_jobs found;
    mt_status status =
        mt_feature_jobs_find(job->features, &positions->systems, MT_LOOKUP_SINGLE, job->arena, &found);
    if (status != MT_OK) return status;
    positions->singles = mt_arena_new(job->arena, (size_t)found.count + 1, sizeof *positions->singles);
    if (!positions->singles) return MT_NO_MEMORY;
    for (int i = 0; i < found.count && status == MT_OK; i++) status = prepare_single(job, &found.list[i]);
    return status;
}

/* ---- all ----------------------------------------------------------------------------------------------- */

static mt_status prepare_anchors(mt_position_job *job, int units) {
    mt_anchor_source own[2];
    for (int s = 0; s < 2; s++)
        own[s] =
            (mt_anchor_source){job->sources[s].font, &job->sources[s].layout, &job->sources[s].variations};
    return mt_anchors_prepare(&own[0], &own[1], &job->positions->systems, job->charset, units, job->arena,
                              &job->positions->anchors);
}

static mt_status prepare(mt_position_job *job, mt_font *fonts[2], int units) {
    mt_status status = MT_OK;
    for (int s = 0; s < 2 && status == MT_OK; s++) {
        mt_position_source *source = &job->sources[s];
        status = open_source(fonts[s], units, &job->scratch, source);
        job->features[s] = (mt_feature_source){&source->layout, mt_kern_table_kerns(source->kern)};
    }
    if (status == MT_OK)
        status = mt_systems_make(&job->sources[0].layout, &job->sources[1].layout, job->arena,
                                 &job->positions->systems);
    if (status == MT_OK) status = prepare_all_pairs(job);
    if (status == MT_OK) status = prepare_plain_kerning(job);
    if (status == MT_OK) status = prepare_singles(job);
    return status == MT_OK ? prepare_anchors(job, units) : status;
}

mt_status mt_positions_prepare(mt_font *a, mt_font *b, const mt_charset *charset, int units, mt_arena *arena,
                               mt_positions **positions) {
    mt_font *fonts[] = {a, b};
    mt_position_job job = {.charset = charset, .arena = arena, .pair_steps = MT_PAIR_STEPS_MAX};
    job.positions = mt_arena_new(arena, 1, sizeof *job.positions);
    if (!job.positions) return MT_NO_MEMORY;
    mt_status status = prepare(&job, fonts, units);
    mt_arena_release(&job.scratch);
    if (status == MT_OK) *positions = job.positions;
    return status;
}

/* ---- writing ------------------------------------------------------------------------------------------- */

static mt_status write_pairs(const mt_pair_position *position, double t, mt_arena *scratch,
                             mt_made_lookups *made) {
    mt_status status = MT_OK;
    for (int i = 0; i < position->count && status == MT_OK; i++) {
        mt_made_lookup lookup = position->head;
        mt_mixed_pairs mixed;
        mt_bytes *subtables;
        status = mt_pairs_mix(&position->pairs[i], t, scratch, &mixed);
        if (status == MT_OK) status = mt_pairs_write(&mixed, scratch, &subtables, &lookup.subtable_count);
        if (status != MT_OK) return status;
        lookup.subtables = subtables;
        status = mt_made_add(made, &lookup, scratch);
    }
    return status;
}

static mt_status write_singles(const mt_single_position *position, double t, mt_arena *scratch,
                               mt_made_lookups *made) {
    mt_made_lookup lookup = position->head;
    mt_bytes *subtables;
    mt_status status = mt_singles_write(&position->singles, t, scratch, &subtables, &lookup.subtable_count);
    lookup.subtables = subtables;
    return status == MT_OK ? mt_made_add(made, &lookup, scratch) : status;
}

mt_status mt_positions_write(const mt_positions *positions, double t, mt_arena *arena, mt_bytes *gpos) {
    mt_arena scratch = {0};
    mt_made_lookups made = {0};
    mt_status status = MT_OK;
    for (int i = 0; i < positions->pair_count && status == MT_OK; i++)
        status = write_pairs(&positions->pairs[i], t, &scratch, &made);
    for (int i = 0; i < positions->single_count && status == MT_OK; i++)
        status = write_singles(&positions->singles[i], t, &scratch, &made);
    if (status == MT_OK) status = mt_anchors_write(&positions->anchors, t, &scratch, &made);
    if (status == MT_OK) status = mt_gpos_write(&positions->systems, &made, arena, gpos);
    mt_arena_release(&scratch);
    return status;
}
