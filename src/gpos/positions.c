#include "gpos/positions.h"

#include "anchors/anchors.h"
#include "anchors/write.h"
#include "gpos/contexts.h"
#include "gpos/gpos.h"
#include "gpos/position_data.h"
#include "kerning/kern_table.h"
#include "kerning/prepare.h"
#include "kerning/write.h"
#include "layout/at_place.h"
#include "layout/open.h"
#include "layout/tidy.h"
#include "sfnt/sfnt.h"

/* ---- the fonts ----------------------------------------------------------------------------------------- */

typedef struct mt_position_source {
    mt_font *font;
    mt_bytes kern;
    mt_layout layout;
    mt_gdef_deltas variations;
    double scale; /* units of the new font in one of this font's */
} mt_position_source;

/* GPOS, with the features that hold at the font's place on its axes, and without what other readers would refuse it for. */
static mt_status read_gpos(mt_font *font, mt_bytes gdef, mt_arena *arena, mt_bytes *gpos) {
    const int32_t *place;
    int axes = mt_font_place(font, &place);
    mt_bytes placed = {0};
    mt_status status = mt_font_table(font, MT_TAG('G', 'P', 'O', 'S'), arena, gpos);
    bool varies = axes > 0 && mt_ot_u16(*gpos, 2) > 0;
    if (status == MT_OK && varies) status = mt_layout_place(*gpos, place, axes, arena, &placed);
    if (placed.length) *gpos = placed;
    uint8_t *own = (uint8_t *)gpos->bytes; /* in the arena */
    if (status != MT_OK || !gpos->length) return status;
    return mt_tidy_lookups(own, gpos->length, MT_EXTENSION_GPOS, gdef, arena);
}

static mt_status open_source(mt_font *font, int units, mt_arena *arena, mt_position_source *source) {
    mt_bytes gpos, gdef;
    const int32_t *place;
    int axes = mt_font_place(font, &place);
    *source = (mt_position_source){.font = font, .scale = (double)units / mt_font_units_per_em(font)};
    mt_status status = mt_font_table(font, MT_TAG('G', 'D', 'E', 'F'), arena, &gdef);
    if (status == MT_OK) status = read_gpos(font, gdef, arena, &gpos);
    if (status == MT_OK) status = mt_font_kern(font, arena, &source->kern);
    if (status == MT_OK) status = mt_layout_open(gpos, MT_EXTENSION_GPOS, arena, &source->layout);
    if (status == MT_OK) status = mt_gdef_deltas_open(gdef, place, axes, arena, &source->variations);
    return status;
}

/* What the parts of the preparation share. */
typedef struct mt_position_job {
    mt_position_source sources[MT_STOPS_MAX];
    mt_feature_sources features;
    mt_font_glyphs glyphs; /* for each composed one, the glyph that it stands in a line like */
    mt_arena *arena;
    mt_arena scratch;   /* of the tables, and what is read of them */
    int64_t pair_steps; /* that are left */
    mt_called_lookups called;
    mt_positions *positions;
} mt_position_job;

/* Of a lookup that contexts call. */
static mt_lookup_builder called_head(const mt_position_job *job, const mt_called_lookup *called) {
    mt_lookup_builder head =
        mt_context_head(&job->sources[called->font].layout, called->font, called->in_fonts[called->font]);
    head.order = MT_CALLED_ORDER + called->called_as;
    head.called_as = called->called_as;
    return head;
}

static int count_called(const mt_position_job *job, int type) {
    int count = 0;
    for (int i = 0; i < job->called.count; i++) count += job->called.list[i].type == type;
    return count;
}

/* ---- pairs --------------------------------------------------------------------------------------------- */

static mt_status pair_source(const mt_position_source *source, const mt_feature_part *part, mt_arena *arena,
                             mt_pair_source *made) {
    if (part->kern_table) return mt_pair_source_kern(source->kern, source->scale, arena, made);
    return mt_pair_source_gpos(&source->layout, part->lookups, part->count, &source->variations,
                               source->scale, arena, made);
}

/* What each font's lookups make of a feature. */
static mt_status pair_sources(mt_position_job *job, const mt_feature_job *feature, mt_pair_source *own) {
    mt_status status = MT_OK;
    for (int s = 0; s < job->glyphs.font_count && status == MT_OK; s++)
        status = pair_source(&job->sources[s], &feature->parts[s], &job->scratch, &own[s]);
    return status;
}

static mt_status prepare_together(const mt_pair_source *own, int most, mt_position_job *job,
                                  mt_pairs *pairs) {
    const mt_pair_source *sources[MT_STOPS_MAX];
    for (int s = 0; s < job->glyphs.font_count; s++) sources[s] = &own[s];
    return mt_pairs_prepare(sources, &job->glyphs, most, &job->pair_steps, job->arena, pairs);
}

