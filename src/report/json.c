/* The report as data; docs/guide.md has the schema. */
#include "base/json.h"
#include "base/utf.h"
#include "geometry/limits.h"
#include "report/report.h"
#include "source/font.h"

static void add_font(mt_json *json, const char *key, const mt_font *font) {
    mt_json_object(json, key);
    mt_json_text(json, "font", mt_font_spec(font));
    mt_json_text(json, "family", mt_font_family(font));
    mt_json_text(json, "style", mt_font_style(font));
    mt_json_object_end(json);
}

static void add_heading(mt_json *json, const mt_report *report) {
    const mt_row *row = report->row;
    mt_json_text(json, "format", "morphotype report");
    mt_json_int(json, "version", 2);
    add_font(json, "a", row->fonts[0]);
    add_font(json, "b", row->fonts[1]);
    mt_json_text(json, "method", row->params.method == MT_METHOD_JOINT ? "joint" : "paper");
    mt_json_one_line(json);
    mt_json_array(json, "at");
    for (int i = 0; i < MT_REPORT_STEPS; i++) mt_json_number(json, NULL, mt_report_t(i));
    mt_json_array_end(json);
    mt_json_object(json, "limits");
    mt_json_number(json, "crumb", MT_CRUMB);
    mt_json_number(json, "ink", MT_INK_EXCESS);
    mt_json_number(json, "severity", MT_REPORT_STUMBLES);
    mt_json_object_end(json);
}

static void add_summary(mt_json *json, const mt_report *report) {
    const mt_report_summary *sum = &report->summary;
    mt_json_object(json, "summary");
    mt_json_int(json, "glyphs", report->count);
    mt_json_int(json, "flagged", sum->flagged);
    mt_json_int(json, "failed", sum->failed);
    mt_json_int(json, "unblended", report->unblended_count);
    for (int i = 0; i < 3; i++)
        mt_json_int(json, mt_report_method_name((mt_report_method)i), sum->methods[i]);
    mt_json_int(json, "proved", sum->proved);
    mt_json_number(json, "counts_in_range", mt_report_share(report, sum->in_range));
    mt_json_number(json, "ink_in_range", mt_report_share(report, sum->ink_near));
    mt_json_object_end(json);
}

static void add_flags(mt_json *json, const mt_report_glyph *glyph) {
    char reason[MT_REPORT_REASON_ROOM];
    mt_json_number(json, "severity", glyph->severity);
    mt_json_array(json, "flags");
    for (unsigned flag = 1; flag <= MT_FLAG_ALL; flag <<= 1) {
        if (!(glyph->flags & flag)) continue;
        mt_report_reason(glyph, (mt_report_flag)flag, reason);
        mt_json_one_line(json);
        mt_json_object(json, NULL);
        mt_json_text(json, "flag", mt_report_flag_name((mt_report_flag)flag));
        mt_json_text(json, "reason", reason);
        mt_json_object_end(json);
    }
    mt_json_array_end(json);
}

static void add_ink(mt_json *json, const mt_topology *ink) {
    mt_json_int(json, "components", ink->components);
    mt_json_int(json, "holes", ink->holes);
    mt_json_int(json, "crumbs", ink->crumbs);
    mt_json_number(json, "ink", ink->area);
}

static void add_drawing(mt_json *json, const mt_report_drawing *drawing) {
    mt_json_int(json, "points", drawing->points);
    mt_json_int(json, "corners", drawing->corners);
    mt_json_int(json, "slight_corners", drawing->slight);
}

static void add_end(mt_json *json, const char *key, const mt_topology *ink,
                    const mt_report_drawing *drawing) {
    mt_json_one_line(json);
    mt_json_object(json, key);
    add_ink(json, ink);
    add_drawing(json, drawing);
    mt_json_object_end(json);
}

static void add_figures(mt_json *json, const mt_report_glyph *glyph) {
    mt_json_text(json, "method", mt_report_method_name(glyph->method));
    mt_json_bool(json, "proved", glyph->proved);
    mt_json_array(json, "reach");
    mt_json_number(json, NULL, glyph->reach.from);
    mt_json_number(json, NULL, glyph->reach.to);
    mt_json_array_end(json);
    add_end(json, "a", &glyph->ink_a, &glyph->drawing_a);
    add_end(json, "b", &glyph->ink_b, &glyph->drawing_b);
    mt_json_array(json, "between");
    for (int i = 0; i < MT_REPORT_STEPS; i++) {
        mt_json_one_line(json);
        mt_json_object(json, NULL);
        add_ink(json, &glyph->ink[i]);
        mt_json_number(json, "strays", glyph->seen[i].strays);
        mt_json_number(json, "clots", glyph->seen[i].clots);
        mt_json_number(json, "ink_excess", glyph->seen[i].ink);
        mt_json_object_end(json);
    }
    mt_json_array_end(json);
    mt_json_number(json, "ink_bend", mt_report_ink_bend(glyph));
    mt_json_one_line(json);
    mt_json_object(json, "half");
    add_drawing(json, &glyph->drawing_half);
    mt_json_int(json, "kinks", mt_report_kinks(glyph));
    mt_json_object_end(json);
}

/* The character that leads to the glyph, or the glyph's name. */
static void add_name(mt_json *json, const mt_report *report, const mt_pairing *glyph) {
    char character[5] = "", label[MT_GLYPH_LABEL_ROOM];
    if (glyph->mapped) {
        mt_utf8_put(glyph->code_point, character);
        mt_json_text(json, "character", character);
        mt_json_int(json, "code_point", glyph->code_point);
        return;
    }
    mt_naming_label(report->naming, glyph->a, label);
    mt_json_text(json, "glyph", label);
}

static void add_unblended(mt_json *json, const mt_report *report) {
    mt_json_array(json, "unblended");
    for (int i = 0; i < report->unblended_count; i++) {
        mt_json_one_line(json);
        mt_json_object(json, NULL);
        add_name(json, report, &report->unblended[i]);
        mt_json_object_end(json);
    }
    mt_json_array_end(json);
}

static void add_glyph(mt_json *json, const mt_report *report, const mt_report_glyph *glyph) {
    mt_json_object(json, NULL);
    add_name(json, report, &glyph->of);
    add_flags(json, glyph);
    if (glyph->status == MT_OK) add_figures(json, glyph);
    mt_json_object_end(json);
}

mt_status mt_report_add_json(const mt_report *report, mt_buffer *text) {
    mt_json json = {0};
    mt_json_object(&json, NULL);
    add_heading(&json, report);
    add_summary(&json, report);
    mt_json_array(&json, "glyphs");
    for (int i = 0; i < report->count; i++) add_glyph(&json, report, &report->glyphs[i]);
    mt_json_array_end(&json);
    add_unblended(&json, report);
    mt_json_object_end(&json);
    if (json.status == MT_OK)
        *text = json.text;
    else
        mt_buffer_free(&json.text);
    return json.status;
}
