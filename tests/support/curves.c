#include "support/curves.h"

#include "support/check.h"
#include "support/oracle.h"

#include <math.h>

mt_place2 mt_curves_at(const mt_contour *contour, int i, double t) {
    const mt_segment *segment = &contour->segments[i];
    mt_point start = contour->segments[(i + contour->count - 1) % contour->count].end;
    mt_place2 p[4] = {{start.x, start.y}};
    for (int k = 1; k < segment->degree; k++)
        p[k] = (mt_place2){segment->control[k - 1].x, segment->control[k - 1].y};
    p[segment->degree] = (mt_place2){segment->end.x, segment->end.y};
    for (int n = segment->degree; n > 0; n--)
        for (int k = 0; k < n; k++)
            p[k] = (mt_place2){(1 - t) * p[k].x + t * p[k + 1].x, (1 - t) * p[k].y + t * p[k + 1].y};
    return p[0];
}

static double segment_distance(const mt_contour *contour, int i, double x, double y) {
    int steps = contour->segments[i].degree == 1 ? 1 : MT_CURVES_STEPS;
    mt_place2 a = mt_curves_at(contour, i, 0);
    double best = INFINITY;
    for (int k = 1; k <= steps; k++) {
        mt_place2 b = mt_curves_at(contour, i, (double)k / steps);
        best = fmin(best, mt_oracle_segment_distance(x, y, a.x, a.y, b.x, b.y));
        a = b;
    }
    return best;
}

/* No point of a Bézier is nearer than its control points' box. */
static double box_distance(const mt_contour *contour, int i, double x, double y) {
    const mt_segment *segment = &contour->segments[i];
    mt_point p = contour->segments[(i + contour->count - 1) % contour->count].end;
    double left = p.x, right = p.x, low = p.y, high = p.y;
    for (int k = 1; k <= segment->degree; k++) {
        p = k == segment->degree ? segment->end : segment->control[k - 1];
        left = fmin(left, p.x);
        right = fmax(right, p.x);
        low = fmin(low, p.y);
        high = fmax(high, p.y);
    }
    return hypot(fmax(0, fmax(left - x, x - right)), fmax(0, fmax(low - y, y - high)));
}

double mt_curves_distance(const mt_outline *outline, double x, double y) {
    double best = INFINITY;
    for (int c = 0; c < outline->count; c++)
        for (int i = 0; i < outline->contours[c].count; i++)
            if (box_distance(&outline->contours[c], i, x, y) < best)
                best = fmin(best, segment_distance(&outline->contours[c], i, x, y));
    return best;
}

mt_outline mt_curves_outline(mt_arena *arena, const mt_contour *contour) {
    mt_outline outline = {1, mt_arena_new(arena, 1, sizeof(mt_contour))};
    assert_non_null(outline.contours);
    outline.contours[0] = *contour;
    return outline;
}

static mt_point polar(double angle, double radius) {
    return (mt_point){(int32_t)lround(radius * cos(angle)), (int32_t)lround(radius * sin(angle))};
}

static mt_point beyond(mt_point from, mt_point through) {
    return (mt_point){through.x + (through.x - from.x) / 3, through.y + (through.y - from.y) / 3};
}

mt_contour mt_random_contour(mt_random *random, mt_arena *arena, int count, int extent) {
    mt_contour contour = {count, mt_arena_new(arena, (size_t)count, sizeof(mt_segment))};
    assert_non_null(contour.segments);
    for (int i = 0; i < count; i++) {
        mt_segment *segment = &contour.segments[i];
        segment->degree = mt_random_between(random, 1, 3);
        for (int k = 1; k <= segment->degree; k++) {
            double angle = 2 * M_PI * (i + (double)k / segment->degree) / count;
            mt_point p = polar(angle, extent * (0.3 + 0.45 * mt_random_unit(random)));
            if (k == segment->degree)
                segment->end = p;
            else
                segment->control[k - 1] = p;
        }
        bool smooth =
            i > 0 && segment->degree > 1 && contour.segments[i - 1].degree > 1 && mt_random_one_in(random, 2);
        const mt_segment *before = &contour.segments[i > 0 ? i - 1 : 0];
        if (smooth) segment->control[0] = beyond(before->control[before->degree - 2], before->end);
    }
    return contour;
}
