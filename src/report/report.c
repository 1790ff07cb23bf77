/* The report of two fonts: every glyph measured, the worst first; written to a file. */
#include "report/report.h"

#include "base/file.h"

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

static mt_status make(mt_row *row, mt_report *made) {
    mt_report_figures figures = {.reach = true};
    mt_making making = {.sinks = {mt_report_sink(&figures)}, .sink_count = 1};
    mt_charset_request request = mt_row_request(row);
    request.set = MT_GLYPHS_BOTH;
    made->row = row;
    mt_status status = mt_making_begin(&making, row, &request);
    if (status == MT_OK) status = mt_making_run(&making);
    if (status == MT_OK) status = collect(&making, &figures, made);
    if (status == MT_OK) status = mt_naming_open(row->fonts[0], &made->naming);
    mt_report_figures_free(&figures);
    mt_making_end(&making);
    return mt_row_verdict(row, status);
}

mt_status mt_report_new(mt_blend *blend, mt_report **report) {
    mt_report *made = mt_new(1, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    mt_status status = make(&blend->row, made);
    if (status == MT_OK)
        *report = made;
    else
        mt_report_free(made);
    return status;
}

void mt_report_free(mt_report *report) {
    if (!report) return;
    mt_free(report->glyphs);
    mt_free(report->unblended);
    mt_naming_close(report->naming);
    mt_free(report);
}

int mt_report_count(const mt_report *report) {
    return report->count;
}

int mt_report_flagged(const mt_report *report, unsigned flags) {
    int count = 0;
    for (int i = 0; i < report->count; i++) count += (report->glyphs[i].flags & flags) != 0;
    return count;
}

/* ---- the format ---------------------------------------------------------------------------------------- */

mt_status mt_report_format_of(const char *path, mt_report_format *format) {
    const char *dot = strrchr(path, '.');
    bool html = dot && strcasecmp(dot, ".html") == 0, json = dot && strcasecmp(dot, ".json") == 0;
    if (!html && !json) return MT_UNKNOWN_FORMAT;
    *format = html ? MT_REPORT_HTML : MT_REPORT_JSON;
    return MT_OK;
}

/* ---- bytes and files ------------------------------------------------------------------------------------- */

mt_status mt_report_bytes(const mt_report *report, mt_report_format format, uint8_t **bytes, size_t *length) {
    mt_buffer text = {0};
    mt_status status =
        format == MT_REPORT_HTML ? mt_report_add_html(report, &text) : mt_report_add_json(report, &text);
    if (status != MT_OK) {
        mt_buffer_free(&text);
        return status;
    }
    *bytes = (uint8_t *)text.bytes;
    *length = text.length;
    return MT_OK;
}

mt_status mt_report_save(const mt_report *report, const char *path) {
    uint8_t *bytes;
    size_t length;
    mt_report_format format;
    mt_status status = mt_report_format_of(path, &format);
    if (status == MT_OK) status = mt_report_bytes(report, format, &bytes, &length);
    if (status != MT_OK) return status;
    status = mt_file_write(path, bytes, length);
    mt_bytes_free(bytes);
    return status;
}
