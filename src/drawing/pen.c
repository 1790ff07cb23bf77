#include "drawing/pen.h"

#include <math.h>

#include "arithmetic/angles.h"

#define PI 3.14159265358979323846

void mt_pen_layer_begin(mt_pen *pen, mt_rule rule) {
    if (pen->status != MT_OK) return;
    mt_pen_layer *grown =
        mt_arena_grow_list(pen->arena, pen->layers, pen->layer_count, &pen->layer_room, sizeof *grown);
    if (!grown) {
        pen->status = MT_NO_MEMORY;
        return;
    }
    pen->layers = grown;
    grown[pen->layer_count++] = (mt_pen_layer){pen->contour_count, 0, rule};
    pen->at = pen->start = (mt_vector){0, 0};
    pen->open = false;
}

void mt_pen_move(mt_pen *pen, double x, double y) {
    pen->at = pen->start = (mt_vector){x, y};
    pen->open = false;
}

/* A contour is there as soon as it has a segment. */
static void begin_contour(mt_pen *pen) {
    if (pen->status != MT_OK || pen->open) return;
    mt_pen_contour *grown =
        mt_arena_grow_list(pen->arena, pen->contours, pen->contour_count, &pen->contour_room, sizeof *grown);
    if (!grown) {
        pen->status = MT_NO_MEMORY;
        return;
    }
    pen->contours = grown;
    grown[pen->contour_count++] =
        (mt_pen_contour){mt_affine_apply(&pen->map, pen->start.x, pen->start.y), pen->segment_count, 0};
    pen->layers[pen->layer_count - 1].count++;
    pen->open = true;
}

static void add(mt_pen *pen, mt_pen_segment segment, double x, double y) {
    segment.end = mt_affine_apply(&pen->map, x, y);
    begin_contour(pen);
    if (pen->status == MT_OK && pen->segment_count == MT_DRAWING_SEGMENTS_MAX) pen->status = MT_TOO_LARGE;
    if (pen->status != MT_OK) return;
    mt_pen_segment *grown =
        mt_arena_grow_list(pen->arena, pen->segments, pen->segment_count, &pen->segment_room, sizeof *grown);
    if (!grown) {
        pen->status = MT_NO_MEMORY;
        return;
    }
    pen->segments = grown;
    grown[pen->segment_count++] = segment;
    pen->contours[pen->contour_count - 1].count++;
    pen->at = (mt_vector){x, y};
}

void mt_pen_line(mt_pen *pen, double x, double y) {
    add(pen, (mt_pen_segment){.degree = 1}, x, y);
}

void mt_pen_cubic(mt_pen *pen, double c1x, double c1y, double c2x, double c2y, double x, double y) {
    mt_pen_segment segment = {.degree = 3};
    segment.control[0] = mt_affine_apply(&pen->map, c1x, c1y);
    segment.control[1] = mt_affine_apply(&pen->map, c2x, c2y);
    add(pen, segment, x, y);
}

void mt_pen_quadratic(mt_pen *pen, double cx, double cy, double x, double y) {
    mt_vector from = pen->at;
    mt_pen_cubic(pen, from.x + (cx - from.x) * 2 / 3, from.y + (cy - from.y) * 2 / 3, x + (cx - x) * 2 / 3,
                 y + (cy - y) * 2 / 3, x, y);
}

/* ---- arcs ------------------------------------------------------------------------------------------------ */

/* An ellipse: its middle, its axes and how far they are turned. */
typedef struct mt_ellipse {
    double x, y, rx, ry, cosine, sine;
} mt_ellipse;

static mt_vector on_ellipse(const mt_ellipse *e, double x, double y) {
    return (mt_vector){e->x + e->rx * x * e->cosine - e->ry * y * e->sine,
                       e->y + e->rx * x * e->sine + e->ry * y * e->cosine};
}

/* From angle `from` on, by `turn`. */
static void draw_arc(mt_pen *pen, const mt_ellipse *e, double from, double turn) {
    int count = (int)ceil(fabs(turn) / (PI / 4) - 1e-9);
    double step = turn / count, handle = 4.0 / 3 * mt_tan(step / 4);
    for (int i = 0; i < count; i++) {
        double a = from + i * step, b = a + step;
        mt_vector first = on_ellipse(e, mt_cos(a) - handle * mt_sin(a), mt_sin(a) + handle * mt_cos(a));
        mt_vector second = on_ellipse(e, mt_cos(b) + handle * mt_sin(b), mt_sin(b) - handle * mt_cos(b));
        mt_vector end = on_ellipse(e, mt_cos(b), mt_sin(b));
        mt_pen_cubic(pen, first.x, first.y, second.x, second.y, end.x, end.y);
    }
}

/* B.2.4 and B.2.5: from both ends to the middle and angles. */
void mt_pen_arc(mt_pen *pen, double rx, double ry, double degrees, bool large, bool sweep, double x,
                double y) {
    double cosine = mt_cos(degrees * PI / 180), sine = mt_sin(degrees * PI / 180);
    double dx = (pen->at.x - x) / 2, dy = (pen->at.y - y) / 2;
    double u = cosine * dx + sine * dy, v = cosine * dy - sine * dx; /* half the way, along the axes */
    rx = fabs(rx);
    ry = fabs(ry);
    if (dx == 0 && dy == 0) return;
    if (!(rx > 0 && ry > 0)) {
        mt_pen_line(pen, x, y);
        return;
    }
    double reach = mt_hypot(u / rx, v / ry);
    if (reach > 1) rx *= reach, ry *= reach;
    double off = sqrt(fmax(1 / fmax(mt_hypot(u / rx, v / ry) * mt_hypot(u / rx, v / ry), 1e-300) - 1, 0));
    if (large == sweep) off = -off;
    double mx = off * rx * v / ry, my = -off * ry * u / rx;
    mt_ellipse ellipse = {cosine * mx - sine * my + (pen->at.x + x) / 2,
                          sine * mx + cosine * my + (pen->at.y + y) / 2,
                          rx,
                          ry,
                          cosine,
                          sine};
    double from = mt_atan2((v - my) / ry, (u - mx) / rx), to = mt_atan2((-v - my) / ry, (-u - mx) / rx);
    double turn = to - from;
    if (sweep && turn < 0) turn += 2 * PI;
    if (!sweep && turn > 0) turn -= 2 * PI;
    if (!isfinite(turn) || turn == 0)
        mt_pen_line(pen, x, y);
    else
        draw_arc(pen, &ellipse, from, turn);
    pen->at = (mt_vector){x, y};
}

void mt_pen_close(mt_pen *pen) {
    pen->at = pen->start;
    pen->open = false;
}
