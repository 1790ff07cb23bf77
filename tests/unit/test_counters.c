#include "geometry/limits.h"
#include "morph/check/counters.h"
#include "support/check.h"
#include "support/moves.h"
#include "support/polygons.h"

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

static mt_ring hole_at(const int at[2]) {
    int x = at[0], y = at[1];
    const int points[][2] = {{x, y}, {x, y + 100}, {x + 100, y + 100}, {x + 100, y}};
    return mt_test_ring_of(&arena, points, 4, UNIT);
}

/* A hole that goes, on a straight way, from one arm of a corner to its other arm. */
static mt_morph morph_of(const int from[2], const int to[2]) {
    mt_ring in_a[] = {corner(), hole_at(from)}, in_b[] = {corner(), hole_at(to)};
    return mt_test_morph_of(&arena, in_a, in_b, 2);
}

/* Half-way it would be 15/1000 em beyond the inside of the corner, both ways. */
static const int up[] = {80, 150}, right[] = {150, 80};

static void the_hole_keeps_in_the_ink(void **state) {
    (void)state;
    mt_morph morph = morph_of(up, right);
    mt_topology_error before = mt_test_topology_error(&arena, &morph);
    assert_true(before.opened > 0 && before.opened == before.parts);
    assert_int_equal(mt_test_mend(&arena, mt_keep_counters, &morph).parts, 0);
    assert_true(mt_test_displacement(&morph, 0) == 0);
    assert_true(mt_test_displacement(&morph, 1) > 15 && mt_test_displacement(&morph, 1) < 49);
}

static void the_ends_stay(void **state) {
    (void)state;
    mt_morph morph = morph_of(up, right);
    mt_test_mend(&arena, mt_keep_counters, &morph);
    mt_test_ends_stay(&arena, &morph);
}

/* Half-way it would be out of the corner altogether. */
static void what_goes_too_far_is_not_mended(void **state) {
    (void)state;
    const int high[] = {50, 350}, far[] = {350, 50};
    mt_morph morph = morph_of(high, far);
    assert_true(mt_test_topology_error(&arena, &morph).parts > 0);
    assert_true(mt_test_mend(&arena, mt_keep_counters, &morph).parts > 0);
    assert_true(mt_test_displacement(&morph, 0) == 0);
}

static void what_keeps_in_the_ink_stays(void **state) {
    (void)state;
    const int low[] = {80, 80};
    mt_morph morph = morph_of(up, low);
    assert_int_equal(mt_test_mend(&arena, mt_keep_counters, &morph).parts, 0);
    assert_true(mt_test_displacement(&morph, 1) == 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_hole_keeps_in_the_ink),
        cmocka_unit_test(the_ends_stay),
        cmocka_unit_test(what_goes_too_far_is_not_mended),
        cmocka_unit_test(what_keeps_in_the_ink_stays),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
