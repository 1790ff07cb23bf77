#include "morph/lap.h"

#include <math.h>
#include <string.h>

#include "morph/place.h"

/* ---- one contour --------------------------------------------------------------------------------------- */

/* The points of a contour in order, those off the curve too. */
typedef struct mt_beads {
    int count;
    mt_point **points;
    mt_point *drawn;  /* where they were */
    mt_point *looked; /* where the contour is there: half-way along a curve for a point off it */
} mt_beads;

static mt_point half_way(mt_point start, const mt_segment *curve) {
    mt_point c = curve->control[0], end = curve->end;
    return (mt_point){start.x / 4 + c.x / 2 + end.x / 4, start.y / 4 + c.y / 2 + end.y / 4};
}

static void add(mt_beads *beads, mt_point *point, mt_point looked) {
    beads->points[beads->count] = point;
    beads->drawn[beads->count] = *point;
    beads->looked[beads->count++] = looked;
}

static mt_status string_beads(mt_contour *contour, mt_arena *arena, mt_beads *beads) {
    size_t room = 2 * (size_t)contour->count;
    *beads = (mt_beads){0, mt_arena_new(arena, room, sizeof *beads->points),
                        mt_arena_new(arena, room, sizeof *beads->drawn),
                        mt_arena_new(arena, room, sizeof *beads->looked)};
    if (!beads->points || !beads->drawn || !beads->looked) return MT_NO_MEMORY;
    mt_point start = contour->segments[contour->count - 1].end;
    for (int i = 0; i < contour->count; start = contour->segments[i++].end) {
        mt_segment *s = &contour->segments[i];
        if (s->degree == 2) add(beads, &s->control[0], half_way(start, s));
        add(beads, &s->end, s->end);
    }
    return MT_OK;
}

/* The next point from i on, in steps of `by`, that is somewhere else; i's own where there is none. */
static mt_point neighbour(const mt_beads *beads, int i, int by) {
    mt_point p = beads->drawn[i];
    for (int k = 1; k < beads->count; k++) {
        mt_point q = beads->drawn[(i + k * by + (by < 0 ? beads->count : 0)) % beads->count];
        if (!mt_point_equal(p, q)) return q;
    }
    return p;
}

/* Ink is to the left of a contour: to the right is out of it. */
static mt_point moved_out(const mt_beads *beads, int i, double reach) {
    mt_point p = beads->drawn[i], before = neighbour(beads, i, -1), after = neighbour(beads, i, 1);
    double dx = (double)after.x - before.x, dy = (double)after.y - before.y, length = hypot(dx, dy);
    if (length <= 0) return p;
    return (mt_point){p.x + (int32_t)lround(reach * dy / length), p.y - (int32_t)lround(reach * dx / length)};
}

static mt_status lap_contour(const mt_shape *ink, double reach, mt_arena *arena, mt_contour *contour) {
    mt_beads beads;
    mt_arena_place before = mt_arena_mark(arena);
    mt_status status = string_beads(contour, arena, &beads);
    for (int i = 0; status == MT_OK && i < beads.count; i++)
        if (mt_is_deep_in_ink(ink, beads.looked[i], 2 * reach))
            *beads.points[i] = moved_out(&beads, i, reach);
    mt_arena_rewind(arena, before);
    return status;
}

/* ---- all of them --------------------------------------------------------------------------------------- */

static mt_status copy(mt_contour *contour, mt_arena *arena) {
    mt_segment *segments = mt_arena_new(arena, (size_t)contour->count, sizeof *segments);
    if (!segments) return MT_NO_MEMORY;
    memcpy(segments, contour->segments, (size_t)contour->count * sizeof *segments);
    contour->segments = segments;
    return MT_OK;
}

mt_status mt_moving_lap(const mt_morph *morph, double reach, mt_arena *arena, mt_moving *moving) {
    mt_status status = MT_OK;
    for (int i = 0; i < moving->count && status == MT_OK; i++) {
        mt_masters *masters = &moving->contours[i];
        status = copy(&masters->a, arena);
        if (status == MT_OK) status = copy(&masters->b, arena);
        if (status == MT_OK) status = lap_contour(&morph->a.whole, reach, arena, &masters->a);
        if (status == MT_OK) status = lap_contour(&morph->b.whole, reach, arena, &masters->b);
    }
    return status;
}