/* Each font's pairs alone; what is too large even so is left out. */
static mt_status prepare_apart(const mt_pair_source *own, mt_position_job *job, mt_pair_position *position) {
    static const mt_pair_source none;
    mt_status status = MT_OK;
    for (int s = 0; s < job->glyphs.font_count && status == MT_OK; s++) {
        const mt_pair_source *sources[MT_STOPS_MAX];
        for (int k = 0; k < job->glyphs.font_count; k++) sources[k] = k == s ? &own[s] : &none;
        status = mt_pairs_prepare(sources, &job->glyphs, MT_PAIR_CELLS_MAX, &job->pair_steps, job->arena,
                                  &position->pairs[position->count]);
        if (status == MT_OK) position->count++;
        if (status == MT_TOO_LARGE) status = MT_OK;
    }
    return status;
}

enum { TOGETHER_MAX = 1 << 19 }; /* cells: a megabyte where only advances change */

/* Whether the classes of several fonts together come to more values than the fonts' own do: those that refine one another
 * multiply. Two fonts' are kept together all the same, so that a value between them is rounded once. */
static bool is_better_apart(const mt_pairs *pairs) {
    int64_t together = (int64_t)pairs->left.count * pairs->right.count, apart = 0;
    for (int s = 0; s < pairs->font_count; s++)
        apart += (int64_t)pairs->fonts[s].rows * pairs->fonts[s].columns;
    return pairs->font_count > 2 && together > apart;
}

static mt_status prepare_pairs(mt_position_job *job, const mt_feature_job *feature,
                               mt_pair_position *position) {
    mt_pair_source own[MT_STOPS_MAX];
    *position = (mt_pair_position){.head = feature->head};
    position->pairs = mt_arena_new(job->arena, (size_t)job->glyphs.font_count, sizeof *position->pairs);
    if (!position->pairs) return MT_NO_MEMORY;
    mt_status status = pair_sources(job, feature, own);
    if (status == MT_OK) status = prepare_together(own, TOGETHER_MAX, job, &position->pairs[0]);
    bool large = status == MT_TOO_LARGE || (status == MT_OK && is_better_apart(&position->pairs[0]));
    if (large) return prepare_apart(own, job, position);
    position->count = status == MT_OK;
    return status;
}

/* What is too large, which no font's is, is left out. */
static mt_status prepare_called_pairs(mt_position_job *job, const mt_called_lookup *called) {
    mt_pair_source own[MT_STOPS_MAX] = {0};
    const mt_pair_source *sources[MT_STOPS_MAX];
    mt_pair_position *position = &job->positions->pairs[job->positions->pair_count];
    mt_status status = MT_OK;
    *position = (mt_pair_position){.head = called_head(job, called)};
    position->pairs = mt_arena_new(job->arena, 1, sizeof *position->pairs);
    if (!position->pairs) return MT_NO_MEMORY;
    for (int s = 0; s < job->glyphs.font_count && status == MT_OK; s++) {
        const int *lookup = &called->in_fonts[s];
        const mt_position_source *source = &job->sources[s];
        sources[s] = &own[s];
        if (*lookup >= 0)
            status = mt_pair_source_gpos(&source->layout, lookup, 1, &source->variations, source->scale,
                                         &job->scratch, &own[s]);
    }
    if (status == MT_OK)
        status = mt_pairs_prepare(sources, &job->glyphs, MT_PAIR_CELLS_MAX, &job->pair_steps, job->arena,
                                  position->pairs);
    position->count = status == MT_OK;
    job->positions->pair_count += status == MT_OK;
    return status == MT_TOO_LARGE ? MT_OK : status;
}

static mt_status prepare_all_pairs(mt_position_job *job) {
    mt_positions *positions = job->positions;
    mt_feature_jobs found;
    mt_status status =
        mt_feature_jobs_find(&job->features, &positions->systems, MT_LOOKUP_PAIR, job->arena, &found);
    if (status != MT_OK) return status;
    size_t room = (size_t)found.count + (size_t)count_called(job, MT_LOOKUP_PAIR) + 1;
    positions->pairs = mt_arena_new(job->arena, room, sizeof *positions->pairs);
    if (!positions->pairs) return MT_NO_MEMORY;
    for (int i = 0; i < found.count && status == MT_OK; i++)
        status = prepare_pairs(job, &found.list[i], &positions->pairs[positions->pair_count++]);
    for (int i = 0; i < job->called.count && status == MT_OK; i++)
        if (job->called.list[i].type == MT_LOOKUP_PAIR)
            status = prepare_called_pairs(job, &job->called.list[i]);
    return status;
}

/* The system that Latin text is set by: the first of those that are nearest. */
static int plain_system(const mt_systems *systems) {
    int best = 0;
    for (int i = 1; i < systems->count; i++) {
        const mt_shared_system *nearest = &systems->list[best], *other = &systems->list[i];
        if (mt_latin_rank(other->script, other->language) < mt_latin_rank(nearest->script, nearest->language))
            best = i;
    }
    return best;
}

