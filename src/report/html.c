/* The report as a page: one file that needs no network, and to be read no script; by its script a glyph is enlarged, with hints by
 * pointing. */
#include "base/html.h"
#include "base/page.h"
#include "base/workers.h"
#include "geometry/limits.h"
#include "pointing/pointing.h"
#include "report/page.h"
#include "report/report.h"
#include "source/font.h"

#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* What is shown of a glyph that did not fail: its strip, and what the page's script reads of it. */
typedef struct mt_shown_glyph {
    mt_buffer strip;
    mt_json data;
} mt_shown_glyph;

typedef struct mt_page {
    const mt_report *report;
    mt_buffer *text;
    mt_status status; /* once it is not MT_OK nothing more is written */
    mt_shown_glyph
        *shown; /* the first MT_REPORT_STRIPS glyphs that did not fail, by their place in the report */
    int shown_count;
} mt_page;

/* ---- writing ------------------------------------------------------------------------------------------- */

/* As it is: markup. */
static void put(mt_page *page, const char *markup) {
    if (page->status == MT_OK) page->status = mt_buffer_add(page->text, markup, strlen(markup));
}

/* Markup with whole numbers and short words in it. */
__attribute__((format(printf, 2, 3))) static void put_format(mt_page *page, const char *format, ...) {
    char markup[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(markup, sizeof markup, format, arguments);
    va_end(arguments);
    put(page, markup);
}

static void put_character(mt_page *page, uint32_t code_point) {
    if (page->status == MT_OK) page->status = mt_html_character(page->text, code_point);
}

static void put_text(mt_page *page, const char *utf8) {
    if (page->status == MT_OK) page->status = mt_html_text(page->text, utf8);
}

/* "+1.3 %"; digits by hand, since the C library's point is another one in some locales. */
static void put_percent(mt_page *page, const char *sign, double share) {
    int64_t tenths = llround(fabs(share) * 1000);
    put_format(page, "%s%" PRId64 ".%" PRId64 " %%", sign, tenths / 10, tenths % 10);
}

/* ---- glyphs shown --------------------------------------------------------------------------------------- */

/* What the script reads of a glyph. */
static mt_status add_data(mt_json *json, const mt_report *report, const mt_pairing *of,
                          const mt_glyph_pair *pair, mt_arena *arena) {
    char label[MT_GLYPH_LABEL_ROOM];
    mt_naming_label(report->naming, of->a, label);
    if (of->mapped) snprintf(label, sizeof label, "U+%04lX", (unsigned long)of->code_point);
    mt_pointed_glyph glyph = {label, of->mapped ? of->code_point : 0, of->a, of->b, pair, NULL};
    return mt_pointing_add_glyph(json, report->row, &glyph, arena);
}

/* A task: the index-th glyph that did not fail. Failed glyphs are the worst and stand before all others. */
static mt_status show_glyph(int index, mt_arena *scratch, mt_arena *kept, void *user) {
    const mt_page *page = user;
    mt_row *row = page->report->row;
    const mt_report_glyph *glyph = &page->report->glyphs[page->report->summary.failed + index];
    mt_shown_glyph *shown = &page->shown[index];
    mt_glyph_pair pair = {0};
    (void)kept;
    mt_status status = mt_pair_prepare(row, 0, glyph->of.a, glyph->of.b, scratch, &pair);
    if (status == MT_OK) status = mt_report_strip(&pair, &row->params, glyph, scratch, &shown->strip);
    return status == MT_OK ? add_data(&shown->data, page->report, &glyph->of, &pair, scratch) : status;
}

static mt_status show_glyphs(mt_page *page) {
    const mt_report *report = page->report;
    int count = report->count - report->summary.failed;
    page->shown_count = count < MT_REPORT_STRIPS ? count : MT_REPORT_STRIPS;
    if (page->shown_count == 0) return MT_OK;
    page->shown = mt_new((size_t)page->shown_count, sizeof *page->shown);
    if (!page->shown) return MT_NO_MEMORY;
    mt_work work = {
        .count = page->shown_count, .task = show_glyph, .user = page, .threads = report->row->params.threads};
    return mt_work_run(&work);
}

static void forget_glyphs(mt_page *page) {
    for (int i = 0; page->shown && i < page->shown_count; i++) {
        mt_buffer_free(&page->shown[i].strip);
        mt_buffer_free(&page->shown[i].data.text);
    }
    mt_free(page->shown);
}

static void put_strip(mt_page *page, int index) {
    int number = index - page->report->summary.failed;
    if (page->status != MT_OK || number < 0 || number >= page->shown_count) return;
    const mt_buffer *strip = &page->shown[number].strip;
    put_format(page, "<div class=\"strip\" data-glyph=\"%d\">", number);
    if (page->status == MT_OK) page->status = mt_buffer_add(page->text, strip->bytes, strip->length);
    put(page, "</div>");
}

/* ---- the head ------------------------------------------------------------------------------------------ */

static void put_font(mt_page *page, const char *t, const mt_font *font) {
    put_format(page, "T = %s: <bdi>", t);
    put_text(page, mt_font_family(font));
    put(page, " ");
    put_text(page, mt_font_style(font));
    put(page, "</bdi> <code>");
    put_text(page, mt_font_spec(font));
    put(page, "</code><br>\n");
}

static void put_summary(mt_page *page) {
    const mt_report *report = page->report;
    const mt_report_summary *sum = &report->summary;
    put(page, "<p>");
    put_font(page, "0", report->row->fonts[0]);
    put_font(page, "1", report->row->fonts[1]);
    put_format(page, "Method: %s</p>\n", report->row->params.method == MT_METHOD_JOINT ? "joint" : "paper");
    put_format(page,
               "<p>%d glyphs, <b>%d flagged</b>, %d of them failed. %d move by aligned contours, %d by "
               "links, %d by both. ",
               report->count, sum->flagged, sum->failed, sum->methods[MT_REPORT_ALIGNED],
               sum->methods[MT_REPORT_LINKED], sum->methods[MT_REPORT_BOTH]);
    put_percent(page, "Components and holes stay in the range of the two fonts’ in ",
                mt_report_share(report, sum->in_range));
    put_percent(page, " of the glyphs; their ink does, or leaves it by no more than its limit, in ",
                mt_report_share(report, sum->ink_near));
    put_format(page,
               ". That they stay so at every T, not only at the places measured, is proved for %d.</p>\n",
               sum->proved);
}

static void put_legend(mt_page *page) {
    put_format(
        page,
        "<p><small>Measured at %d places. A glyph is flagged when its severity is %d or more: the worst "
        "of three measures, with a little for each component and hole out of the range of the ends’. "
        "<i>Strays</i>: ink is %d thousandths of the em or more off the way between the ends. <i>Clots</i>: "
        "a "
        "stroke is %d %% thicker than any of the ends’. <i>Ink</i>: its area leaves the ends’ range by "
        "%d %% of the larger. ",
        MT_REPORT_STEPS, (int)MT_REPORT_STUMBLES, (int)MT_STRAYS_MOST, (int)lround(100 * MT_CLOTS_MOST),
        (int)lround(100 * MT_INK_MOST));
    put_format(
        page,
        "Components and holes under %d square thousandths of the em are not counted. Kinks are corners of "
        "%d° … %d° half-way that neither end has. ",
        (int)MT_CRUMB, (int)MT_REPORT_KINK_MIN, (int)MT_REPORT_KINK_MAX);
    put(page,
        "Counts read: first font / least–most in between / second font. Bend is the ink’s largest distance "
        "from the straight line between the ends. Reach: the T from and to which blend goes on past the "
        "ends.</small></p>\n");
}

/* ---- the tables ---------------------------------------------------------------------------------------- */

static int count_at(const mt_report_glyph *glyph, mt_report_flag flag, int step) {
    return flag == MT_FLAG_HOLES ? glyph->ink[step].holes : glyph->ink[step].components;
}

/* "1 / 1–2 / 2" */
static void put_counts(mt_page *page, const mt_report_glyph *glyph, mt_report_flag flag, int a, int b) {
    int least = count_at(glyph, flag, 0), most = least;
    for (int i = 1; i < MT_REPORT_STEPS; i++) {
        int count = count_at(glyph, flag, i);
        if (count < least) least = count;
        if (count > most) most = count;
    }
    put_format(page, "<td>%d / %d", a, least);
    if (most > least) put_format(page, "–%d", most);
    put_format(page, " / %d</td>", b);
}

/* "−0.44 … 1.31", in whole hundredths, inwards. */
static void put_reach(mt_page *page, const mt_reach *reach) {
    int64_t before = (int64_t)floor(-100 * reach->from), past = (int64_t)floor(100 * reach->to);
    put_format(page, "<td>%s%" PRId64 ".%02" PRId64 " … %" PRId64 ".%02" PRId64 "</td>", before ? "−" : "",
               before / 100, before % 100, past / 100, past % 100);
}

static void put_figures(mt_page *page, const mt_report_glyph *glyph) {
    double bend = mt_report_ink_bend(glyph);
    int64_t hundredths = llround(glyph->severity * 100);
    put_format(page, "<td>%" PRId64 ".%02" PRId64 "</td><td>%s</td>", hundredths / 100, hundredths % 100,
               mt_report_method_name(glyph->method));
    put_counts(page, glyph, MT_FLAG_COMPONENTS, glyph->ink_a.components, glyph->ink_b.components);
    put_counts(page, glyph, MT_FLAG_HOLES, glyph->ink_a.holes, glyph->ink_b.holes);
    put(page, "<td>");
    put_percent(page, bend < 0 ? "−" : "+", bend);
    put_format(page, "</td><td>%d / %d / %d</td><td>%d</td>", glyph->drawing_a.points,
               glyph->drawing_half.points, glyph->drawing_b.points, mt_report_kinks(glyph));
    put_reach(page, &glyph->reach);
}

/* The character that leads to the glyph, or the glyph's name. */
static void put_name(mt_page *page, const mt_pairing *glyph) {
    char label[MT_GLYPH_LABEL_ROOM];
    if (glyph->mapped) {
        put(page, "<bdi class=\"char\">");
        if (!mt_html_is_control(glyph->code_point)) put_character(page, glyph->code_point);
        put_format(page, "</bdi><small>U+%04lX</small>", (unsigned long)glyph->code_point);
        return;
    }
    mt_naming_label(page->report->naming, glyph->a, label);
    put(page, "<bdi class=\"name\">");
    put_text(page, label);
    put(page, "</bdi>");
}

static void put_row(mt_page *page, const mt_report_glyph *glyph) {
    put(page, "<tr><th scope=\"row\">");
    put_name(page, &glyph->of);
    put(page, "</th>");
    if (glyph->status == MT_OK)
        put_figures(page, glyph);
    else
        put(page, "<td colspan=\"8\"></td>");
    put(page, "</tr>\n");
}

/* Why a glyph is flagged. */
static void put_reasons(mt_page *page, const mt_report_glyph *glyph) {
    char reason[MT_REPORT_REASON_ROOM];
    if (!glyph->flags) return;
    put(page, "<ul>");
    for (unsigned flag = 1; flag <= MT_FLAG_ALL; flag <<= 1) {
        if (!(glyph->flags & flag)) continue;
        mt_report_reason(glyph, (mt_report_flag)flag, reason);
        put_format(page, "<li>%s: ", mt_report_flag_name((mt_report_flag)flag));
        put_text(page, reason);
        put(page, "</li>");
    }
    put(page, "</ul>");
}

/* A glyph's rows. */
static void put_glyph(mt_page *page, int index) {
    const mt_report_glyph *glyph = &page->report->glyphs[index];
    put(page, "<tbody>");
    put_row(page, glyph);
    put(page, "<tr><td class=\"look\" colspan=\"9\">");
    put_reasons(page, glyph);
    put_strip(page, index);
    put(page, "</td></tr></tbody>\n");
}

static void begin_table(mt_page *page) {
    put(page, "<div class=\"scroll\"><table>\n<thead><tr>");
    put(page, "<th scope=\"col\">Glyph</th><th scope=\"col\">Severity</th><th scope=\"col\">Method</th><th "
              "scope=\"col\">Components</th>"
              "<th scope=\"col\">Holes</th><th scope=\"col\">Bend</th><th scope=\"col\">Points</th>"
              "<th scope=\"col\">Kinks</th><th scope=\"col\">Reach</th></tr></thead>\n");
}

static void put_flagged(mt_page *page) {
    const mt_report *report = page->report;
    int flagged = report->summary.flagged;
    put_format(page, "<h2>Flagged, the worst first</h2>\n<p>%s</p>\n",
               flagged
                   ? "Each strip goes from T = 0 to T = 1 in eighths, with places between them where one is "
                     "coloured; coloured places are out of the ends’ range, or would be stumbled over."
                   : "None.");
    if (!flagged) return;
    begin_table(page);
    for (int i = 0; i < flagged; i++) put_glyph(page, i);
    put(page, "</table></div>\n");
}

static void put_others(mt_page *page) {
    const mt_report *report = page->report;
    int flagged = report->summary.flagged;
    if (flagged == report->count) return;
    put_format(page,
               "<h2>The others, the worst first</h2>\n<details><summary>%d glyphs without a flag</summary>\n"
               "<p>Each strip goes from T = 0 to T = 1 in quarters.</p>\n",
               report->count - flagged);
    begin_table(page);
    for (int i = flagged; i < report->count; i++) put_glyph(page, i);
    put(page, "</table></div></details>\n");
}

static void put_strips_left_out(mt_page *page) {
    int drawable = page->report->count - page->report->summary.failed;
    if (drawable > page->shown_count)
        put_format(page, "<p>Only the worst %d of the %d glyphs have strips.</p>\n", page->shown_count,
                   drawable);
}

static void put_unblended(mt_page *page) {
    const mt_report *report = page->report;
    int count = report->unblended_count;
    if (count == 0) return;
    put_format(page,
               "<h2>As in the first font</h2>\n<details><summary>%d glyph%s without a partner in the second "
               "font</summary>\n<p>",
               count, count == 1 ? "" : "s");
    for (int i = 0; i < count; i++) {
        if (i) put(page, ", ");
        put_name(page, &report->unblended[i]);
    }
    put(page, "</p></details>\n");
}

/* ---- the page ------------------------------------------------------------------------------------------ */

static void put_body(mt_page *page) {
    put_summary(page);
    put_legend(page);
    put_strips_left_out(page);
    put_flagged(page);
    put_others(page);
    put_unblended(page);
}

/* {"names": {…}, "glyphs": […]}, the glyphs shown in their order. */
static void put_data(mt_page *page) {
    mt_json names = {0};
    mt_pointing_add_names(&names, NULL, page->report->row);
    if (page->status == MT_OK) page->status = names.status;
    put(page, "{\"names\": ");
    if (page->status == MT_OK) page->status = mt_page_add_json(page->text, &names.text);
    put(page, ", \"glyphs\": [");
    for (int i = 0; i < page->shown_count && page->status == MT_OK; i++) {
        put(page, i ? ",\n" : "\n");
        if (page->status == MT_OK) page->status = mt_page_add_json(page->text, &page->shown[i].data.text);
    }
    put(page, "]}");
    mt_buffer_free(&names.text);
}

/* An mt_page_fill. */
static mt_status fill(mt_page_slot slot, const void *user, mt_buffer *text) {
    mt_page page = *(const mt_page *)user;
    page.text = text;
    if (slot == MT_SLOT_TITLE) return mt_pointing_add_title(text, page.report->row);
    if (slot == MT_SLOT_BODY) put_body(&page);
    if (slot == MT_SLOT_DATA) put_data(&page);
    return page.status;
}

mt_status mt_report_add_html(const mt_report *report, mt_buffer *text) {
    mt_page page = {.report = report};
    mt_status status = show_glyphs(&page);
    if (status == MT_OK) status = mt_page_make(mt_report_page, fill, &page, text);
    forget_glyphs(&page);
    return status;
}
