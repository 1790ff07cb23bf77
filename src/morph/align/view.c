/* Views of samples in a frame (model/frame.h). A view's headings are carried as vectors and made unit vectors again; a corner is carried
 * with the normal half-way between its headings, and one that turns right back with none. O(1) a sample. */
#include "morph/align/view.h"

#include <math.h>

#include "arithmetic/angles.h"

#define TURNED_BACK 0.1 /* length of a sum of headings: less cancels itself, and has no normal */

/* A place on a boundary with the normal (n, m). */
static void carry(const mt_frame *f, double px, double py, double n, double m, mt_sample_view *view) {
    double width = mt_box_width(f->box), height = mt_box_height(f->box);
    double u = (px - f->box.min.x - width / 2) / mt_frame_side(width, height),
           v = (py - f->box.min.y - height / 2) / mt_frame_side(height, width);
    view->x = f->x[0] + f->x[1] * u + f->x[2] * v + f->x[3] * n;
    view->y = f->y[0] + f->y[1] * u + f->y[2] * v + f->y[3] * m;
}

mt_sample_view mt_view_of_place(const mt_frame *frame, double x, double y) {
    mt_sample_view view = {0};
    carry(frame, x, y, 0, 0, &view);
    return view;
}

void mt_normal_of(double x, double y, double normal[2]) {
    double length = mt_hypot(x, y);
    bool turned = length < TURNED_BACK;
    normal[0] = turned ? 0 : y / length;
    normal[1] = turned ? 0 : -x / length;
}

mt_vector mt_place_of_view(const mt_frame *f, const mt_sample_view *view) {
    double width = mt_box_width(f->box), height = mt_box_height(f->box), normal[2];
    mt_normal_of(view->in_x + view->out_x, view->in_y + view->out_y, normal);
    double x = view->x - f->x[0] - f->x[3] * normal[0], y = view->y - f->y[0] - f->y[3] * normal[1],
           determinant = f->x[1] * f->y[2] - f->x[2] * f->y[1];
    double u = (x * f->y[2] - y * f->x[2]) / determinant, v = (y * f->x[1] - x * f->y[1]) / determinant;
    return (mt_vector){f->box.min.x + width / 2 + u * mt_frame_side(width, height),
                       f->box.min.y + height / 2 + v * mt_frame_side(height, width)};
}

static void carry_heading(const mt_frame *f, double heading, double *x, double *y) {
    double p = mt_cos(heading), q = mt_sin(heading);
    double u = f->heading[0] * p + f->heading[1] * q, v = f->heading[2] * p + f->heading[3] * q,
           length = mt_hypot(u, v);
    *x = u / length;
    *y = v / length;
}

mt_sample_view mt_sample_view_of(const mt_ring_sample *s, const mt_frame *frame) {
    mt_sample_view view = {.turn_x = mt_cos(s->out - s->in), .turn_y = mt_sin(s->out - s->in)};
    double normal[2];
    mt_normal_of(mt_cos(s->in) + mt_cos(s->out), mt_sin(s->in) + mt_sin(s->out), normal);
    carry(frame, s->x, s->y, normal[0], normal[1], &view);
    carry_heading(frame, s->in, &view.in_x, &view.in_y);
    carry_heading(frame, s->out, &view.out_x, &view.out_y);
    return view;
}
