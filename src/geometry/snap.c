/* Snap rounding. Each point of the rings and each place where edges cross, rounded, stands in the middle of a pixel, a square whose side is a
 * grid unit, closed on the left and below; an edge is led through the middles of all pixels that it touches.
 *
 *     ┌───┐                    ┌───┐
 *     │ ● │                    │ ● │
 *     └─__┴──────── ──▶        └─/\┴────────    the edge passes the pixel of ●, and gets a corner there
 *     ──  ‾‾‾──                __/  ‾‾‾──
 *
 * All decisions are exact: coordinates are doubled, so that corners of pixels are whole and odd, and ends of edges even. */
#include "geometry/snap.h"

#include <stdlib.h>

#include "geometry/crossings.h"
#include "geometry/limits.h"

typedef struct mt_passed {
    int64_t along; /* the place, times the edge's length */
    mt_point place;
} mt_passed;

typedef struct mt_snapping {
    mt_arena *arena;
    mt_point *pixels; /* their middles, by y and x; each once */
    int pixel_count;
    mt_passed *passed; /* by the edge at hand, in its order */
    int passed_count, passed_room;
} mt_snapping;

static int by_height(const void *a, const void *b) {
    const mt_point *p = a, *q = b;
    return p->y != q->y ? (p->y > q->y) - (p->y < q->y) : (p->x > q->x) - (p->x < q->x);
}

/* ---- pixels ------------------------------------------------------------------------------------------------ */

static mt_status find_pixels(const mt_rings *rings, mt_snapping *s) {
    mt_point *crossings;
    int crossing_count;
    mt_status status = mt_list_crossings(rings, s->arena, &crossings, &crossing_count);
    if (status != MT_OK) return status;
    size_t most = (size_t)mt_rings_corners(rings) + (size_t)crossing_count, count = 0;
    s->pixels = mt_arena_new(s->arena, most + 1, sizeof *s->pixels);
    if (!s->pixels) return MT_NO_MEMORY;
    for (int i = 0; i < rings->count; i++)
        for (int k = 0; k < rings->rings[i].count; k++) s->pixels[count++] = rings->rings[i].points[k];
    for (int i = 0; i < crossing_count; i++) s->pixels[count++] = crossings[i];
    qsort(s->pixels, count, sizeof *s->pixels, by_height);
    for (size_t i = 0; i < count; i++)
        if (i == 0 || !mt_point_equal(s->pixels[i], s->pixels[i - 1]))
            s->pixels[s->pixel_count++] = s->pixels[i];
    return MT_OK;
}

/* The first pixel whose middle is not below y. */
static int first_from(const mt_snapping *s, int64_t y) {
    int low = 0, high = s->pixel_count;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (s->pixels[middle].y < y)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static int side_of(mt_point p, mt_point q, mt_point corner) {
    int64_t turn = mt_orient(p, q, corner);
    return (turn > 0) - (turn < 0);
}

static mt_point doubled(mt_point p) {
    return (mt_point){2 * p.x, 2 * p.y};
}

/* Whether the edge touches the pixel around `middle`. Its line passes the square if corners lie on both sides; one through a single corner
 * touches it only there, and of the corners the lower left alone is in it. */
static bool touches(mt_point start, mt_point end, mt_point middle) {
    mt_point p = doubled(start), q = doubled(end), m = doubled(middle);
    int left = m.x - 1, right = m.x + 1, below = m.y - 1, above = m.y + 1;
    bool apart = (p.x < left && q.x < left) || (p.x > right && q.x > right) || (p.y < below && q.y < below) ||
                 (p.y > above && q.y > above);
    if (apart) return false;
    int own = side_of(p, q, (mt_point){left, below});
    int sides[] = {own, side_of(p, q, (mt_point){right, below}), side_of(p, q, (mt_point){right, above}),
                   side_of(p, q, (mt_point){left, above})};
    bool any_left = false, any_right = false;
    for (int i = 0; i < 4; i++) {
        any_left = any_left || sides[i] > 0;
        any_right = any_right || sides[i] < 0;
    }
    return own == 0 || (any_left && any_right);
}

/* ---- edges ------------------------------------------------------------------------------------------------- */

static int by_place_along(const void *a, const void *b) {
    const mt_passed *p = a, *q = b;
    return (p->along > q->along) - (p->along < q->along);
}

/* The pixels that the edge touches, in its order, those of its ends too. */
static mt_status pass(mt_snapping *s, mt_point start, mt_point end) {
    int64_t low = start.y < end.y ? start.y : end.y, high = start.y < end.y ? end.y : start.y;
    int first = first_from(s, low), last = first_from(s, high + 1);
    if (!mt_arena_spend(s->arena, last - first)) return MT_TOO_LARGE;
    s->passed_count = 0;
    for (int i = first; i < last; i++) {
        mt_point middle = s->pixels[i];
        if (!touches(start, end, middle)) continue;
        mt_passed *passed =
            mt_arena_grow_list(s->arena, s->passed, s->passed_count, &s->passed_room, sizeof *passed);
        if (!passed) return MT_NO_MEMORY;
        s->passed = passed;
        passed[s->passed_count++] = (mt_passed){mt_dot(start, end, start, middle), middle};
    }
    qsort(s->passed, (size_t)s->passed_count, sizeof *s->passed, by_place_along);
    return MT_OK;
}

static bool add_point(mt_snapping *s, mt_ring *made, int *room, mt_point p, uint8_t marks) {
    if (made->count > 0 && mt_point_equal(made->points[made->count - 1], p)) {
        made->marks[made->count - 1] = marks;
        return true;
    }
    int marks_room = *room;
    mt_point *points = mt_arena_grow_list(s->arena, made->points, made->count, room, sizeof *points);
    uint8_t *all_marks =
        mt_arena_grow_list(s->arena, made->marks, made->count, &marks_room, sizeof *all_marks);
    if (!points || !all_marks) return false;
    made->points = points;
    made->marks = all_marks;
    points[made->count] = p;
    all_marks[made->count++] = marks;
    return true;
}

static mt_status snap_ring(mt_snapping *s, const mt_ring *ring, mt_ring *snapped) {
    mt_ring made = {0};
    int room = 0;
    for (int k = 0; k < ring->count; k++) {
        uint8_t marks = ring->marks[k];
        mt_status status = pass(s, ring->points[k], ring->points[(k + 1) % ring->count]);
        if (status != MT_OK) return status;
        for (int i = 0; i + 1 < s->passed_count; i++) { /* without the end, which the next edge has */
            if (!add_point(s, &made, &room, s->passed[i].place, marks)) return MT_NO_MEMORY;
            marks = MT_CROSSING | (marks & MT_EDGE_MARKS);
        }
    }
    if (made.count > 1 && mt_point_equal(made.points[0], made.points[made.count - 1])) made.count--;
    *snapped = made;
    return MT_OK;
}

mt_status mt_snap_rings(const mt_rings *rings, mt_arena *arena, mt_rings *snapped) {
    mt_snapping s = {.arena = arena};
    mt_rings made = {0, mt_arena_new(arena, (size_t)rings->count + 1, sizeof *made.rings)};
    if (!made.rings) return MT_NO_MEMORY;
    mt_status status = find_pixels(rings, &s);
    for (int i = 0; status == MT_OK && i < rings->count; i++) {
        status = snap_ring(&s, &rings->rings[i], &made.rings[made.count]);
        if (status == MT_OK && made.rings[made.count].count > 1) made.count++;
    }
    if (status == MT_OK) *snapped = made;
    return status;
}
