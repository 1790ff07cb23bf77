#include "motion/path_data.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "geometry/limits.h"

typedef struct mt_path_pen {
    const mt_page *page;
    mt_vector place;
    int64_t x, y; /* where the pen is, path units */
    mt_buffer *data;
    mt_status status;
} mt_path_pen;

static void add(mt_path_pen *pen, const char *text) {
    if (pen->status == MT_OK) pen->status = mt_buffer_add(pen->data, text, strlen(text));
}

static int64_t path_x(const mt_path_pen *pen, mt_point p) {
    return llround((pen->place.x + p.x - pen->page->left) * MT_PATH_EM / MT_EM);
}

static int64_t path_y(const mt_path_pen *pen, mt_point p) {
    return llround((pen->page->top - pen->place.y - p.y) * MT_PATH_EM / MT_EM);
}

/* A point after `before`, a command or a space, relative to the pen. */
static void add_point(mt_path_pen *pen, const char *before, mt_point p) {
    char text[64];
    int64_t x = path_x(pen, p) - pen->x, y = path_y(pen, p) - pen->y;
    snprintf(text, sizeof text, "%s%" PRId64 "%s%" PRId64, before, x, y < 0 ? "" : " ", y);
    add(pen, text);
}

static void go_to(mt_path_pen *pen, mt_point p) {
    pen->x = path_x(pen, p);
    pen->y = path_y(pen, p);
}

static void add_contour(mt_path_pen *pen, const mt_contour *contour) {
    mt_point start = contour->segments[contour->count - 1].end;
    add_point(pen, "m", start);
    go_to(pen, start);
    for (int i = 0; i < contour->count; i++) {
        const mt_segment *s = &contour->segments[i];
        if (s->degree == 2) add_point(pen, "q", s->control[0]);
        add_point(pen, s->degree == 2 ? " " : "l", s->end);
        go_to(pen, s->end);
    }
    add(pen, "z");
}

mt_status mt_path_data_add(const mt_drawing *drawing, const mt_page *page, mt_buffer *data) {
    mt_path_pen pen = {.page = page, .data = data};
    for (int i = 0; i < drawing->count; i++) {
        pen.place = drawing->list[i].place;
        for (int k = 0; k < drawing->list[i].outline.count; k++)
            add_contour(&pen, &drawing->list[i].outline.contours[k]);
    }
    return pen.status;
}

double mt_path_width(const mt_page *page) {
    return page->width / page->scale * MT_PATH_EM / MT_EM;
}

double mt_path_height(const mt_page *page) {
    return page->height / page->scale * MT_PATH_EM / MT_EM;
}
