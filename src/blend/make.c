/* The fonts of a blend: the glyphs that they have, all of them made, and each font as data. */
#include "blend/job.h"

#include "blend/metadata.h"
#include "glyphset/new_names.h"
#include "sfnt/sfnt.h"
#include "source/glyph_names.h"

/* ---- one font ------------------------------------------------------------------------------------------ */

void mt_add_extra(mt_font_data *data, uint32_t tag, mt_bytes table) {
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
    mt_add_extra(data, MT_TAG('G', 'P', 'O', 'S'), gpos);
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
    mt_add_extra(&data, MT_TAG('G', 'S', 'U', 'B'), job->layout.gsub);
    mt_add_extra(&data, MT_TAG('G', 'D', 'E', 'F'), job->layout.gdef);
    mt_status status =
        mt_metadata_fill(job->blend->a, job->blend->b, job->t[i], job->blend->family, arena, &data);
    if (status == MT_OK) status = add_positions(job, job->t[i], arena, &data);
    return status == MT_OK ? job->ready(&data, i, job->user) : status;
}

static mt_status hand_over_all(const mt_job *job, mt_arena *arena) {
    mt_status status = MT_OK;
    for (int i = 0; i < job->t_count && status == MT_OK; i++) status = hand_over(job, i, arena);
    return status;
}

/* ---- all of them --------------------------------------------------------------------------------------- */

mt_status mt_job_layout(mt_job *job, mt_arena *arena) {
    const mt_charset *charset = job->charset;
    uint16_t *kept = mt_arena_new(arena, (size_t)charset->primary_count, sizeof *kept);
    if (!kept) return MT_NO_MEMORY;
    for (int i = 0; i < charset->primary_count; i++) kept[i] = (uint16_t)charset->glyphs[i].a;
    mt_status status = mt_gsub_subset(job->blend->a, kept, charset->primary_count, arena, &job->layout);
    if (status == MT_OK) status = mt_charset_twins(charset, arena, &job->layout);
    if (status != MT_OK) return status;
    return mt_glyph_names_make(job->blend->a, charset, arena, &job->glyph_names);
}

mt_status mt_job_start(mt_job *job, mt_arena *arena) {
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
    mt_job_order(job);
    return MT_OK;
}

static mt_status make_fonts(mt_job *job, mt_arena *arena) {
    mt_charset charset;
    mt_blend *blend = job->blend;
    mt_charset_request request = {blend->wanted, blend->wanted_count, blend->set};
    mt_status status = mt_charset_make(blend->a, blend->b, &request, arena, &charset);
    job->charset = &charset;
    if (status == MT_OK) status = mt_job_start(job, arena);
    if (status == MT_OK) status = mt_job_layout(job, arena);
    if (status == MT_OK)
        status = mt_positions_prepare((mt_font *[]){blend->a, blend->b}, job->charset, 2, job->units, arena,
                                      &job->positions);
    if (status != MT_OK) return status;
    int count = mt_job_worker_count(job);
    mt_worker *workers = mt_arena_new(arena, (size_t)count, sizeof *workers);
    if (!workers) return MT_NO_MEMORY;
    status = mt_job_run(job, workers, count);
    if (status == MT_OK) status = hand_over_all(job, arena);
    for (int i = 0; i < count; i++) mt_arena_release(&workers[i].kept);
    return status;
}

mt_status mt_blend_make(mt_blend *blend, const double *t, int count, mt_font_ready ready, void *user) {
    for (int i = 0; i < count; i++)
        if (!mt_is_place(t[i])) return MT_BAD_PARAMETER;
    mt_arena arena = {0};
    mt_job job = {.blend = blend,
                  .make = mt_job_glyph,
                  .t = t,
                  .t_count = count,
                  .units = mt_blend_units_per_em(blend),
                  .ready = ready,
                  .user = user};
    mt_status status = make_fonts(&job, &arena);
    mt_arena_release(&arena);
    return status;
}
