#include "motion/page.h"

#include <math.h>

#include "geometry/limits.h"

/* White around the drawing: a share of the em, or of the canvas' shorter side. */
#define MARGIN (1.0 / 16)

mt_bounds mt_bounds_of_nothing(void) {
    return (mt_bounds){INFINITY, -INFINITY, INFINITY, -INFINITY};
}

static void take_in(mt_bounds *bounds, mt_vector place, mt_point p) {
    bounds->left = fmin(bounds->left, place.x + p.x);
    bounds->right = fmax(bounds->right, place.x + p.x);
    bounds->bottom = fmin(bounds->bottom, place.y + p.y);
    bounds->top = fmax(bounds->top, place.y + p.y);
}

/* A curve lies within the hull of its points. */
void mt_bounds_take_in(mt_bounds *bounds, const mt_drawing *drawing) {
    for (int i = 0; i < drawing->count; i++)
        for (int k = 0; k < drawing->list[i].outline.count; k++) {
            const mt_contour *contour = &drawing->list[i].outline.contours[k];
            for (int j = 0; j < contour->count; j++) {
                const mt_segment *s = &contour->segments[j];
                take_in(bounds, drawing->list[i].place, s->end);
                for (int c = 0; c < s->degree - 1; c++)
                    take_in(bounds, drawing->list[i].place, s->control[c]);
            }
        }
}

/* A whole even number of pixels. */
static double even(double length) {
    return 2 * ceil(length / 2);
}

/* Pixels an em with which the drawing fills the canvas but for its margin. */
static double fitting_size(const mt_page_request *request, double across, double up) {
    double margin = 2 * MARGIN * fmin(request->width, request->height);
    return fmin((request->width - margin) / across, (request->height - margin) / up);
}

mt_status mt_page_lay(const mt_page_request *request, mt_bounds bounds, mt_page *page) {
    bool fixed = request->width > 0 && request->height > 0, asked = request->width || request->height;
    if (asked != fixed || !(request->size >= 0)) return MT_BAD_PARAMETER;
    double across = fmax(bounds.right - bounds.left, 1) / MT_EM;
    double up = fmax(bounds.top - bounds.bottom, 1) / MT_EM;
    double size = request->size > 0 ? request->size
                  : fixed           ? fitting_size(request, across, up)
                                    : MT_MOTION_SIZE;
    double width = fixed ? request->width : even((across + 2 * MARGIN) * size);
    double height = fixed ? request->height : even((up + 2 * MARGIN) * size);
    if (!(width <= MT_CANVAS_MAX && height <= MT_CANVAS_MAX)) return MT_TOO_LARGE;
    double scale = size / MT_EM;
    *page = (mt_page){.width = (int)width,
                      .height = (int)height,
                      .left = (bounds.left + bounds.right) / 2 - width / 2 / scale,
                      .top = (bounds.bottom + bounds.top) / 2 + height / 2 / scale,
                      .scale = scale};
    return MT_OK;
}
