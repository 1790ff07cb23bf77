/* A ring is compared with its mirror image: O(n²) for n points, up to POINTS_MAX of them. */
#include "motion/symmetry.h"

#include <math.h>

#include "geometry/limits.h"

/* How far a border and its mirror image may be apart, 1/1000 em: chords of the same curve are not the same from both ends. */
#define ALIKE_WITHIN 1.0

#define POINTS_MAX 4096

/* Whether the place, mirrored, is on the ring. */
static bool has_image(const mt_ring *ring, mt_point p, int32_t both_sides) {
    double within = mt_grid_units(ALIKE_WITHIN), way[2];
    const mt_point image = {both_sides - p.x, p.y};
    for (int i = 0; i < ring->count; i++)
        if (mt_way_to_edge(image, ring->points[i], ring->points[(i + 1) % ring->count], way) <= within)
            return true;
    return false;
}

/* Where the ring meets the axis, x = both_sides / 2, from above; how many, of which `ends` has the first two. */
static int meet_axis(const mt_ring *ring, int32_t both_sides, mt_point ends[2]) {
    int count = 0;
    for (int i = 0; i < ring->count; i++) {
        mt_point p = ring->points[i], q = ring->points[(i + 1) % ring->count];
        int64_t from = 2 * (int64_t)p.x - both_sides, to = 2 * (int64_t)q.x - both_sides;
        if ((from < 0) == (to < 0)) continue;
        if (count < 2)
            ends[count] =
                (mt_point){both_sides / 2, (int32_t)(p.y + ((int64_t)q.y - p.y) * from / (from - to))};
        count++;
    }
    if (count >= 2 && ends[0].y < ends[1].y) {
        mt_point low = ends[0];
        ends[0] = ends[1];
        ends[1] = low;
    }
    return count;
}

static bool find_axis(const mt_shape *shape, mt_point ends[2]) {
    if (shape->count != 1 || shape->components[0].count != 1) return false;
    const mt_ring *ring = &shape->components[0].rings[0];
    mt_box box = mt_ring_box(ring);
    int32_t both_sides = box.min.x + box.max.x;
    if (ring->count > POINTS_MAX || meet_axis(ring, both_sides, ends) != 2) return false;
    for (int i = 0; i < ring->count; i++)
        if (!has_image(ring, ring->points[i], both_sides)) return false;
    return true;
}

mt_axis_hints mt_axis_hints_of(const mt_shape *a, const mt_shape *b) {
    mt_point of_a[2], of_b[2];
    mt_axis_hints made = {0};
    if (!find_axis(a, of_a) || !find_axis(b, of_b)) return made;
    for (; made.count < 2; made.count++)
        made.list[made.count] = (mt_hint){MT_HINT_POINT, of_a[made.count], of_b[made.count]};
    return made;
}

/* ---- contours -------------------------------------------------------------------------------------------- */

/* How far a contour's point may be from the axis and be on it, grid units. */
#define ON_AXIS 256

static bool is_near(mt_point p, mt_point q) {
    return hypot((double)p.x - q.x, (double)p.y - q.y) <= ON_AXIS;
}

/* The segment that ends where both shapes meet their axes; -1 for none. */
static int find_end(const mt_contour_pair *pair, const mt_hint *where) {
    for (int i = 0; i < pair->a.count; i++)
        if (is_near(pair->a.segments[i].end, where->a) && is_near(pair->b.segments[i].end, where->b))
            return i;
    return -1;
}

/* How far the ends of segments after `from`, up to `to`, go on average, both axes put into one place. */
static double way_of(const mt_contour_pair *pair, const mt_axis_hints *hints, int from, int to) {
    double apart = (double)hints->list[0].b.x - hints->list[0].a.x, sum = 0;
    int count = 0;
    for (int i = (from + 1) % pair->a.count; i != to; i = (i + 1) % pair->a.count, count++) {
        mt_point p = pair->a.segments[i].end, q = pair->b.segments[i].end;
        sum += hypot((double)q.x - p.x - apart, (double)q.y - p.y);
    }
    return count ? sum / count : INFINITY;
}

static mt_point image_of(mt_point p, int32_t axis) {
    return (mt_point){2 * axis - p.x, p.y};
}

/* The segments after `from`, up to `to`, and back on the other side of the axis. */
static mt_status mirror(const mt_contour *contour, int from, int to, mt_point start, mt_point middle,
                        mt_arena *arena, mt_contour *mirrored) {
    int count = contour->count, half = (to - from + count) % count, k = 0;
    mt_segment *segments = mt_arena_new(arena, 2 * (size_t)half, sizeof *segments);
    if (!segments) return MT_NO_MEMORY;
    for (; k < half; k++) segments[k] = contour->segments[(from + 1 + k) % count];
    segments[half - 1].end = middle;
    for (; k < 2 * half; k++) {
        int i = 2 * half - 1 - k;
        const mt_segment *s = &segments[i];
        mt_segment *image = &segments[k];
        *image = (mt_segment){.degree = s->degree, .end = i ? image_of(segments[i - 1].end, start.x) : start};
        for (int c = 0; c < s->degree - 1; c++)
            image->control[c] = image_of(s->control[s->degree - 2 - c], start.x);
    }
    *mirrored = (mt_contour){2 * half, segments};
    return MT_OK;
}

mt_status mt_axis_mirror(const mt_axis_hints *hints, mt_variable_outline *contours, mt_arena *arena) {
    mt_contour_pair *pair = contours->contours, made = {0};
    if (hints->count != 2 || contours->count != 1 || pair->displacement.x || pair->displacement.y)
        return MT_OK;
    int from = find_end(pair, &hints->list[0]), to = find_end(pair, &hints->list[1]);
    if (from < 0 || to < 0 || from == to) return MT_OK;
    bool other = way_of(pair, hints, to, from) < way_of(pair, hints, from, to);
    const mt_hint *start = &hints->list[other], *middle = &hints->list[!other];
    int first = other ? to : from, last = other ? from : to;
    mt_status status = mirror(&pair->a, first, last, start->a, middle->a, arena, &made.a);
    if (status == MT_OK) status = mirror(&pair->b, first, last, start->b, middle->b, arena, &made.b);
    if (status == MT_OK) *pair = made;
    return status;
}
