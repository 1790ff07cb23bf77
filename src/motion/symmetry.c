/* A ring is compared with its mirror image: O(n²) for n points, up to POINTS_MAX of them. */
#include "motion/symmetry.h"

#include <math.h>

#include "arithmetic/angles.h"
#include "geometry/limits.h"
#include "geometry/union.h"

/* How far a border and its mirror image may be apart, 1/1000 em: chords of the same curve are not the same from both ends. */
#define ALIKE_WITHIN 1.0

#define POINTS_MAX 4096

/* Whether the place, mirrored, is on a border of the shape. */
static bool has_image(const mt_rings *rings, mt_point p, int32_t both_sides) {
    double within = mt_grid_units(ALIKE_WITHIN), way[2];
    const mt_point image = {both_sides - p.x, p.y};
    for (int r = 0; r < rings->count; r++)
        for (int i = 0; i < rings->rings[r].count; i++) {
            const mt_ring *ring = &rings->rings[r];
            mt_point from = ring->points[i], to = ring->points[(i + 1) % ring->count];
            if (mt_way_to_edge(image, from, to, way) <= within) return true;
        }
    return false;
}

/* Whether the shape is alike on both sides of the middle of its box, x = *both_sides / 2. */
static bool is_alike(const mt_rings *rings, int32_t *both_sides) {
    mt_box box = mt_ring_box(&rings->rings[0]);
    int points = 0;
    for (int r = 0; r < rings->count; r++) {
        mt_box more = mt_ring_box(&rings->rings[r]);
        if (more.min.x < box.min.x) box.min.x = more.min.x;
        if (more.max.x > box.max.x) box.max.x = more.max.x;
        points += rings->rings[r].count;
    }
    *both_sides = box.min.x + box.max.x;
    if (points > POINTS_MAX) return false;
    for (int r = 0; r < rings->count; r++)
        for (int i = 0; i < rings->rings[r].count; i++)
            if (!has_image(rings, rings->rings[r].points[i], *both_sides)) return false;
    return true;
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
    const mt_rings rings = {1, &shape->components[0].rings[0]};
    int32_t both_sides;
    return is_alike(&rings, &both_sides) && meet_axis(&rings.rings[0], both_sides, ends) == 2;
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
    return mt_hypot((double)p.x - q.x, (double)p.y - q.y) <= ON_AXIS;
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
        sum += mt_hypot((double)q.x - p.x - apart, (double)q.y - p.y);
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

mt_status mt_axis_mirror(const mt_axis_hints *hints, mt_variable_outline *contours, mt_arena *arena,
                         bool *done) {
    mt_contour_pair *pair = contours->contours, made = {0};
    *done = false;
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
    *done = status == MT_OK;
    return status;
}

/* ---- halves ------------------------------------------------------------------------------------------------ */

/* Where an edge meets the axis. */
static mt_point on_axis(mt_point p, mt_point q, int32_t axis) {
    int64_t across = (int64_t)q.x - p.x;
    return (mt_point){axis, (int32_t)(p.y + ((int64_t)q.y - p.y) * ((int64_t)axis - p.x) / across)};
}

static void add(mt_ring *ring, mt_point p, uint8_t mark) {
    ring->points[ring->count] = p;
    ring->marks[ring->count++] = mark;
}

/* What a ring encloses to the right of the axis; along the axis the ring may lie over itself. */
static mt_status cut_ring(const mt_ring *ring, int32_t axis, mt_arena *arena, mt_ring *half) {
    mt_status status = mt_ring_new(arena, 2 * ring->count, half);
    if (status != MT_OK) return status;
    half->count = 0;
    for (int i = 0; i < ring->count; i++) {
        mt_point p = ring->points[i], q = ring->points[(i + 1) % ring->count];
        uint8_t edge = ring->marks[i] & MT_EDGE_MARKS;
        if (p.x >= axis)
            add(half, p, p.x > axis ? ring->marks[i] : MT_CORNER | (q.x < axis ? MT_LINE : edge));
        if (p.x > axis && q.x < axis) add(half, on_axis(p, q, axis), MT_CORNER | MT_LINE);
        if (p.x < axis && q.x > axis) add(half, on_axis(p, q, axis), MT_CORNER | edge);
    }
    return MT_OK;
}

static mt_status cut_shape(const mt_rings *rings, int32_t axis, mt_arena *arena, mt_shape *half) {
    mt_rings cut = {0, mt_arena_new(arena, (size_t)rings->count, sizeof(mt_ring))};
    if (!cut.rings) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (int i = 0; i < rings->count && status == MT_OK; i++) {
        status = cut_ring(&rings->rings[i], axis, arena, &cut.rings[cut.count]);
        cut.count += cut.rings[cut.count].count >= 3;
    }
    return status == MT_OK ? mt_union(&cut, MT_NONZERO, arena, half) : status;
}

/* The highest and the lowest place on the axis, as hints that they go together, where both halves have some. */
static bool find_ends(const mt_rings *rings, int32_t axis, mt_point ends[2]) {
    int count = 0;
    for (int r = 0; r < rings->count; r++)
        for (int i = 0; i < rings->rings[r].count; i++) {
            mt_point p = rings->rings[r].points[i];
            if (p.x != axis) continue;
            if (count == 0 || p.y > ends[0].y) ends[0] = p;
            if (count == 0 || p.y < ends[1].y) ends[1] = p;
            count++;
        }
    return count >= 2;
}

static mt_status half_of(const mt_shape *shape, mt_arena *arena, int32_t *axis, mt_shape *half,
                         mt_point ends[2], bool *meets) {
    mt_rings rings;
    int32_t both_sides;
    mt_status status = mt_shape_rings(shape, arena, &rings);
    half->count = 0;
    if (status != MT_OK || rings.count == 0 || !is_alike(&rings, &both_sides)) return status;
    *axis = both_sides / 2;
    status = cut_shape(&rings, *axis, arena, half);
    if (status == MT_OK) status = mt_shape_rings(half, arena, &rings);
    *meets = status == MT_OK && find_ends(&rings, *axis, ends);
    return status;
}

mt_status mt_halves_of(const mt_shape *a, const mt_shape *b, mt_arena *arena, mt_halves *halves) {
    mt_point of_a[2], of_b[2];
    bool a_meets, b_meets;
    *halves = (mt_halves){0};
    mt_status status = half_of(a, arena, &halves->axis_a, &halves->a, of_a, &a_meets);
    if (status == MT_OK && halves->a.count > 0)
        status = half_of(b, arena, &halves->axis_b, &halves->b, of_b, &b_meets);
    halves->alike = status == MT_OK && halves->a.count > 0 && halves->b.count > 0;
    for (int i = 0; halves->alike && a_meets && b_meets && i < 2; i++)
        halves->hints.list[halves->hints.count++] = (mt_hint){MT_HINT_POINT, of_a[i], of_b[i]};
    return status;
}

/* The mirror image of a contour, the other way round. */
static mt_status image_of_contour(const mt_contour *contour, int32_t axis, mt_arena *arena,
                                  mt_contour *image) {
    int count = contour->count;
    *image = (mt_contour){count, mt_arena_new(arena, (size_t)count, sizeof(mt_segment))};
    if (!image->segments) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) {
        const mt_segment *s = &contour->segments[count - 1 - i],
                         *before = &contour->segments[(2 * count - 2 - i) % count];
        mt_segment *made = &image->segments[i];
        *made = (mt_segment){.degree = s->degree, .end = image_of(before->end, axis)};
        for (int c = 0; c < s->degree - 1; c++)
            made->control[c] = image_of(s->control[s->degree - 2 - c], axis);
    }
    return MT_OK;
}

mt_status mt_add_images(const mt_halves *halves, mt_variable_outline *contours, mt_arena *arena) {
    int count = contours->count;
    mt_contour_pair *all = mt_arena_new(arena, 2 * (size_t)count + 1, sizeof *all);
    mt_status status = all ? MT_OK : MT_NO_MEMORY;
    for (int i = 0; i < count && status == MT_OK; i++) {
        const mt_contour_pair *pair = &contours->contours[i];
        mt_contour_pair *image = &all[count + i];
        all[i] = *pair;
        image->displacement = (mt_point){-pair->displacement.x, pair->displacement.y};
        status = image_of_contour(&pair->a, halves->axis_a, arena, &image->a);
        if (status == MT_OK) status = image_of_contour(&pair->b, halves->axis_b, arena, &image->b);
    }
    if (status == MT_OK) *contours = (mt_variable_outline){2 * count, all};
    return status;
}
