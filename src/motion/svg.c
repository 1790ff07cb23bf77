/* A run is a path element: all of its key times have the same path commands. Where there are several runs, each is visible while it
 * lasts. What shows no motion shows the first key frame. */
#include "motion/svg.h"

#include <stdio.h>
#include <string.h>

#include "base/decimal.h"
#include "base/xml.h"
#include "motion/path_data.h"
#include "motion/runs.h"

/* Digits of shares of time and of progress. */
#define SHARE_DIGITS 6

/* A text in the making: an attribute's value. */
typedef struct mt_value {
    mt_buffer text;
    mt_status status;
} mt_value;

typedef struct mt_svg {
    const mt_motion *motion;
    mt_runs runs;
    mt_xml xml;
    mt_arena arena;
    mt_status status;
} mt_svg;

/* ---- values -------------------------------------------------------------------------------------------- */

static void add(mt_value *value, const char *text) {
    if (value->status == MT_OK) value->status = mt_buffer_add(&value->text, text, strlen(text));
}

static void add_number(mt_value *value, const char *before, double number, int digits) {
    char text[MT_DECIMAL_ROOM];
    mt_decimal_write(number, digits, text);
    add(value, before);
    add(value, text);
}

static void add_easing(mt_value *value, mt_easing easing, const char *comma) {
    add_number(value, "", easing.x1, SHARE_DIGITS);
    add_number(value, comma, easing.y1, SHARE_DIGITS);
    add_number(value, comma, easing.x2, SHARE_DIGITS);
    add_number(value, comma, easing.y2, SHARE_DIGITS);
}

static void add_path(mt_svg *svg, mt_value *value, mt_moment moment) {
    mt_arena_place before = mt_arena_mark(&svg->arena);
    mt_drawing drawing;
    if (value->status == MT_OK)
        value->status = mt_motion_draw(svg->motion, moment, false, &svg->arena, &drawing);
    if (value->status == MT_OK) value->status = mt_path_data_add(&drawing, &svg->motion->page, &value->text);
    mt_arena_rewind(&svg->arena, before);
}

static void add_colour(mt_svg *svg, mt_value *value, mt_moment moment) {
    char text[8];
    mt_colour_write(mt_motion_colour(svg->motion, moment), text);
    add(value, text);
}

/* Ends the value as text, which is its own until it is freed; "" where it has failed. */
static const char *end_value(mt_svg *svg, mt_value *value) {
    if (value->status == MT_OK) value->status = mt_buffer_add(&value->text, "", 1);
    if (svg->status == MT_OK) svg->status = value->status;
    return value->status == MT_OK ? (const char *)value->text.bytes : "";
}

static void write_value(mt_svg *svg, const char *attribute, mt_value *value) {
    mt_xml_attribute(&svg->xml, attribute, end_value(svg, value));
    mt_buffer_free(&value->text);
    *value = (mt_value){0};
}

static void write_number(mt_svg *svg, const char *attribute, double number, const char *unit) {
    mt_value value = {0};
    add_number(&value, "", number, 3);
    add(&value, unit);
    write_value(svg, attribute, &value);
}

static void write_path(mt_svg *svg, mt_moment moment) {
    mt_value value = {0};
    add_colour(svg, &value, moment);
    write_value(svg, "fill", &value);
    add_path(svg, &value, moment);
    write_value(svg, "d", &value);
}

/* ---- the document -------------------------------------------------------------------------------------- */

static void begin(mt_svg *svg) {
    const mt_page *page = &svg->motion->page;
    mt_value box = {0};
    add_number(&box, "0 0 ", mt_path_width(page), 3);
    add_number(&box, " ", mt_path_height(page), 3);
    mt_xml_open(&svg->xml, "svg");
    mt_xml_attribute(&svg->xml, "xmlns", "http://www.w3.org/2000/svg");
    mt_xml_number(&svg->xml, "width", page->width);
    mt_xml_number(&svg->xml, "height", page->height);
    write_value(svg, "viewBox", &box);
}

static void write_background(mt_svg *svg) {
    char colour[8];
    if (!svg->motion->request.has_background) return;
    mt_colour_write(svg->motion->request.background, colour);
    mt_xml_open(&svg->xml, "rect");
    mt_xml_attribute(&svg->xml, "width", "100%");
    mt_xml_attribute(&svg->xml, "height", "100%");
    mt_xml_attribute(&svg->xml, "fill", colour);
    mt_xml_close(&svg->xml);
}

