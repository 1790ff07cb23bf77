/* The report of two fonts: every glyph measured, the worst first; written to a file. */
#include "report/report.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* ---- the report ---------------------------------------------------------------------------------------- */

/* Those of characters, by code point, before those of none, by number. */
static int by_name(const mt_pairing *x, const mt_pairing *y) {
    uint32_t in_x = x->mapped ? x->code_point : x->a, in_y = y->mapped ? y->code_point : y->a;
    if (x->mapped != y->mapped) return x->mapped ? -1 : 1;
    return (in_x > in_y) - (in_x < in_y);
}

int mt_report_worst_first(const void *p, const void *q) {
    const mt_report_glyph *x = p, *y = q;
    if (x->severity != y->severity) return x->severity > y->severity ? -1 : 1;
    return by_name(&x->of, &y->of);
}

static void summarise(mt_report *report) {
    mt_report_summary *sum = &report->summary;
    for (int i = 0; i < report->count; i++) {
        const mt_report_glyph *glyph = &report->glyphs[i];
        bool failed = glyph->status != MT_OK;
        sum->flagged += glyph->flags != 0;
        sum->failed += failed;
        if (!failed) sum->methods[glyph->method]++;
        sum->proved += report->glyphs[i].proved;
        sum->in_range += mt_report_counts_in_range(glyph);
        sum->ink_near += mt_report_ink_in_range(glyph);
    }
}

/* The measured glyphs out of all, and those without a partner. */
static mt_status collect(const mt_making *making, const mt_report_figures *figures, mt_report *report) {
    const mt_charset *charset = &making->set.charset;
    report->glyphs = mt_new((size_t)making->glyph_count, sizeof *report->glyphs);
    report->unblended = mt_new((size_t)charset->unblended_count, sizeof *report->unblended);
    if (!report->glyphs || !report->unblended) return MT_NO_MEMORY;
    for (int i = 0; i < making->glyph_count; i++) {
        if (figures->steps[0][i].measured) report->glyphs[report->count++] = figures->steps[0][i];
        if (charset->glyphs[i].b == MT_NO_PARTNER)
            report->unblended[report->unblended_count++] = charset->glyphs[i];
    }
    if (report->count)
        qsort(report->glyphs, (size_t)report->count, sizeof *report->glyphs, mt_report_worst_first);
    summarise(report);
    return MT_OK;
}

mt_status mt_report_make(mt_row *row, mt_report *report) {
    mt_report made = {.row = row};
    mt_report_figures figures = {.reach = true};
    mt_making making = {.sinks = {mt_report_sink(&figures)}, .sink_count = 1};
    mt_charset_request request = mt_row_request(row);
    request.set = MT_GLYPHS_BOTH;
    mt_status status = mt_making_begin(&making, row, &request);
    if (status == MT_OK) status = mt_making_run(&making);
    if (status == MT_OK) status = collect(&making, &figures, &made);
    if (status == MT_OK) status = mt_naming_open(row->fonts[0], &made.naming);
    mt_report_figures_free(&figures);
    mt_making_end(&making);
    if (status == MT_OK)
        *report = made;
    else
        mt_report_free(&made);
    return status;
}

void mt_report_free(mt_report *report) {
    mt_free(report->glyphs);
    mt_free(report->unblended);
    mt_naming_close(report->naming);
    *report = (mt_report){0};
}

/* ---- the format ---------------------------------------------------------------------------------------- */

mt_status mt_report_format_of(const char *path, mt_report_format *format) {
    const char *dot = strrchr(path, '.');
    bool html = dot && strcasecmp(dot, ".html") == 0, json = dot && strcasecmp(dot, ".json") == 0;
    if (!html && !json) return MT_UNKNOWN_FORMAT;
    *format = html ? MT_REPORT_HTML : MT_REPORT_JSON;
    return MT_OK;
}
