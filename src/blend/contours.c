/* A contour's points are rounded at every place, then thinned: a point goes only where it may go at all places, so that the
 * contour has the same points at each. One place is the case of a static font. */
#include "blend/contours.h"

#include <math.h>
#include <stdlib.h>

#include "geometry/limits.h"

typedef struct mt_contour_maker {
    const mt_outline *drawn; /* at each place */
    int places, units;
    bool too_large;
    int count; /* of the points of the contour at hand, forwards */
    mt_glyf_point **points;
} mt_contour_maker;

int mt_track_segment_points(const mt_track_segment *segment) {
    return segment->contour_count ? segment->ends[segment->contour_count - 1] + 1 : 0;
}

/* ---- points on whole units ----------------------------------------------------------------------------- */

static int16_t scaled(mt_contour_maker *maker, int32_t v) {
    double units = floor((double)v * maker->units / MT_EM + 0.5);
    bool fits = units >= INT16_MIN && units <= INT16_MAX;
    maker->too_large = maker->too_large || !fits;
    return fits ? (int16_t)units : 0;
}

/* Whether two points of the contour are on the curve and in the same place, at every place. */
static bool are_same(const mt_contour_maker *maker, int i, int k) {
    for (int place = 0; place < maker->places; place++) {
        const mt_glyf_point *p = &maker->points[place][i], *q = &maker->points[place][k];
        if (!p->on || !q->on || p->x != q->x || p->y != q->y) return false;
    }
    return true;
}

/* A segment's end, or its control point. */
static void add(mt_contour_maker *maker, int contour, int segment, bool on) {
    for (int place = 0; place < maker->places; place++) {
        const mt_segment *s = &maker->drawn[place].contours[contour].segments[segment];
        mt_point p = on ? s->end : s->control[0];
        maker->points[place][maker->count] = (mt_glyf_point){scaled(maker, p.x), scaled(maker, p.y), on};
    }
    if (maker->count == 0 || !are_same(maker, maker->count, maker->count - 1)) maker->count++;
}

static void trace_contour(mt_contour_maker *maker, int contour) {
    const mt_contour *first = &maker->drawn[0].contours[contour];
    maker->count = 0;
    for (int i = 0; i < first->count; i++) {
        if (first->segments[i].degree == 2) add(maker, contour, i, false);
        add(maker, contour, i, true);
    }
    /* The last point ends the contour where its first segment starts. */
    if (maker->count > 1 && are_same(maker, 0, maker->count - 1)) maker->count--;
}

/* ---- what is left out ---------------------------------------------------------------------------------- */

/* Twice the area that the points of p and q, added up, enclose. */
static int64_t area_of_sum(const mt_glyf_point *p, const mt_glyf_point *q, int count) {
    int64_t area = 0;
    for (int i = 0, k = count - 1; i < count; k = i++)
        area +=
            (int64_t)(p[k].x + q[k].x) * (p[i].y + q[i].y) - (int64_t)(p[i].x + q[i].x) * (p[k].y + q[k].y);
    return area;
}

/* Whether there is an area at some place or half-way between two. On a straight way the area is quadratic in T, so that one
 * without any at three places has none at all. */
static bool has_area(const mt_contour_maker *maker) {
    for (int i = 0; i < maker->places; i++) {
        const mt_glyf_point *p = maker->points[i], *q = maker->points[i ? i - 1 : 0];
        if (area_of_sum(p, p, maker->count) != 0 || area_of_sum(p, q, maker->count) != 0) return true;
    }
    return false;
}

/* A point on the curve halfway between two off it need not be written: the rasterizer puts it there (OpenType, 'glyf').
 * Half a unit beside it is where rounding may have put it. Where that holds at every place it holds in between. */
static bool is_implied(const mt_contour_maker *maker, int i) {
    int before = (i + maker->count - 1) % maker->count, after = (i + 1) % maker->count;
    for (int place = 0; place < maker->places; place++) {
        const mt_glyf_point *points = maker->points[place], *a = &points[before], *p = &points[i],
                            *b = &points[after];
        if (a->on || !p->on || b->on || abs(2 * p->x - a->x - b->x) > 1 || abs(2 * p->y - a->y - b->y) > 1)
            return false;
    }
    return true;
}

