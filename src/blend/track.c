#include "blend/track.h"

#include <math.h>
#include <stdlib.h>

#include "geometry/limits.h"

/* One contour at every place, and which of its points are kept. */
typedef struct mt_strand {
    int places, count;
    mt_glyf_point **points; /* at each place */
    bool *kept;
} mt_strand;

typedef struct mt_fit_path {
    const mt_outline *drawn;
    int units;
    mt_arena *scratch;
    mt_strand strand; /* of the contour at hand; has room for the longest */
    bool too_large;
} mt_fit_path;

int mt_span_point_count(const mt_span *span) {
    return span->contour_count ? span->ends[span->contour_count - 1] + 1 : 0;
}

/* ---- points on whole units ----------------------------------------------------------------------------- */

static int16_t scaled(mt_fit_path *spinner, int32_t v) {
    double units = floor((double)v * spinner->units / MT_EM + 0.5);
    bool fits = units >= INT16_MIN && units <= INT16_MAX;
    spinner->too_large = spinner->too_large || !fits;
    return fits ? (int16_t)units : 0;
}

static mt_glyf_point point_of(mt_fit_path *spinner, mt_point p, bool on) {
    return (mt_glyf_point){scaled(spinner, p.x), scaled(spinner, p.y), on};
}

/* The points of a contour, backwards, since our outer rings are anticlockwise and 'glyf' fills to the right. The last
 * segment's end comes first: it is on the curve. */
static int list_points(mt_fit_path *spinner, const mt_contour *contour, mt_glyf_point *points) {
    int count = 0;
    for (int i = contour->count - 1; i >= 0; i--) {
        const mt_segment *segment = &contour->segments[i];
        points[count++] = point_of(spinner, segment->end, true);
        if (segment->degree == 2) points[count++] = point_of(spinner, segment->control[0], false);
    }
    return count;
}

static void read_strand(mt_fit_path *spinner, int contour) {
    mt_strand *strand = &spinner->strand;
    for (int i = 0; i < strand->places; i++)
        strand->count = list_points(spinner, &spinner->drawn[i].contours[contour], strand->points[i]);
    for (int k = 0; k < strand->count; k++) strand->kept[k] = true;
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
static bool has_area(const mt_strand *strand) {
    for (int i = 0; i < strand->places; i++) {
        const mt_glyf_point *p = strand->points[i], *q = strand->points[i ? i - 1 : 0];
        if (area_of_sum(p, p, strand->count) != 0 || area_of_sum(p, q, strand->count) != 0) return true;
    }
    return false;
}

static bool are_same(const mt_strand *strand, int i, int k) {
    for (int place = 0; place < strand->places; place++) {
        const mt_glyf_point *p = &strand->points[place][i], *q = &strand->points[place][k];
        if (!p->on || !q->on || p->x != q->x || p->y != q->y) return false;
    }
    return true;
}

/* A point on the curve halfway between two off it, or half a unit beside it where rounding may have put it, at every place:
 * so it is at every place in between. */
static bool is_implied(const mt_strand *strand, int i) {
    int before = i - 1, after = (i + 1) % strand->count;
    for (int place = 0; place < strand->places; place++) {
        const mt_glyf_point *points = strand->points[place], *a = &points[before], *p = &points[i],
                            *b = &points[after];
        if (a->on || !p->on || b->on || abs(2 * p->x - a->x - b->x) > 1 || abs(2 * p->y - a->y - b->y) > 1)
            return false;
    }
    return true;
}

/* All but the first. */
static void leave_out(mt_strand *strand) {
    for (int i = 1; i < strand->count; i++)
        strand->kept[i] = !are_same(strand, i, i - 1) && !is_implied(strand, i);
}

/* ---- the span ------------------------------------------------------------------------------------------ */

static void add_strand(const mt_strand *strand, mt_span *span) {
    int end = mt_span_point_count(span);
    for (int i = 0; i < strand->count; i++) {
        if (!strand->kept[i]) continue;
        for (int place = 0; place < strand->places; place++)
            span->points[place][end] = strand->points[place][i];
        end++;
    }
    span->ends[span->contour_count++] = end - 1;
}

static mt_status new_rows(int places, size_t room, mt_arena *arena, mt_glyf_point ***points) {
    *points = mt_arena_new(arena, (size_t)places, sizeof **points);
    if (!*points) return MT_NO_MEMORY;
    for (int i = 0; i < places; i++) {
        (*points)[i] = mt_arena_new(arena, room, sizeof ***points);
        if (!(*points)[i]) return MT_NO_MEMORY;
    }
    return MT_OK;
}

static mt_status start(mt_fit_path *spinner, int places, mt_arena *kept, mt_span *span) {
    size_t most = 0, longest = 0;
    for (int i = 0; i < spinner->drawn->count; i++) {
        size_t room = 2 * (size_t)spinner->drawn->contours[i].count;
        most += room;
        if (room > longest) longest = room;
    }
    spinner->strand.places = places;
    spinner->strand.kept = mt_arena_new(spinner->scratch, longest, sizeof(bool));
    span->ends = mt_arena_new(kept, (size_t)spinner->drawn->count, sizeof(int));
    if (!spinner->strand.kept || !span->ends) return MT_NO_MEMORY;
    mt_status status = new_rows(places, longest, spinner->scratch, &spinner->strand.points);
    return status == MT_OK ? new_rows(places, most, kept, &span->points) : status;
}

mt_status mt_span_make(const mt_outline *drawn, const int *places, int count, int units, mt_arena *kept,
                       mt_arena *scratch, mt_span *span) {
    mt_span made = {.place_count = count, .places = places};
    mt_fit_path spinner = {.drawn = drawn, .units = units, .scratch = scratch};
    mt_status status = start(&spinner, count, kept, &made);
    if (status != MT_OK) return status;
    for (int i = 0; i < drawn->count; i++) {
        read_strand(&spinner, i);
        if (!has_area(&spinner.strand)) continue;
        leave_out(&spinner.strand);
        add_strand(&spinner.strand, &made);
    }
    bool fits = !spinner.too_large && mt_span_point_count(&made) <= MT_GLYF_POINTS_MAX &&
                made.contour_count <= MT_GLYF_CONTOURS_MAX;
    if (fits) *span = made;
    return fits ? MT_OK : MT_TOO_LARGE;
}