/* Kerning that is too large is left out. */
static mt_status prepare_plain_kerning(mt_position_job *job) {
    mt_feature_job feature;
    mt_pair_source own[MT_STOPS_MAX];
    mt_positions *positions = job->positions;
    mt_status status =
        mt_feature_job_whole(&job->features, &positions->systems, plain_system(&positions->systems),
                             MT_TAG('k', 'e', 'r', 'n'), MT_LOOKUP_PAIR, job->arena, &feature);
    if (status == MT_OK) status = pair_sources(job, &feature, own);
    if (status == MT_OK) status = prepare_together(own, MT_PAIR_CELLS_MAX, job, &positions->plain_kerning);
    positions->has_plain_kerning = status == MT_OK;
    return status == MT_TOO_LARGE ? MT_OK : status;
}

/* ---- single adjustments -------------------------------------------------------------------------------- */

static mt_single_source single_source(const mt_position_source *source, int count, const int *lookups) {
    return (mt_single_source){&source->layout, &source->variations, source->scale, count, lookups};
}

/* One that is too large, which no font's is, is left out. */
static mt_status add_single(mt_position_job *job, const mt_lookup_builder *head, const mt_single_source *own,
                            int caller) {
    mt_single_position *position = &job->positions->singles[job->positions->single_count];
    position->head = *head;
    mt_status status = mt_singles_prepare(own, caller, &job->glyphs, job->arena, &position->singles);
    job->positions->single_count += status == MT_OK;
    return status == MT_TOO_LARGE ? MT_OK : status;
}

static mt_status prepare_single(mt_position_job *job, const mt_feature_job *feature) {
    mt_single_source own[MT_STOPS_MAX];
    for (int s = 0; s < job->glyphs.font_count; s++)
        own[s] = single_source(&job->sources[s], feature->parts[s].count, feature->parts[s].lookups);
    return add_single(job, &feature->head, own, MT_NO_CALLER);
}

static mt_status prepare_called_single(mt_position_job *job, const mt_called_lookup *called) {
    mt_single_source own[MT_STOPS_MAX];
    mt_lookup_builder head = called_head(job, called);
    for (int s = 0; s < job->glyphs.font_count; s++) {
        const int *lookup = &called->in_fonts[s];
        own[s] = single_source(&job->sources[s], *lookup >= 0, lookup);
    }
    return add_single(job, &head, own, called->font);
}

static mt_status prepare_singles(mt_position_job *job) {
    mt_positions *positions = job->positions;
    mt_feature_jobs found;
    mt_status status =
        mt_feature_jobs_find(&job->features, &positions->systems, MT_LOOKUP_SINGLE, job->arena, &found);
    if (status != MT_OK) return status;
    size_t room = (size_t)found.count + (size_t)count_called(job, MT_LOOKUP_SINGLE) + 1;
    positions->singles = mt_arena_new(job->arena, room, sizeof *positions->singles);
    if (!positions->singles) return MT_NO_MEMORY;
    for (int i = 0; i < found.count && status == MT_OK; i++) status = prepare_single(job, &found.list[i]);
    for (int i = 0; i < job->called.count && status == MT_OK; i++)
        if (job->called.list[i].type == MT_LOOKUP_SINGLE)
            status = prepare_called_single(job, &job->called.list[i]);
    return status;
}

/* ---- all ----------------------------------------------------------------------------------------------- */

/* Anchors are those of the drawings themselves: a composed glyph has none. */
static mt_status prepare_anchors(mt_position_job *job, const mt_font_glyphs *drawn, int units) {
    mt_anchor_source own[MT_STOPS_MAX];
    for (int s = 0; s < job->glyphs.font_count; s++)
        own[s] =
            (mt_anchor_source){job->sources[s].font, &job->sources[s].layout, &job->sources[s].variations};
    return mt_anchors_prepare(own, &job->positions->systems, job->called.list, job->called.count, drawn,
                              units, job->arena, &job->positions->anchors);
}

static mt_status open_sources(mt_position_job *job, mt_font *const *fonts, int units) {
    mt_status status = MT_OK;
    job->features.count = job->glyphs.font_count;
    for (int s = 0; s < job->features.count && status == MT_OK; s++) {
        mt_position_source *source = &job->sources[s];
        status = open_source(fonts[s], units, &job->scratch, source);
        job->features.layouts[s] = &source->layout;
        job->features.kern_tables[s] = status == MT_OK && mt_kern_table_kerns(source->kern);
    }
    return status;
}

