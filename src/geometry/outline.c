/* Places on outlines, and outlines as they are told to others. O(1) a segment. */
#include "geometry/outline.h"

mt_vector mt_segment_at(mt_point from, const mt_segment *s, double t) {
    bool curved = s->degree == 2;
    mt_point middle = curved ? s->control[0] : from;
    double a = curved ? (1 - t) * (1 - t) : 1 - t, b = curved ? 2 * t * (1 - t) : 0, c = curved ? t * t : t;
    return (mt_vector){a * from.x + b * middle.x + c * s->end.x, a * from.y + b * middle.y + c * s->end.y};
}

static void draw_contour(const mt_contour *contour, double scale, const mt_draw *draw, void *user) {
    mt_point start = contour->segments[contour->count - 1].end;
    draw->move_to(start.x * scale, start.y * scale, user);
    for (int i = 0; i < contour->count; i++) {
        const mt_segment *s = &contour->segments[i];
        double x = s->end.x * scale, y = s->end.y * scale;
        if (s->degree == 1)
            draw->line_to(x, y, user);
        else if (s->degree == 2)
            draw->quadratic_to(s->control[0].x * scale, s->control[0].y * scale, x, y, user);
        else
            draw->cubic_to(s->control[0].x * scale, s->control[0].y * scale, s->control[1].x * scale,
                           s->control[1].y * scale, x, y, user);
    }
    draw->close(user);
}

void mt_outline_draw(const mt_outline *outline, double scale, const mt_draw *draw, void *user) {
    for (int i = 0; i < outline->count; i++) draw_contour(&outline->contours[i], scale, draw, user);
}
