/* From outlines on the grid to 'glyf' contours in font units. */
#include <math.h>
#include <stdlib.h>

#include "blend/pair.h"
#include "geometry/limits.h"

typedef struct mt_glyf_maker {
    mt_glyf_point *points; /* of the contour at hand */
    int count;
    int units;
    bool too_large;
} mt_glyf_maker;

static int16_t scaled(mt_glyf_maker *maker, int32_t v) {
    double units = floor((double)v * maker->units / MT_EM + 0.5);
    if (units < INT16_MIN || units > INT16_MAX) {
        maker->too_large = true;
        return 0;
    }
    return (int16_t)units;
}

static void add(mt_glyf_maker *maker, mt_point p, bool on) {
    mt_glyf_point point = {scaled(maker, p.x), scaled(maker, p.y), on};
    mt_glyf_point *last = maker->count ? &maker->points[maker->count - 1] : NULL;
    bool same = last && last->x == point.x && last->y == point.y && last->on && on;
    if (!same) maker->points[maker->count++] = point;
}

/* A point on the curve halfway between two off it need not be written: the rasterizer puts it there
 * (OpenType, 'glyf'). Half a unit beside it is where rounding may have put it. */
static bool is_implied(mt_glyf_point a, mt_glyf_point p, mt_glyf_point b) {
    return !a.on && p.on && !b.on && abs(2 * p.x - a.x - b.x) <= 1 && abs(2 * p.y - a.y - b.y) <= 1;
}

/* The contour at hand, backwards, since our outer rings are anticlockwise and 'glyf' fills to the right. The
 * first point stays on the curve. Returns how many points were written. */
static int write_reversed(const mt_glyf_maker *maker, mt_glyf_point *to) {
    int n = maker->count, written = 0;
    for (int k = 0; k < n; k++) {
        int i = n - 1 - k;
        mt_glyf_point before = maker->points[(i + n - 1) % n], p = maker->points[i],
                      after = maker->points[(i + 1) % n];
        if (k == 0 || !is_implied(before, p, after)) to[written++] = p;
    }
    return written;
}

static void trace_contour(mt_glyf_maker *maker, const mt_contour *contour) {
    maker->count = 0;
    for (int i = 0; i < contour->count; i++) {
        const mt_segment *segment = &contour->segments[i];
        if (segment->degree == 2) add(maker, segment->control[0], false);
        add(maker, segment->end, true);
    }
    if (maker->count > 1) { /* the last point ends the contour where its first segment starts */
        mt_glyf_point first = maker->points[0], last = maker->points[maker->count - 1];
        if (first.on && first.x == last.x && first.y == last.y) maker->count--;
    }
}

static bool has_area(const mt_glyf_maker *maker) {
    int64_t area2 = 0;
    for (int i = 0; i < maker->count; i++) {
        mt_glyf_point p = maker->points[i], q = maker->points[(i + 1) % maker->count];
        area2 += (int64_t)p.x * q.y - (int64_t)p.y * q.x;
    }
    return area2 != 0;
}

mt_status mt_outline_glyf(const mt_outline *outline, double advance, int units, mt_arena *arena,
                          mt_glyf *glyf) {
    size_t most = 0, longest = 0;
    for (int i = 0; i < outline->count; i++) {
        size_t n = 2 * (size_t)outline->contours[i].count;
        most += n;
        if (n > longest) longest = n;
    }
    double width = floor(advance * units / MT_EM + 0.5);
    if (width < 0 || width > UINT16_MAX) return MT_TOO_LARGE;
    mt_glyf made = {.advance = (uint16_t)width,
                    .ends = mt_arena_new(arena, (size_t)outline->count, sizeof(int)),
                    .points = mt_arena_new(arena, most, sizeof(mt_glyf_point))};
    mt_glyf_maker maker = {.points = mt_arena_new(arena, longest, sizeof(mt_glyf_point)), .units = units};
    if (!made.ends || !made.points || !maker.points) return MT_NO_MEMORY;
    int count = 0;
    for (int i = 0; i < outline->count; i++) {
        trace_contour(&maker, &outline->contours[i]);
        if (!has_area(&maker)) continue;
        count += write_reversed(&maker, made.points + count);
        made.ends[made.contour_count++] = count - 1;
    }
    if (maker.too_large || count > MT_GLYF_POINTS_MAX || made.contour_count > MT_GLYF_CONTOURS_MAX)
        return MT_TOO_LARGE;
    *glyf = made;
    return MT_OK;
}

void mt_glyf_hang(mt_vertical vertical, int units, mt_glyf *glyf) {
    double height = floor(vertical.advance * units / MT_EM + 0.5);
    double origin = floor(vertical.origin * units / MT_EM + 0.5);
    glyf->height = (uint16_t)fmin(fmax(height, 0), UINT16_MAX);
    glyf->origin = (int16_t)fmin(fmax(origin, INT16_MIN), INT16_MAX);
}
