#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/divide/extended_cuts.h"
#include "support/check.h"
#include "support/polygons.h"

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

enum { UNIT = MT_EM / 1000 };

static mt_component component_of(const int points[][2], int count) {
    mt_ring *ring = mt_arena_new(&arena, 1, sizeof *ring);
    *ring = mt_test_ring_of(&arena, points, count, UNIT);
    return (mt_component){1, ring};
}

static mt_shape shape_of(mt_component *components, int count) {
    return (mt_shape){count, components};
}

/* A stem, 100 wide, and a bar to its right that is cut off it. */
static void cut_apart(mt_component parts[2], mt_component *whole) {
    static const int stem[][2] = {{0, 0}, {100, 0}, {100, 300}, {100, 400}, {100, 700}, {0, 700}};
    static const int bar[][2] = {{100, 300}, {500, 300}, {500, 400}, {100, 400}};
    static const int both[][2] = {{0, 0},     {100, 0},   {100, 300}, {500, 300},
                                  {500, 400}, {100, 400}, {100, 700}, {0, 700}};
    parts[0] = component_of(stem, 6);
    parts[1] = component_of(bar, 4);
    *whole = component_of(both, 8);
}

/* The same stem, and the bar `gap` away from it. */
static void drawn_apart(int gap, mt_component parts[2]) {
    const int stem[][2] = {{0, 0}, {100, 0}, {100, 700}, {0, 700}};
    const int bar[][2] = {{100 + gap, 300}, {500 + gap, 300}, {500 + gap, 400}, {100 + gap, 400}};
    parts[0] = component_of(stem, 4);
    parts[1] = component_of(bar, 4);
}

/* A side whose places are carried to the same places. */
static mt_side side_of(mt_shape ink) {
    mt_box box = {{0, 0}, {700 * UNIT, 700 * UNIT}};
    return (mt_side){.shape = ink, .box = box, .frame = mt_frame_of_box(box)};
}

static int64_t union_area2(const mt_shape *shape) {
    mt_ring rings[2] = {shape->components[0].rings[0], shape->components[1].rings[0]};
    const mt_rings drawn = {2, rings};
    mt_shape made;
    mt_assert_ok(mt_union(&drawn, MT_NONZERO, &arena, &made));
    return mt_shape_area2(&made);
}

/* Extends parts of A, which are cut, against those of B, which are drawn apart and stay as they are. */
static void extend(mt_cut_side *a, mt_component *whole, mt_component in_b[2], bool is_cut_twice) {
    static int partner[] = {0, 1};
    a->partner = partner;
    mt_cut_side b = {shape_of(in_b, 2), partner};
    mt_side side_a = side_of(shape_of(whole, 1)), side_b = side_of(b.parts);
    mt_assert_ok(mt_extend_cuts(&side_a, a, &side_b, &b, is_cut_twice, UNIT, &arena));
    for (int i = 0; i < 2; i++)
        assert_int_equal(b.parts.components[i].rings[0].count, 4); /* nothing to do there */
    assert_true(union_area2(&a->parts) == mt_component_area2(whole));
}

static void overlap(int gap, mt_cut_side *a, mt_component *whole, mt_component in_a[2],
                    mt_component in_b[2]) {
    cut_apart(in_a, whole);
    drawn_apart(gap, in_b);
    *a = (mt_cut_side){shape_of(in_a, 2), NULL};
    extend(a, whole, in_b, true);
}

/* The bar, which ends at the cut, goes on into the stem by the gap; the ink stays. */
static void the_bar_goes_on(void **state) {
    (void)state;
    for (int gap = 10; gap <= 90; gap += 20) {
        mt_component in_a[2], in_b[2], whole;
        mt_cut_side a;
        overlap(gap, &a, &whole, in_a, in_b);
        mt_box bar = mt_ring_box(&a.parts.components[1].rings[0]);
        assert_int_equal(a.parts.components[0].rings[0].count, 6);
        assert_int_equal(a.parts.components[1].rings[0].count, 6);
        assert_int_equal(bar.min.x, (100 - gap) * UNIT);
    }
}

