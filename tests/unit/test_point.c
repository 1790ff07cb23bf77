#include "geometry/limits.h"
#include "support/check.h"
#include "support/oracle.h"
#include "support/random.h"

static int sign(int64_t value) {
    return (value > 0) - (value < 0);
}

static void orientation(void **state) {
    (void)state;
    mt_point a = {0, 0}, b = {4, 0};
    assert_int_equal(mt_orient(a, b, (mt_point){2, 3}), 12);
    assert_int_equal(mt_orient(a, b, (mt_point){2, -3}), -12);
    assert_int_equal(mt_orient(a, b, (mt_point){9, 0}), 0);
    assert_int_equal(mt_dot(a, b, a, (mt_point){-2, 7}), -8);
    assert_int_equal(mt_distance2(a, (mt_point){3, 4}), 25);
}

/* The corners of the largest square, where nothing may overflow. */
static void orientation_at_the_limits(void **state) {
    (void)state;
    const int32_t m = MT_COORD_MAX;
    mt_point corners[] = {{-m, -m}, {m, -m}, {m, m}, {-m, m}};
    int64_t side = 2 * (int64_t)m;
    assert_true(mt_orient(corners[0], corners[1], corners[2]) == side * side);
    assert_true(mt_orient(corners[0], corners[2], corners[1]) == -side * side);
    assert_int_equal(mt_orient(corners[0], corners[2], (mt_point){m - 1, m}), side);
    assert_int_equal(mt_orient(corners[0], corners[2], (mt_point){0, 0}), 0);
    assert_true(mt_distance2(corners[0], corners[2]) == 2 * side * side);
}

static void circle_by_hand(void **state) {
    (void)state;
    mt_point a = {5, 0}, b = {3, 4}, c = {-4, 3};
    assert_int_equal(mt_in_circle(a, b, c, (mt_point){0, -5}), 0);
    assert_int_equal(mt_in_circle(a, b, c, (mt_point){0, 0}), 1);
    assert_int_equal(mt_in_circle(a, b, c, (mt_point){0, -6}), -1);
    assert_int_equal(mt_in_circle(a, c, b, (mt_point){0, 0}), -1);
}

/* Four corners of a square are on its circle, one unit off they are not, as far out as coordinates go. */
static void circle_at_the_limits(void **state) {
    (void)state;
    for (int32_t m = 1; m <= 4 * MT_COORD_MAX && m > 0; m = m * 2 + 1) {
        mt_point a = {-m, -m}, b = {m, -m}, c = {m, m};
        assert_int_equal(mt_in_circle(a, b, c, (mt_point){-m, m}), 0);
        assert_int_equal(mt_in_circle(a, b, c, (mt_point){-m + 1, m}), 1);
        assert_int_equal(mt_in_circle(a, b, c, (mt_point){-m - 1, m}), -1);
    }
}

/* Small reaches give points in line and on a circle; large ones fill the numbers. */
static void agree_with_the_oracles(void **state) {
    (void)state;
    static const int reaches[] = {2, 5, 1000, MT_COORD_MAX, 4 * MT_COORD_MAX};
    mt_random random = mt_random_case(0);
    int zeros = 0;
    for (int i = 0; i < mt_test_cases(20000); i++) {
        int reach = reaches[i % 5];
        mt_point p[4];
        for (int k = 0; k < 4; k++) p[k] = mt_random_point(&random, -reach, reach);
        int circle = mt_in_circle(p[0], p[1], p[2], p[3]);
        assert_int_equal(circle, mt_oracle_in_circle(p[0], p[1], p[2], p[3]));
        assert_int_equal(circle, -mt_in_circle(p[1], p[0], p[2], p[3]));
        assert_int_equal(circle, mt_in_circle(p[1], p[2], p[0], p[3]));
        mt_wide turn = mt_oracle_orient(mt_spot_of(p[0], 1), mt_spot_of(p[1], 1), mt_spot_of(p[2], 1));
        assert_true(mt_orient(p[0], p[1], p[2]) == turn);
        assert_int_equal(sign(mt_orient(p[0], p[1], p[2])), -sign(mt_orient(p[0], p[2], p[1])));
        zeros += circle == 0;
    }
    assert_true(zeros > 100);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orientation),
        cmocka_unit_test(orientation_at_the_limits),
        cmocka_unit_test(circle_by_hand),
        cmocka_unit_test(circle_at_the_limits),
        cmocka_unit_test(agree_with_the_oracles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
