#include "math/job.h"

#include "math/table/open.h"

/* As many as one source may have; several new glyphs that are one of the first font's have rows of their own. */
enum { ROWS_MAX = MT_MATH_RECORDS_MAX };

bool mt_math_spend(mt_math_job *job, int count) {
    bool enough = count <= job->rows_left;
    job->rows_left = enough ? job->rows_left - count : 0;
    return enough;
}

double *mt_math_new_row(const mt_math_job *job) {
    return mt_arena_new(job->arena, (size_t)job->font_count, sizeof(double));
}

/* ---- the fonts ----------------------------------------------------------------------------------------- */

static mt_status open_source(mt_math_job *job, mt_font *const *fonts, int index) {
    mt_math_source *source = &job->sources[index];
    source->font = fonts[index];
    source->scale = (double)job->units / mt_font_units_per_em(fonts[index]);
    mt_status status = mt_math_table_open(fonts[index], &job->scratch, &source->table);
    if (status != MT_OK || index == 0) return status;
    return mt_outline_moves_open(fonts[0], fonts[index], &job->glyphs, index, job->units, &job->scratch,
                                 &source->moves);
}

static void close_sources(mt_math_job *job) {
    for (int i = 1; job->sources && i < job->font_count; i++)
        mt_arena_release(&job->sources[i].moves.scratch);
    mt_arena_release(&job->scratch);
}

/* Of several new glyphs that are one of the first font's, its number is the first. */
static mt_status number_glyphs(mt_math_job *job, int count) {
    job->numbers = mt_arena_new(&job->scratch, (size_t)count + 1, sizeof *job->numbers);
    if (!job->numbers) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) job->numbers[i] = -1;
    for (int i = job->glyphs.glyph_count - 1; i >= 0; i--)
        if (job->glyphs.of[0][i] < (uint32_t)count) job->numbers[job->glyphs.of[0][i]] = i;
    return MT_OK;
}

/* ---- what is of no glyph ------------------------------------------------------------------------------- */

/* Percentages are of no units. */
static bool is_percent(int constant) {
    return constant < MT_MATH_PERCENTS || constant == MT_MATH_LAST_PERCENT;
}

static mt_status prepare_constants(mt_math_job *job) {
    const mt_math_source *sources = job->sources;
    job->math->has_constants = sources[0].table.has_constants;
    for (int i = 0; i < MT_MATH_CONSTANTS; i++) {
        double *row = mt_math_new_row(job);
        if (!row) return MT_NO_MEMORY;
        for (int k = 0; k < job->font_count; k++) {
            const mt_math_source *from = &sources[sources[k].table.has_constants ? k : 0];
            row[k] = from->table.constants[i] * (is_percent(i) ? 1 : from->scale);
        }
        job->math->constants[i] = row;
    }
    return MT_OK;
}

/* A font whose table has no glyphs that grow has no overlap to tell. */
static bool has_growths(const mt_math_table *table) {
    return table->constructions[MT_MATH_VERTICAL].count || table->constructions[MT_MATH_HORIZONTAL].count;
}

static mt_status prepare_overlap(mt_math_job *job) {
    double *row = mt_math_new_row(job);
    if (!row) return MT_NO_MEMORY;
    for (int k = 0; k < job->font_count; k++) {
        const mt_math_source *from = &job->sources[has_growths(&job->sources[k].table) ? k : 0];
        row[k] = from->table.least_overlap * from->scale;
    }
    job->math->least_overlap = row;
    return MT_OK;
}

/* ---- all of it ----------------------------------------------------------------------------------------- */

static mt_status prepare(mt_math_job *job, mt_font *const *fonts) {
    mt_status status = open_source(job, fonts, 0);
    if (status != MT_OK || job->sources[0].table.state != MT_MATH_WHOLE) return status;
    for (int i = 1; i < job->font_count && status == MT_OK; i++) status = open_source(job, fonts, i);
    job->math = mt_arena_new(job->arena, 1, sizeof *job->math);
    if (!job->math) return MT_NO_MEMORY;
    if (status == MT_OK) status = number_glyphs(job, mt_font_glyph_count(fonts[0]));
    if (status == MT_OK) status = prepare_constants(job);
    if (status == MT_OK) status = prepare_overlap(job);
    if (status == MT_OK) status = mt_math_prepare_info(job);
    return status == MT_OK ? mt_math_prepare_growths(job) : status;
}

mt_status mt_math_prepare(mt_font *const *fonts, const mt_font_glyphs *glyphs, int units, mt_arena *arena,
                          mt_math **math) {
    mt_math_job job = {.font_count = glyphs->font_count,
                       .glyphs = *glyphs,
                       .units = units,
                       .rows_left = ROWS_MAX,
                       .arena = arena};
    job.sources = mt_arena_new(&job.scratch, (size_t)job.font_count, sizeof *job.sources);
    mt_status status = job.sources ? prepare(&job, fonts) : MT_NO_MEMORY;
    close_sources(&job);
    if (status == MT_OK) *math = job.math;
    return status;
}