/* Writes the document around what `content` writes. */
static mt_status write_document(const mt_motion *motion, void (*content)(mt_svg *svg, const void *user),
                                const void *user, mt_buffer *file) {
    mt_svg svg = {.motion = motion, .xml = mt_xml_begin()};
    const char *text;
    size_t length;
    begin(&svg);
    content(&svg, user);
    mt_xml_close(&svg.xml);
    mt_status status = mt_xml_end(&svg.xml, &text, &length);
    if (svg.status != MT_OK) status = svg.status;
    *file = (mt_buffer){0};
    if (status == MT_OK) status = mt_buffer_add(file, text, length);
    mt_xml_free(&svg.xml);
    mt_arena_release(&svg.arena);
    return status;
}

static bool colours_change(const mt_motion *motion) {
    const mt_motion_request *request = &motion->request;
    for (int i = 1; i < request->colour_count; i++)
        if (memcmp(&request->colours[i], &request->colours[0], sizeof(mt_colour)) != 0) return true;
    return false;
}

/* ---- SMIL ---------------------------------------------------------------------------------------------- */

/* The run's key times and, around them, the ends of the play, at which it stays as it is at its own ends. */
static void write_key_times(mt_svg *svg, const mt_run *run) {
    mt_value times = {0}, splines = {0};
    bool linear = true;
    if (run->times[0].time > 0) {
        add(&times, "0;");
        add(&splines, "0 0 1 1;");
    }
    for (int i = 0; i < run->count; i++) {
        add_number(&times, i ? ";" : "", run->times[i].time, SHARE_DIGITS);
        if (i + 1 == run->count) break;
        add(&splines, i ? ";" : "");
        add_easing(&splines, run->times[i].easing, " ");
        linear = linear && mt_easing_is_linear(&run->times[i].easing);
    }
    if (run->times[run->count - 1].time < 1) {
        add(&times, ";1");
        add(&splines, ";0 0 1 1");
    }
    mt_xml_attribute(&svg->xml, "calcMode", linear ? "linear" : "spline");
    write_value(svg, "keyTimes", &times);
    if (!linear) write_value(svg, "keySplines", &splines);
    mt_buffer_free(&splines.text);
}

/* What the attribute is at each of them. */
static void write_values(mt_svg *svg, const mt_run *run,
                         void (*write)(mt_svg *svg, mt_value *value, mt_moment moment)) {
    mt_value values = {0};
    const mt_key_time *first = &run->times[0], *last = &run->times[run->count - 1];
    if (first->time > 0) {
        write(svg, &values, first->moment);
        add(&values, ";");
    }
    for (int i = 0; i < run->count; i++) {
        add(&values, i ? ";" : "");
        write(svg, &values, run->times[i].moment);
    }
    if (last->time < 1) {
        add(&values, ";");
        write(svg, &values, last->moment);
    }
    write_value(svg, "values", &values);
}

static void begin_animate(mt_svg *svg, const char *attribute) {
    int plays = svg->motion->request.timing.plays;
    mt_xml_open(&svg->xml, "animate");
    mt_xml_attribute(&svg->xml, "attributeName", attribute);
    write_number(svg, "dur", svg->motion->timeline.length, "s");
    if (plays == 0)
        mt_xml_attribute(&svg->xml, "repeatCount", "indefinite");
    else
        mt_xml_number(&svg->xml, "repeatCount", plays);
    if (plays > 0) mt_xml_attribute(&svg->xml, "fill", "freeze");
}

static void write_animate(mt_svg *svg, const mt_run *run, const char *attribute,
                          void (*write)(mt_svg *svg, mt_value *value, mt_moment moment)) {
    begin_animate(svg, attribute);
    write_key_times(svg, run);
    write_values(svg, run, write);
    mt_xml_close(&svg->xml);
}

static void write_visibility(mt_svg *svg, const mt_run *run) {
    mt_value times = {0};
    double start = run->times[0].time, end = run->times[run->count - 1].time;
    bool hides = end < 1;
    add(&times, "0");
    if (start > 0) add_number(&times, ";", start, SHARE_DIGITS);
    if (hides) add_number(&times, ";", end, SHARE_DIGITS);
    begin_animate(svg, "visibility");
    mt_xml_attribute(&svg->xml, "calcMode", "discrete");
    write_value(svg, "keyTimes", &times);
    mt_xml_attribute(&svg->xml, "values",
                     start == 0 ? "visible;hidden"
                     : hides    ? "hidden;visible;hidden"
                                : "hidden;visible");
    mt_xml_close(&svg->xml);
}

static void find_runs(mt_svg *svg) {
    if (svg->status == MT_OK) svg->status = mt_runs_make(svg->motion, &svg->arena, &svg->runs);
}

static void write_smil(mt_svg *svg, const void *user) {
    (void)user;
    find_runs(svg);
    write_background(svg);
    for (int i = 0; i < svg->runs.count; i++) {
        const mt_run *run = &svg->runs.list[i];
        mt_xml_open(&svg->xml, "path");
        if (i > 0) mt_xml_attribute(&svg->xml, "visibility", "hidden");
        write_path(svg, run->times[0].moment);
        write_animate(svg, run, "d", add_path);
        if (colours_change(svg->motion)) write_animate(svg, run, "fill", add_colour);
        if (svg->runs.count > 1) write_visibility(svg, run);
        mt_xml_close(&svg->xml);
    }
}