static mt_status list_line_glyphs(mt_position_job *job, mt_font *const *fonts, const mt_font_glyphs *drawn) {
    job->glyphs = *drawn;
    for (int s = 1; s < drawn->font_count; s++) {
        uint32_t *of = mt_arena_new(&job->scratch, (size_t)drawn->glyph_count, sizeof *of);
        if (!of) return MT_NO_MEMORY;
        for (int i = 0; i < drawn->glyph_count; i++) {
            const mt_composed *composed = mt_font_composed(fonts[s], drawn->of[s][i]);
            of[i] = composed ? composed->like : drawn->of[s][i];
        }
        job->glyphs.of[s] = of;
    }
    return MT_OK;
}

static mt_status prepare(mt_position_job *job, mt_font *const *fonts, const mt_font_glyphs *drawn,
                         int units) {
    mt_status status = list_line_glyphs(job, fonts, drawn);
    if (status == MT_OK) status = open_sources(job, fonts, units);
    if (status == MT_OK)
        status =
            mt_systems_make(job->features.layouts, job->features.count, job->arena, &job->positions->systems);
    if (status == MT_OK)
        status = mt_contexts_prepare(job->features.layouts, &job->positions->systems, &job->glyphs,
                                     job->arena, &job->positions->contexts, &job->called);
    if (status == MT_OK) status = prepare_all_pairs(job);
    if (status == MT_OK) status = prepare_plain_kerning(job);
    if (status == MT_OK) status = prepare_singles(job);
    return status == MT_OK ? prepare_anchors(job, drawn, units) : status;
}

mt_status mt_positions_prepare(mt_font *const *fonts, const mt_font_glyphs *glyphs, int units,
                               mt_arena *arena, mt_positions **positions) {
    mt_position_job job = {.arena = arena, .pair_steps = MT_PAIR_STEPS_MAX};
    job.positions = mt_arena_new(arena, 1, sizeof *job.positions);
    if (!job.positions) return MT_NO_MEMORY;
    job.positions->font_count = glyphs->font_count;
    mt_status status = prepare(&job, fonts, glyphs, units);
    mt_arena_release(&job.scratch);
    if (status == MT_OK) *positions = job.positions;
    return status;
}

/* ---- writing ------------------------------------------------------------------------------------------- */

static mt_status write_pairs(const mt_pair_position *position, const mt_places *places, mt_arena *scratch,
                             mt_lookup_builders *made) {
    mt_status status = MT_OK;
    for (int i = 0; i < position->count && status == MT_OK; i++) {
        mt_lookup_builder lookup = position->head;
        mt_mixed_pairs mixed;
        mt_bytes *subtables;
        status = mt_pairs_mix(&position->pairs[i], places, scratch, &mixed);
        if (status == MT_OK)
            status = mt_pairs_write(&mixed, places->store, scratch, &subtables, &lookup.subtable_count);
        if (status != MT_OK) return status;
        lookup.subtables = subtables;
        status = mt_lookup_builders_add(made, &lookup, scratch);
    }
    return status;
}

static mt_status write_singles(const mt_single_position *position, const mt_places *places, mt_arena *scratch,
                               mt_lookup_builders *made) {
    mt_lookup_builder lookup = position->head;
    mt_bytes *subtables;
    mt_status status =
        mt_singles_write(&position->singles, places, scratch, &subtables, &lookup.subtable_count);
    lookup.subtables = subtables;
    return status == MT_OK ? mt_lookup_builders_add(made, &lookup, scratch) : status;
}

static mt_status write_at(const mt_positions *positions, const mt_places *places, mt_arena *arena,
                          mt_bytes *gpos) {
    mt_arena scratch = {0};
    mt_lookup_builders made = {0};
    mt_status status = MT_OK;
    for (int i = 0; i < positions->pair_count && status == MT_OK; i++)
        status = write_pairs(&positions->pairs[i], places, &scratch, &made);
    for (int i = 0; i < positions->single_count && status == MT_OK; i++)
        status = write_singles(&positions->singles[i], places, &scratch, &made);
    if (status == MT_OK) status = mt_anchors_write(&positions->anchors, places, &scratch, &made);
    if (status == MT_OK) status = mt_contexts_write(&positions->contexts, &scratch, &made);
    if (status == MT_OK) status = mt_gpos_write(&positions->systems, &made, arena, gpos);
    mt_arena_release(&scratch);
    return status;
}

mt_status mt_positions_write(const mt_positions *positions, mt_font_at at, mt_arena *arena, mt_bytes *gpos) {
    mt_places places = mt_places_of_one(&at, positions->font_count);
    return write_at(positions, &places, arena, gpos);
}

mt_status mt_positions_write_varying(const mt_positions *positions, mt_var_store *store, mt_arena *arena,
                                     mt_bytes *gpos) {
    mt_at at[MT_STOPS_MAX];
    mt_places places = mt_places_of_fonts(at, store);
    return write_at(positions, &places, arena, gpos);
}