/* The contour at hand, backwards, since our outer rings are anticlockwise and 'glyf' fills to the right. Its first point
 * stays. */
static void write_reversed(const mt_contour_maker *maker, mt_track_segment *segment) {
    int end = mt_track_segment_points(segment);
    for (int i = maker->count - 1; i >= 0; i--) {
        if (i + 1 < maker->count && is_implied(maker, i)) continue;
        for (int place = 0; place < maker->places; place++)
            segment->points[place][end] = maker->points[place][i];
        end++;
    }
    segment->ends[segment->contour_count++] = end - 1;
}

/* ---- the contours -------------------------------------------------------------------------------------- */

static mt_status new_rows(int places, size_t room, mt_arena *arena, mt_glyf_point ***points) {
    *points = mt_arena_new(arena, (size_t)places, sizeof **points);
    if (!*points) return MT_NO_MEMORY;
    for (int i = 0; i < places; i++) {
        (*points)[i] = mt_arena_new(arena, room, sizeof ***points);
        if (!(*points)[i]) return MT_NO_MEMORY;
    }
    return MT_OK;
}

static mt_status start(mt_contour_maker *maker, mt_arena *kept, mt_arena *scratch,
                       mt_track_segment *segment) {
    size_t most = 0, longest = 0;
    for (int i = 0; i < maker->drawn->count; i++) {
        size_t room = 2 * (size_t)maker->drawn->contours[i].count;
        most += room;
        if (room > longest) longest = room;
    }
    segment->ends = mt_arena_new(kept, (size_t)maker->drawn->count, sizeof(int));
    if (!segment->ends) return MT_NO_MEMORY;
    mt_status status = new_rows(maker->places, longest, scratch, &maker->points);
    return status == MT_OK ? new_rows(maker->places, most, kept, &segment->points) : status;
}

mt_status mt_track_segment_make(const mt_outline *drawn, const int *places, int count, int units,
                                mt_arena *kept, mt_arena *scratch, mt_track_segment *segment) {
    mt_track_segment made = {.place_count = count, .places = places};
    mt_contour_maker maker = {.drawn = drawn, .places = count, .units = units};
    mt_status status = start(&maker, kept, scratch, &made);
    if (status != MT_OK) return status;
    for (int i = 0; i < drawn->count; i++) {
        trace_contour(&maker, i);
        if (has_area(&maker)) write_reversed(&maker, &made);
    }
    bool fits = !maker.too_large && mt_track_segment_points(&made) <= MT_GLYF_POINTS_MAX &&
                made.contour_count <= MT_GLYF_CONTOURS_MAX;
    if (fits) *segment = made;
    return fits ? MT_OK : MT_TOO_LARGE;
}

mt_status mt_outline_glyf(const mt_outline *outline, int units, mt_arena *arena, mt_glyf *glyf) {
    mt_track_segment made;
    mt_status status = mt_track_segment_make(outline, NULL, 1, units, arena, arena, &made);
    if (status != MT_OK) return status;
    *glyf = (mt_glyf){.contour_count = made.contour_count, .ends = made.ends, .points = made.points[0]};
    return MT_OK;
}

mt_status mt_glyf_take_room(mt_glyph_room room, int units, mt_glyf *glyf) {
    double width = floor(room.advance * units / MT_EM + 0.5);
    double height = floor(room.vertical.advance * units / MT_EM + 0.5);
    double origin = floor(room.vertical.origin * units / MT_EM + 0.5);
    if (width < 0 || width > UINT16_MAX) return MT_TOO_LARGE;
    glyf->advance = (uint16_t)width;
    glyf->height = (uint16_t)fmin(fmax(height, 0), UINT16_MAX);
    glyf->origin = (int16_t)fmin(fmax(origin, INT16_MIN), INT16_MAX);
    return MT_OK;
}
