#include "geometry/limits.h"
#include "morph/check/lulls.h"
#include "morph/check/topology.h"
#include "support/check.h"
#include "support/moves.h"
#include "support/polygons.h"

#include <math.h>

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static mt_lulls lulls_of(const mt_morph *morph) {
    mt_moving_edges edges;
    mt_lulls lulls;
    mt_assert_ok(mt_moving_edges_of(morph, mt_grid_units(0.5), &arena, &edges));
    mt_assert_ok(mt_find_lulls(&edges, mt_grid_units(0.5), &arena, &lulls));
    return lulls;
}

/* A square that stands, and one that moves from one place to another; thousandths of the em. */
static mt_morph passing(int x, int y, int to_x, int to_y) {
    mt_ring in_a[] = {mt_test_square(&arena, 0, 0), mt_test_square(&arena, x, y)},
            in_b[] = {mt_test_square(&arena, 0, 0), mt_test_square(&arena, to_x, to_y)};
    return mt_test_morph_of(&arena, in_a, in_b, 2);
}

static void what_never_meets_is_one_lull(void **state) {
    (void)state;
    mt_morph morph = passing(250, 0, 0, 250); /* around the corner, by 25 */
    mt_lulls lulls = lulls_of(&morph);
    assert_true(lulls.known && lulls.plain);
    assert_int_equal(lulls.count, 1);
    assert_true(lulls.lulls[0].from == 0 && lulls.lulls[0].to == 1);
    assert_true(mt_test_topology_error(&arena, &morph).proved);
}

/* One corner over another, by 10 both ways, on its way over 1000: from T = 0.515 to 0.535. */
static mt_morph meeting_between_samples(void) {
    return passing(-435, 615, 565, -385);
}

static void what_meets_between_samples_is_found(void **state) {
    (void)state;
    mt_morph morph = meeting_between_samples();
    mt_lulls lulls = lulls_of(&morph);
    assert_true(lulls.known && !lulls.plain);
    assert_int_equal(lulls.count, 3);
    const double ends[] = {0, 0.515, 0.515, 0.535, 0.535, 1};
    for (int i = 0; i < 3; i++) {
        assert_true(fabs(lulls.lulls[i].from - ends[2 * i]) < 1e-5);
        assert_true(fabs(lulls.lulls[i].to - ends[2 * i + 1]) < 1e-5);
    }
}

/* Nineteen places miss it. It is over in 2/5 of a twentieth of the way, for which no morph is thrown away. */
static void what_is_over_soon_is_told_and_weighs_nothing(void **state) {
    (void)state;
    mt_morph morph = meeting_between_samples();
    mt_topology_error error = mt_test_topology_error(&arena, &morph);
    assert_true(error.proved && !error.stays);
    assert_int_equal(error.parts, 0);
    assert_int_equal(error.merged, 0);
}

/* The same three times, far apart: 6/5 of a twentieth. */
static void what_is_over_soon_adds_up(void **state) {
    (void)state;
    mt_ring in_a[6], in_b[6];
    for (int i = 0; i < 3; i++) {
        int y = 3000 * i, later = 50 * i;
        in_a[2 * i] = in_b[2 * i] = mt_test_square(&arena, 0, y);
        in_a[2 * i + 1] = mt_test_square(&arena, -435 - later, y + 615 + later);
        in_b[2 * i + 1] = mt_test_square(&arena, 565 - later, y - 385 + later);
    }
    mt_morph morph = mt_test_morph_of(&arena, in_a, in_b, 6);
    mt_topology_error error = mt_test_topology_error(&arena, &morph);
    assert_int_equal(lulls_of(&morph).count, 7);
    assert_true(error.proved && !error.stays);
    assert_int_equal(error.parts, 1);
    assert_int_equal(error.merged, 1);
}

static void shift(mt_contour *contour, int by) {
    for (int i = 0; i < contour->count; i++) {
        contour->segments[i].end.x += by;
        contour->segments[i].end.y += by;
    }
}

/* Over the corner by an eighth of 1/1000 em, while the square gets on by a quarter: with other chords nobody would know. */
static void moments_are_passed_over(void **state) {
    (void)state;
    mt_morph morph = passing(-400, 600, 600, -400);
    shift(&morph.contours[1].a, -MT_EM / 8000);
    shift(&morph.contours[1].b, -MT_EM / 8000);
    mt_lulls lulls = lulls_of(&morph);
    assert_true(lulls.known && !lulls.plain);
    assert_int_equal(lulls.count, 2);
    assert_true(lulls.lulls[0].to < 0.5 && lulls.lulls[1].from > 0.5);
    shift(&morph.contours[1].a, -MT_EM / 2000);
    shift(&morph.contours[1].b, -MT_EM / 2000);
    assert_int_equal(lulls_of(&morph).count, 3);
}