mt_status mt_svg_smil(const mt_motion *motion, mt_buffer *file) {
    return write_document(motion, write_smil, NULL, file);
}

/* ---- CSS ----------------------------------------------------------------------------------------------- */

/* The selector of a key frame. */
static void add_percent(mt_value *style, const char *before, double time) {
    add_number(style, before, 100 * time, SHARE_DIGITS - 2);
    add(style, "%");
}

static void add_key_frame(mt_svg *svg, mt_value *style, const mt_run *run, int i) {
    const mt_key_time *key = &run->times[i];
    if (i == 0 && key->time > 0) add(style, "0%,");
    add_percent(style, "", key->time);
    if (i + 1 == run->count && key->time < 1) add(style, ",100%");
    add(style, "{d:path('");
    add_path(svg, style, key->moment);
    add(style, "');fill:");
    add_colour(svg, style, key->moment);
    if (i + 1 < run->count && !mt_easing_is_linear(&key->easing)) {
        add(style, ";animation-timing-function:cubic-bezier(");
        add_easing(style, key->easing, ",");
        add(style, ")");
    }
    add(style, "}\n");
}

static void add_visibility(mt_value *style, const mt_run *run) {
    double start = run->times[0].time, end = run->times[run->count - 1].time;
    add(style, start > 0 ? "0%{visibility:hidden}" : "0%{visibility:visible}");
    if (start > 0) {
        add_percent(style, "", start);
        add(style, "{visibility:visible}");
    }
    if (end < 1) {
        add_percent(style, "", end);
        add(style, "{visibility:hidden}");
    }
    add(style, end < 1 ? "100%{visibility:hidden}" : "100%{visibility:visible}");
}

static void add_animation(mt_svg *svg, mt_value *style, const char *name, int number, const char *timing) {
    char text[96];
    int plays = svg->motion->request.timing.plays;
    snprintf(text, sizeof text, "%s-%d ", name, number);
    add(style, text);
    add_number(style, "", svg->motion->timeline.length, 3);
    if (plays == 0)
        snprintf(text, sizeof text, "s %s infinite both", timing);
    else
        snprintf(text, sizeof text, "s %s %d both", timing, plays);
    add(style, text);
}

static void add_run(mt_svg *svg, mt_value *style, int number) {
    const mt_run *run = &svg->runs.list[number];
    char text[96];
    bool several = svg->runs.count > 1;
    snprintf(text, sizeof text, "@keyframes morph-%d{\n", number);
    add(style, text);
    for (int i = 0; i < run->count; i++) add_key_frame(svg, style, run, i);
    snprintf(text, sizeof text, "}\n#morph-%d{animation:", number);
    add(style, text);
    add_animation(svg, style, "morph", number, "linear");
    if (several) add(style, ",");
    if (several) add_animation(svg, style, "show", number, "step-end");
    add(style, "}\n");
    if (!several) return;
    snprintf(text, sizeof text, "@keyframes show-%d{", number);
    add(style, text);
    add_visibility(style, run);
    add(style, "}\n");
}

static void write_css(mt_svg *svg, const void *user) {
    mt_value style = {0};
    (void)user;
    find_runs(svg);
    add(&style, "\n");
    for (int i = 0; i < svg->runs.count; i++) add_run(svg, &style, i);
    mt_xml_text(&svg->xml, "style", end_value(svg, &style));
    mt_buffer_free(&style.text);
    write_background(svg);
    for (int i = 0; i < svg->runs.count; i++) {
        char id[32];
        snprintf(id, sizeof id, "morph-%d", i);
        mt_xml_open(&svg->xml, "path");
        mt_xml_attribute(&svg->xml, "id", id);
        if (i > 0) mt_xml_attribute(&svg->xml, "visibility", "hidden");
        write_path(svg, svg->runs.list[i].times[0].moment);
        mt_xml_close(&svg->xml);
    }
}

mt_status mt_svg_css(const mt_motion *motion, mt_buffer *file) {
    return write_document(motion, write_css, NULL, file);
}

/* ---- stills -------------------------------------------------------------------------------------------- */

static void write_still(mt_svg *svg, const void *user) {
    write_background(svg);
    mt_xml_open(&svg->xml, "path");
    write_path(svg, *(const mt_moment *)user);
    mt_xml_close(&svg->xml);
}

mt_status mt_svg_still(const mt_motion *motion, mt_moment moment, mt_buffer *file) {
    return write_document(motion, write_still, &moment, file);
}
