#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/counters.h"
#include "support/check.h"
#include "support/polygons.h"

#include <limits.h>
#include <math.h>

enum { UNIT = MT_EM / 1000 };

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* Strokes 200/1000 em wide. */
static mt_ring corner(void) {
    const int points[][2] = {{0, 0}, {500, 0}, {500, 200}, {200, 200}, {200, 500}, {0, 500}};
    return mt_test_ring_of(&arena, points, 6, UNIT);
}

static mt_ring hole_at(int x, int y) {
    const int points[][2] = {{x, y}, {x, y + 100}, {x + 100, y + 100}, {x + 100, y}};
    return mt_test_ring_of(&arena, points, 4, UNIT);
}

static mt_contour contour_of(const mt_ring *ring) {
    mt_contour contour = {ring->count, mt_arena_new(&arena, (size_t)ring->count, sizeof(mt_segment))};
    for (int i = 0; i < ring->count; i++)
        contour.segments[i] = (mt_segment){.degree = 1, .end = ring->points[i]};
    return contour;
}

static mt_side side_of(mt_ring *rings, int count) {
    mt_side side = {0};
    mt_assert_ok(mt_union(&(mt_rings){count, rings}, MT_NONZERO, &arena, &side.whole));
    side.shape = side.whole;
    side.box = mt_shape_box(&side.whole);
    return side;
}

/* A hole that goes on a straight way through the corner, from its one arm to the other. */
static mt_morph morph_of(const int from[2], const int to[2]) {
    mt_ring in_a[] = {corner(), hole_at(from[0], from[1])}, in_b[] = {corner(), hole_at(to[0], to[1])};
    mt_morph morph = {.contour_count = 2, .contours = mt_arena_new(&arena, 2, sizeof(mt_masters))};
    for (int i = 0; i < 2; i++)
        morph.contours[i] = (mt_masters){.a = contour_of(&in_a[i]), .b = contour_of(&in_b[i])};
    morph.a = side_of(in_a, 2);
    morph.b = side_of(in_b, 2);
    return morph;
}

static mt_straying strays(const mt_morph *morph) {
    mt_params params = mt_params_default();
    mt_straying by;
    mt_assert_ok(mt_morph_strays(morph, INT_MAX, &params, &arena, &by));
    return by;
}

static mt_straying keep_counters(mt_morph *morph) {
    mt_params params = mt_params_default();
    mt_straying by = strays(morph);
    mt_assert_ok(mt_keep_counters(morph, &params, &arena, &by));
    assert_int_equal(by.parts, strays(morph).parts);
    return by;
}

static double aside(const mt_morph *morph, int contour) {
    mt_point by = morph->contours[contour].aside;
    return hypot(by.x, by.y) / UNIT;
}

/* Half-way it would be 15/1000 em beyond the inside of the corner, both ways. */
static const int up[] = {80, 150}, right[] = {150, 80};

static void the_hole_keeps_in_the_ink(void **state) {
    (void)state;
    mt_morph morph = morph_of(up, right);
    mt_straying before = strays(&morph);
    assert_true(before.opened > 0 && before.opened == before.parts);
    assert_int_equal(keep_counters(&morph).parts, 0);
    assert_true(aside(&morph, 0) == 0);
    assert_true(aside(&morph, 1) > 15 && aside(&morph, 1) <= 48.1);
}

static void the_ends_stay(void **state) {
    (void)state;
    mt_params params = mt_params_default();
    mt_morph morph = morph_of(up, right);
    keep_counters(&morph);
    for (int t = 0; t < 2; t++) {
        mt_shape blend;
        mt_assert_ok(mt_morph_blend(&morph, mt_weights_at(t), &params, &arena, &blend));
        assert_int_equal(mt_shape_area2(&blend), mt_shape_area2(t ? &morph.b.whole : &morph.a.whole));
    }
}

/* Half-way it would be out of the corner altogether. */
static void what_goes_too_far_stays(void **state) {
    (void)state;
    const int high[] = {50, 350}, far[] = {350, 50};
    mt_morph morph = morph_of(high, far);
    int before = strays(&morph).parts;
    assert_true(before > 0);
    assert_true(keep_counters(&morph).parts > 0);
    assert_true(aside(&morph, 0) == 0);
}

static void what_keeps_in_the_ink_stays(void **state) {
    (void)state;
    const int low[] = {80, 80};
    mt_morph morph = morph_of(up, low);
    assert_int_equal(keep_counters(&morph).parts, 0);
    assert_true(aside(&morph, 1) == 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_hole_keeps_in_the_ink),
        cmocka_unit_test(the_ends_stay),
        cmocka_unit_test(what_goes_too_far_stays),
        cmocka_unit_test(what_keeps_in_the_ink_stays),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