/* Two halves of a square with a cut between them that both ends have: they move as one. */
static void a_cut_of_both_ends_is_no_meeting(void **state) {
    (void)state;
    const int left[][2] = {{0, 0}, {50, 0}, {60, 100}, {0, 100}},
              right[][2] = {{50, 0}, {100, 0}, {100, 100}, {60, 100}},
              left_b[][2] = {{0, 0}, {70, 10}, {40, 130}, {0, 100}},
              right_b[][2] = {{70, 10}, {100, 0}, {100, 150}, {40, 130}};
    mt_ring in_a[] = {mt_test_ring_of(&arena, left, 4, MT_EM / 1000),
                      mt_test_ring_of(&arena, right, 4, MT_EM / 1000)},
            in_b[] = {mt_test_ring_of(&arena, left_b, 4, MT_EM / 1000),
                      mt_test_ring_of(&arena, right_b, 4, MT_EM / 1000)};
    mt_morph morph = mt_test_morph_of(&arena, in_a, in_b, 2);
    mt_lulls lulls = lulls_of(&morph);
    assert_true(lulls.known && !lulls.plain);
    assert_int_equal(lulls.count, 1);
    mt_topology_error error = mt_test_topology_error(&arena, &morph);
    assert_true(error.proved && error.stays && error.parts == 0);
}

/* Cut in A only: the halves part as soon as T is over 0, and no earlier. */
static void a_cut_of_one_end_opens_at_that_end(void **state) {
    (void)state;
    mt_morph morph = passing(100, 0, 200, 0);
    mt_lulls lulls = lulls_of(&morph);
    assert_true(lulls.known && lulls.count == 1 && lulls.lulls[0].from == 0);
}

static void displaced_contours_are_followed_in_two_parts(void **state) {
    (void)state;
    mt_morph morph = passing(150, 10, 150, 10);
    morph.contours[1].displacement =
        (mt_point){-100 * MT_EM / 1000, 0}; /* half-way on the other one, for T in ¼ … ¾ */
    mt_lulls lulls = lulls_of(&morph);
    assert_true(lulls.known);
    assert_int_equal(lulls.count, 3);
    assert_true(fabs(lulls.lulls[1].from - 0.25) < 1e-5 && fabs(lulls.lulls[1].to - 0.75) < 1e-5);
}

static void a_contour_that_turns_over_is_a_meeting(void **state) {
    (void)state;
    const int a[][2] = {{0, 0}, {100, 0}, {100, 100}, {0, 100}},
              b[][2] = {{0, 0}, {100, 0}, {100, -100}, {0, -100}};
    mt_ring in_a[] = {mt_test_ring_of(&arena, a, 4, MT_EM / 1000)},
            in_b[] = {mt_test_ring_of(&arena, b, 4, MT_EM / 1000)};
    mt_morph morph = mt_test_morph_of(&arena, in_a, in_b, 1);
    mt_lulls lulls = lulls_of(&morph);
    assert_true(lulls.known);
    assert_int_equal(lulls.count, 2);
    assert_true(fabs(lulls.lulls[0].to - 0.5) < 1e-5);
}

/* Three bars, each over the other two: they may cross in one point. */
static void three_at_once_are_left_to_samples(void **state) {
    (void)state;
    const int bars[][4][2] = {{{0, 40}, {100, 40}, {100, 50}, {0, 50}},
                              {{40, 0}, {50, 0}, {50, 100}, {40, 100}},
                              {{0, 0}, {10, 0}, {100, 90}, {90, 100}}};
    mt_ring in_a[3], in_b[3];
    for (int i = 0; i < 3; i++) {
        in_a[i] = mt_test_ring_of(&arena, bars[i], 4, MT_EM / 1000);
        in_b[i] = mt_test_ring_of(&arena, bars[i], 4, MT_EM / 500);
    }
    mt_morph morph = mt_test_morph_of(&arena, in_a, in_b, 3);
    assert_false(lulls_of(&morph).known);
    assert_false(mt_test_topology_error(&arena, &morph).proved);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_never_meets_is_one_lull),
        cmocka_unit_test(what_meets_between_samples_is_found),
        cmocka_unit_test(what_is_over_soon_is_told_and_weighs_nothing),
        cmocka_unit_test(what_is_over_soon_adds_up),
        cmocka_unit_test(moments_are_passed_over),
        cmocka_unit_test(a_cut_of_both_ends_is_no_meeting),
        cmocka_unit_test(a_cut_of_one_end_opens_at_that_end),
        cmocka_unit_test(displaced_contours_are_followed_in_two_parts),
        cmocka_unit_test(a_contour_that_turns_over_is_a_meeting),
        cmocka_unit_test(three_at_once_are_left_to_samples),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
