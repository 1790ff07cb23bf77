/* Angles against the C library's with the bits of a long double, and what is exact about them. */
#include "arithmetic/angles.h"

#include "support/check.h"
#include "support/random.h"

#define CASES 200000
#define BOUND 4e-16

static double between(mt_random *random, double low, double high) {
    return low + (high - low) * mt_random_unit(random);
}

/* Of either sign, and of any size from 2^-low to 2^high. */
static double of_any_size(mt_random *random, int low, int high) {
    double number = ldexp(1 + mt_random_unit(random), mt_random_between(random, -low, high - 1));
    return mt_random_one_in(random, 2) ? -number : number;
}

/* How far a result is off, as a part of the exact one. */
static double error(double found, long double exact) {
    if (exact == 0) return found == 0 ? 0 : INFINITY;
    return (double)fabsl((found - exact) / exact);
}

static void check_turn(double x) {
    assert_true(error(mt_sin(x), sinl(x)) <= BOUND);
    assert_true(error(mt_cos(x), cosl(x)) <= BOUND);
    assert_true(error(mt_tan(x), tanl(x)) <= 2 * BOUND);
    assert_true(mt_sin(-x) == -mt_sin(x));
    assert_true(mt_cos(-x) == mt_cos(x));
}

static void sines(void **state) {
    (void)state;
    mt_random random = mt_random_case(0);
    for (int i = 0; i < mt_test_cases(CASES); i++) {
        check_turn(between(&random, -4, 4));
        check_turn(between(&random, -1000, 1000));
        check_turn(of_any_size(&random, 60, 9));
    }
}

/* The doubles next to multiples of an eighth of a turn, where what is left is smallest or a series goes over into another. */
static void sines_at_eighths(void **state) {
    (void)state;
    for (int k = 0; k * M_PI_4 < 1000; k++) {
        double x = k * M_PI_4, lower = x, higher = x;
        for (int step = 0; step < 4; step++) {
            check_turn(lower);
            check_turn(higher);
            lower = nextafter(lower, -INFINITY);
            higher = nextafter(higher, INFINITY);
        }
    }
}

static void quarter_turns(void **state) {
    (void)state;
    assert_true(mt_sin(0) == 0 && mt_cos(0) == 1 && mt_tan(0) == 0);
    assert_true(mt_sin(M_PI_2) == 1 && mt_cos(M_PI) == -1 && mt_sin(3 * M_PI_2) == -1 &&
                mt_cos(2 * M_PI) == 1);
}

/* Angles of drawings come from strangers. */
static void large_angles(void **state) {
    (void)state;
    static const double angles[] = {1e5, 999999.5, 1e6, 1e6 + 1, 1e9, 0x1p52, 1e100, 1.7e308};
    for (size_t i = 0; i < sizeof angles / sizeof *angles; i++) {
        double s = mt_sin(angles[i]), c = mt_cos(angles[i]);
        assert_true(fabs(s * s + c * c - 1) <= 1e-15);
        assert_true(mt_sin(-angles[i]) == -s && mt_cos(-angles[i]) == c);
        if (angles[i] <= MT_ANGLE_MOST) assert_true(fabsl(s - sinl(angles[i])) <= 4e-16L);
    }
    assert_true(isnan(mt_sin(INFINITY)) && isnan(mt_cos(NAN)) && isnan(mt_tan(-INFINITY)));
}

static void check_vector(double x, double y) {
    assert_true(error(mt_atan2(y, x), atan2l(y, x)) <= BOUND);
    assert_true(error(mt_hypot(x, y), hypotl(x, y)) <= BOUND);
    assert_true(mt_atan2(-y, x) == -mt_atan2(y, x));
    assert_true(mt_hypot(x, y) == mt_hypot(-y, x));
}

static void vectors(void **state) {
    (void)state;
    mt_random random = mt_random_case(1);
    for (int i = 0; i < mt_test_cases(CASES); i++) {
        double x = between(&random, -1, 1), y = between(&random, -1, 1);
        check_vector(x, y);
        x = of_any_size(&random, 30, 30);
        check_vector(x, x * between(&random, -1.1, 1.1));
        check_vector(mt_random_between(&random, -40, 40), mt_random_between(&random, -40, 40));
        check_vector(of_any_size(&random, 60, 60), of_any_size(&random, 60, 60));
    }
}

static void vectors_along_axes(void **state) {
    (void)state;
    static const double lengths[] = {0x1p-1000, 0.1, 1, 3, 256000, 1e300};
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        double n = lengths[i];
        assert_true(mt_atan2(0, n) == 0 && mt_atan2(n, n) == M_PI_4 && mt_atan2(n, 0) == M_PI_2);
        assert_true(mt_atan2(n, -n) == 3 * M_PI_4 && mt_atan2(0, -n) == M_PI && mt_atan2(-0.0, -n) == -M_PI);
        assert_true(mt_atan2(-n, -n) == -3 * M_PI_4 && mt_atan2(-n, 0) == -M_PI_2 &&
                    mt_atan2(-n, n) == -M_PI_4);
        assert_true(mt_hypot(n, 0) == n && mt_hypot(0, -n) == n);
    }
}

static void zeros(void **state) {
    (void)state;
    assert_true(mt_hypot(0, 0) == 0);
    assert_true(mt_atan2(0.0, 0.0) == 0 && !signbit(mt_atan2(0.0, 0.0)) && signbit(mt_atan2(-0.0, 0.0)));
    assert_true(mt_atan2(0.0, -0.0) == M_PI && mt_atan2(-0.0, -0.0) == -M_PI);
    assert_true(isnan(mt_atan2(NAN, 1)) && isnan(mt_atan2(1, NAN)) && isnan(mt_atan2(INFINITY, INFINITY)));
}

static void lengths_of_any_size(void **state) {
    (void)state;
    mt_random random = mt_random_case(2);
    for (int i = 0; i < mt_test_cases(CASES); i++) {
        double x = of_any_size(&random, 1000, 1000), y = x * between(&random, -2, 2);
        assert_true(error(mt_hypot(x, y), hypotl(x, y)) <= BOUND);
    }
    assert_true(mt_hypot(1.7e308, 1.7e308) == INFINITY && mt_hypot(-INFINITY, 1) == INFINITY &&
                isnan(mt_hypot(NAN, 1)));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sines),         cmocka_unit_test(sines_at_eighths),
        cmocka_unit_test(quarter_turns), cmocka_unit_test(large_angles),
        cmocka_unit_test(vectors),       cmocka_unit_test(vectors_along_axes),
        cmocka_unit_test(zeros),         cmocka_unit_test(lengths_of_any_size)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