/* No further than the ink: a gap that is wider than the stem gets half of it. */
static void not_out_of_the_ink(void **state) {
    (void)state;
    mt_component in_a[2], in_b[2], whole;
    mt_cut_side a;
    overlap(110, &a, &whole, in_a, in_b);
    assert_int_equal(mt_ring_box(&a.parts.components[1].rings[0]).min.x, (100 - 55) * UNIT);
}

static void nothing_where_the_partners_touch(void **state) {
    (void)state;
    mt_component in_a[2], in_b[2], whole;
    mt_cut_side a;
    overlap(0, &a, &whole, in_a, in_b);
    for (int i = 0; i < 2; i++)
        assert_int_equal(a.parts.components[i].rings[0].count, in_a[i].rings[0].count);
}

/* Where only one side is cut, the bar goes on as far as its partner reaches, and not at all where that keeps clear of the stem. */
static void the_bar_goes_on_like_its_partner(void **state) {
    (void)state;
    const int stem[][2] = {{0, 0}, {20, 0}, {20, 700}, {0, 700}};
    for (int left = 30; left <= 150; left += 40) {
        const int bar[][2] = {{left, 300}, {500, 300}, {500, 400}, {left, 400}};
        mt_component in_a[2], in_b[] = {component_of(stem, 4), component_of(bar, 4)}, whole;
        cut_apart(in_a, &whole);
        mt_cut_side a = {shape_of(in_a, 2), NULL};
        extend(&a, &whole, in_b, false);
        assert_int_equal(mt_ring_box(&a.parts.components[1].rings[0]).min.x,
                         (left < 100 ? left : 100) * UNIT);
        assert_int_equal(a.parts.components[0].rings[0].count, 6);
    }
}

/* Whether a part has a vertex near a place: its sides turn in a little where the ink hides them. */
static bool has_vertex_near(const mt_component *part, int x, int y) {
    const mt_ring *ring = &part->rings[0];
    for (int i = 0; i < ring->count; i++)
        if (mt_distance2(ring->points[i], (mt_point){x * UNIT, y * UNIT}) < (int64_t)225 * UNIT * UNIT)
            return true;
    return false;
}

/* A cut through a corner of both: each goes on until its sides meet, though no partner reaches there. */
static void corners_are_whole(void **state) {
    (void)state;
    static const int bar[][2] = {{60, 300}, {500, 300}, {500, 400}, {160, 400}, {60, 350}};
    static const int stem[][2] = {{60, 350}, {160, 400}, {160, 700}, {0, 700}, {0, 350}};
    static const int both[][2] = {{60, 300},  {500, 300}, {500, 400}, {160, 400},
                                  {160, 700}, {0, 700},   {0, 350},   {60, 350}};
    static const int low[][2] = {{200, 0}, {500, 0}, {500, 50}, {200, 50}};
    static const int high[][2] = {{0, 600}, {20, 600}, {20, 700}, {0, 700}};
    mt_component in_a[] = {component_of(bar, 5), component_of(stem, 5)}, whole = component_of(both, 8),
                 in_b[] = {component_of(low, 4), component_of(high, 4)};
    mt_cut_side a = {shape_of(in_a, 2), NULL};
    extend(&a, &whole, in_b, false);
    assert_true(has_vertex_near(&a.parts.components[0], 60, 400));
    assert_true(has_vertex_near(&a.parts.components[1], 160, 350));
    assert_int_equal(a.parts.components[0].rings[0].count, 6);
    assert_int_equal(a.parts.components[1].rings[0].count, 6);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_bar_goes_on),
        cmocka_unit_test(not_out_of_the_ink),
        cmocka_unit_test(nothing_where_the_partners_touch),
        cmocka_unit_test(the_bar_goes_on_like_its_partner),
        cmocka_unit_test(corners_are_whole),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
