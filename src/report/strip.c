/* The strip of a glyph in the report's page: an SVG picture for each place, so that a narrow page can break the row. Whole
 * thousandths of the em, y downwards; relative commands, which are shorter. */
#include "geometry/limits.h"
#include "morph/between/instance.h"
#include "report/report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define PADDING 20 /* around the ink, thousandths of the em */

typedef struct mt_svg_pen {
    mt_buffer *text;
    mt_status status;
    int x, y; /* where it is, as written */
} mt_svg_pen;

static void put(mt_svg_pen *pen, const char *text) {
    if (pen->status == MT_OK) pen->status = mt_buffer_add(pen->text, text, strlen(text));
}

static int scaled(double grid) {
    return (int)lround(grid * 1000 / MT_EM);
}

/* "12-5": a sign parts numbers as well as a blank does. */
static void put_pair(mt_svg_pen *pen, bool first, int x, int y) {
    char text[32];
    snprintf(text, sizeof text, "%s%d%s%d", first || x < 0 ? "" : " ", x, y < 0 ? "" : " ", y);
    put(pen, text);
}

static void put_segment(mt_svg_pen *pen, const mt_segment *segment) {
    int x = scaled(segment->end.x), y = -scaled(segment->end.y);
    put(pen, segment->degree == 1 ? "l" : "q");
    if (segment->degree == 2)
        put_pair(pen, true, scaled(segment->control[0].x) - pen->x, -scaled(segment->control[0].y) - pen->y);
    put_pair(pen, segment->degree == 1, x - pen->x, y - pen->y);
    pen->x = x;
    pen->y = y;
}

static void put_contour(mt_svg_pen *pen, const mt_contour *contour) {
    mt_point start = contour->segments[contour->count - 1].end;
    pen->x = scaled(start.x);
    pen->y = -scaled(start.y);
    put(pen, "M");
    put_pair(pen, true, pen->x, pen->y);
    for (int i = 0; i < contour->count; i++) put_segment(pen, &contour->segments[i]);
    put(pen, "z");
}

/* The box, thousandths of the em with y upwards, in which all places of a glyph are shown, ink and advance. */
static mt_box view_of(const mt_glyph_pair *pair) {
    mt_box a = mt_shape_box(&pair->a), b = mt_shape_box(&pair->b);
    double advance = fmax(pair->room_a.advance, pair->room_b.advance);
    mt_box box = {{scaled(fmin(0, fmin(a.min.x, b.min.x))), scaled(fmin(a.min.y, b.min.y))},
                  {scaled(fmax(advance, fmax(a.max.x, b.max.x))), scaled(fmax(a.max.y, b.max.y))}};
    return (mt_box){{box.min.x - PADDING, box.min.y - PADDING}, {box.max.x + PADDING, box.max.y + PADDING}};
}

/* A flagged glyph has all eighths and each place between them that is off; others the quarters. */
static bool is_shown(const mt_report_glyph *glyph, int step) {
    if (!glyph->flags) return step % 4 == 0;
    return step % 2 == 0 || mt_report_is_off(glyph, step);
}

static void put_picture(mt_svg_pen *pen, mt_box view, bool off, const mt_outline *outline) {
    char text[160];
    int width = view.max.x - view.min.x, height = view.max.y - view.min.y;
    snprintf(text, sizeof text, "<svg%s viewBox=\"%d %d %d %d\" width=\"%d\" height=\"%d\"><path d=\"",
             off ? " class=\"off\"" : "", view.min.x, -view.max.y, width, height, width / 12, height / 12);
    put(pen, text);
    for (int i = 0; i < outline->count; i++) put_contour(pen, &outline->contours[i]);
    put(pen, "\"/></svg>");
}

mt_status mt_report_strip(const mt_glyph_pair *pair, const mt_params *params, const mt_report_glyph *glyph,
                          mt_arena *arena, mt_buffer *text) {
    mt_svg_pen pen = {.text = text};
    mt_box view = view_of(pair);
    mt_arena_place before = mt_arena_mark(arena);
    for (int i = 0; pen.status == MT_OK && i < MT_REPORT_STEPS; i++) {
        mt_outline outline;
        if (!is_shown(glyph, i)) continue;
        mt_weights weights = mt_weights_at(mt_report_t(i));
        pen.status = mt_morph_outline(&pair->morph, weights, params, arena, &outline);
        if (pen.status == MT_OK) put_picture(&pen, view, mt_report_is_off(glyph, i), &outline);
        mt_arena_rewind(arena, before);
    }
    return pen.status;
}
