#include "geometry/limits.h"
#include "morph/check/reconnect.h"
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

/* Strokes 100/1000 em wide. */
static mt_ring corner(void) {
    const int points[][2] = {{0, 0}, {300, 0}, {300, 100}, {100, 100}, {100, 300}, {0, 300}};
    return mt_test_ring_of(&arena, points, 6, UNIT);
}

/* A square that goes, on a straight way, from one arm of a corner to its other arm. */
static mt_morph morph_of(const int from[2], const int to[2]) {
    mt_ring in_a[] = {corner(), mt_test_square(&arena, from[0], from[1])},
            in_b[] = {corner(), mt_test_square(&arena, to[0], to[1])};
    return mt_test_morph_of(&arena, in_a, in_b, 2);
}

/* Half-way 10/1000 em are between it and either arm. */
static const int up[] = {80, 140}, right[] = {140, 80};

static void the_smaller_part_comes_nearer(void **state) {
    (void)state;
    mt_morph morph = morph_of(up, right);
    assert_true(mt_test_topology_error(&arena, &morph).parts > 0);
    assert_int_equal(mt_test_mend(&arena, mt_reconnect_parts, &morph).parts, 0);
    assert_true(mt_test_displacement(&morph, 0) == 0);
    assert_true(mt_test_displacement(&morph, 1) >= 10 && mt_test_displacement(&morph, 1) <= 30);
}

static void the_ends_stay(void **state) {
    (void)state;
    mt_morph morph = morph_of(up, right);
    mt_test_mend(&arena, mt_reconnect_parts, &morph);
    mt_test_ends_stay(&arena, &morph);
}

/* 70/1000 em half-way: whoever came so far would be seen to do so. */
static void a_wide_rift_stays(void **state) {
    (void)state;
    const int high[] = {80, 260}, far[] = {260, 80};
    mt_morph morph = morph_of(high, far);
    int before = mt_test_topology_error(&arena, &morph).parts;
    assert_true(before > 0);
    assert_int_equal(mt_test_mend(&arena, mt_reconnect_parts, &morph).parts, before);
    assert_true(mt_test_displacement(&morph, 0) == 0 && mt_test_displacement(&morph, 1) == 0);
}

static void what_an_end_has_apart_stays(void **state) {
    (void)state;
    const int apart[] = {140, 140};
    mt_morph morph = morph_of(apart, right);
    assert_int_equal(mt_test_mend(&arena, mt_reconnect_parts, &morph).parts, 0);
    assert_true(mt_test_displacement(&morph, 0) == 0 && mt_test_displacement(&morph, 1) == 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_smaller_part_comes_nearer),
        cmocka_unit_test(the_ends_stay),
        cmocka_unit_test(a_wide_rift_stays),
        cmocka_unit_test(what_an_end_has_apart_stays),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
