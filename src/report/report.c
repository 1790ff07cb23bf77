/* The report of two fonts: every glyph measured, on threads; the worst first; written to a file. */
#include "report/report.h"

#include "base/file.h"
#include "base/workers.h"
#include "blend/metadata.h"
#include "glyphset/charset.h"
#include "morph/model/params.h"
#include "morph/prepare.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* ---- measuring ----------------------------------------------------------------------------------------- */

typedef struct mt_report_job {
    const mt_report_request *request;
    mt_report_glyph *glyphs;
    int units;             /* per em of the font that a blend would be */
    pthread_mutex_t fonts; /* FreeType's faces are not for two threads at once */
} mt_report_job;

mt_status mt_report_prepare(const mt_report_request *request, pthread_mutex_t *fonts, uint32_t code_point,
                            mt_arena *arena, mt_glyph_pair *pair) {
    double tolerance = request->params->tolerance;
    *pair = (mt_glyph_pair){0};
    pthread_mutex_lock(fonts);
    uint32_t a = mt_font_glyph(request->a, code_point), b = mt_font_glyph(request->b, code_point);
    mt_status in_a = mt_glyph_shape(request->a, a, tolerance, arena, &pair->a, &pair->advance_a);
    mt_status in_b = mt_glyph_shape(request->b, b, tolerance, arena, &pair->b, &pair->advance_b);
    pthread_mutex_unlock(fonts);
    mt_hints hints = mt_hint_index_find(request->hints, a, b);
    if (in_a != MT_OK || in_b != MT_OK) return in_a != MT_OK ? in_a : in_b;
    return mt_morph_prepare(&pair->a, &pair->b, &hints, request->params, arena, &pair->morph);
}

/* A task; a glyph that fails is a finding, and no failure of the report. */
static mt_status measure_one(int index, mt_arena *scratch, void *user) {
    mt_report_job *job = user;
    mt_report_glyph *glyph = &job->glyphs[index];
    mt_glyph_pair pair;
    mt_status status = mt_report_prepare(job->request, &job->fonts, glyph->code_point, scratch, &pair);
    if (status == MT_OK) status = mt_report_measure(&pair, job->request->params, job->units, scratch, glyph);
    if (status == MT_NO_MEMORY) return status;
    glyph->status = status;
    mt_report_judge(glyph);
    return MT_OK;
}

static mt_status measure_all(mt_report *report) {
    const mt_report_request *request = &report->request;
    mt_report_job job = {
        .request = request, .glyphs = report->glyphs, .units = mt_metadata_units(request->a, request->b)};
    mt_work work = {.count = report->count,
                    .task = measure_one,
                    .user = &job,
                    .threads = request->params->threads,
                    .progress = request->progress,
                    .progress_user = request->user};
    pthread_mutex_init(&job.fonts, NULL);
    mt_status status = mt_work_run(&work);
    pthread_mutex_destroy(&job.fonts);
    return status;
}

/* ---- the report ---------------------------------------------------------------------------------------- */

/* The glyphs to measure: all of the blend's that characters lead to. */
static mt_status list_glyphs(const mt_report_request *request, mt_report *report) {
    mt_arena arena = {0};
    mt_charset charset;
    mt_charset_request wanted = {request->code_points, request->count, MT_GLYPHS_BOTH};
    mt_status status = mt_charset_make(request->a, request->b, &wanted, &arena, &charset);
    if (status == MT_OK) {
        report->glyphs = mt_new((size_t)charset.glyph_count, sizeof *report->glyphs);
        if (!report->glyphs) status = MT_NO_MEMORY;
    }
    for (int i = 0; status == MT_OK && i < charset.glyph_count; i++)
        if (charset.glyphs[i].mapped)
            report->glyphs[report->count++].code_point = charset.glyphs[i].code_point;
    mt_arena_release(&arena);
    return status;
}

static int worst_first(const void *p, const void *q) {
    const mt_report_glyph *x = p, *y = q;
    if ((x->flags != 0) != (y->flags != 0)) return x->flags ? -1 : 1;
    if (x->severity != y->severity) return x->severity > y->severity ? -1 : 1;
    return (x->code_point > y->code_point) - (x->code_point < y->code_point);
}

static void summarise(mt_report *report) {
    mt_report_summary *sum = &report->summary;
    for (int i = 0; i < report->count; i++) {
        const mt_report_glyph *glyph = &report->glyphs[i];
        bool failed = glyph->status != MT_OK;
        sum->flagged += glyph->flags != 0;
        sum->failed += failed;
        if (!failed) sum->methods[glyph->method]++;
        sum->in_range += !failed && !(glyph->flags & (MT_FLAG_COMPONENTS | MT_FLAG_HOLES));
        sum->ink_near += !failed && !(glyph->flags & MT_FLAG_INK);
    }
}

mt_status mt_report_make(const mt_report_request *request, mt_report *report) {
    mt_report made = {.request = *request};
    mt_status status = mt_params_check(request->params);
    if (status == MT_OK) status = list_glyphs(request, &made);
    if (status == MT_OK) status = measure_all(&made);
    if (status != MT_OK) {
        mt_report_free(&made);
        return status;
    }
    qsort(made.glyphs, (size_t)made.count, sizeof *made.glyphs, worst_first);
    summarise(&made);
    *report = made;
    return MT_OK;
}

void mt_report_free(mt_report *report) {
    mt_free(report->glyphs);
    report->glyphs = NULL;
}

/* ---- the file ------------------------------------------------------------------------------------------ */

mt_status mt_report_format_of(const char *path, mt_report_format *format) {
    const char *dot = strrchr(path, '.');
    bool html = dot && strcasecmp(dot, ".html") == 0, json = dot && strcasecmp(dot, ".json") == 0;
    if (!html && !json) return MT_UNKNOWN_FORMAT;
    *format = html ? MT_REPORT_HTML : MT_REPORT_JSON;
    return MT_OK;
}

mt_status mt_report_save(const mt_report_request *request, const char *path) {
    mt_report_format format;
    mt_report report;
    mt_buffer text = {0};
    mt_status status = mt_report_format_of(path, &format);
    if (status == MT_OK) status = mt_report_make(request, &report);
    if (status != MT_OK) return status;
    status = format == MT_REPORT_HTML ? mt_report_html(&report, &text) : mt_report_json(&report, &text);
    if (status == MT_OK) status = mt_file_write(path, text.bytes, text.length);
    mt_buffer_free(&text);
    mt_report_free(&report);
    return status;
}
