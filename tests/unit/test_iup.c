#include "write/iup.h"

#include <math.h>

#include "support/check.h"
#include "support/random.h"

enum { POINTS_MAX = 64 };

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* ---- an oracle: 'gvar' as the specification words it, one axis at a time --------------------------------- */

static double interpolated(double c, double c1, double d1, double c2, double d2) {
    if (c1 == c2) return d1 == d2 ? d1 : 0;
    double low = fmin(c1, c2), high = fmax(c1, c2), at_low = c1 < c2 ? d1 : d2, at_high = c1 < c2 ? d2 : d1;
    if (c <= low) return at_low;
    if (c >= high) return at_high;
    return at_low + (at_high - at_low) * (c - low) / (high - low);
}

static int next_told(const bool *told, int count, int from, int by) {
    int i = from;
    do i = (i + by + count) % count;
    while (!told[i] && i != from);
    return i;
}

/* By how far any point's move would be missed. */
static double worst_miss(const mt_glyf_point *p, const mt_move *moves, const bool *told, int count) {
    double worst = 0;
    int told_count = 0;
    for (int i = 0; i < count; i++) told_count += told[i];
    for (int i = 0; i < count; i++) {
        if (told[i]) continue;
        double x = 0, y = 0;
        if (told_count > 0) {
            int a = next_told(told, count, i, -1), b = next_told(told, count, i, 1);
            x = interpolated(p[i].x, p[a].x, moves[a].x, p[b].x, moves[b].x);
            y = interpolated(p[i].y, p[a].y, moves[a].y, p[b].y, moves[b].y);
        }
        worst = fmax(worst, fmax(fabs(x - moves[i].x), fabs(y - moves[i].y)));
    }
    return worst;
}

/* ---- tests ----------------------------------------------------------------------------------------------- */

static int chosen(const mt_glyf_point *points, const mt_move *moves, int count, double tolerance,
                  bool *told) {
    int end = count - 1, told_count = 0;
    mt_glyf glyph = {.contour_count = 1, .ends = &end, .points = (mt_glyf_point *)points};
    mt_assert_ok(mt_iup_choose(&glyph, moves, tolerance, &arena, told));
    for (int i = 0; i < count; i++) told_count += told[i];
    return told_count;
}

static const mt_glyf_point square[] = {{0, 0, true},    {50, 0, true},  {100, 0, true}, {100, 100, true},
                                       {50, 100, true}, {0, 100, true}, {0, 50, true}};

static void what_stays_is_not_told(void **state) {
    (void)state;
    bool told[7];
    mt_move moves[7] = {{0}};
    assert_int_equal(chosen(square, moves, 7, 0, told), 0);
}

static void one_point_takes_a_contour_along(void **state) {
    (void)state;
    bool told[7];
    mt_move moves[7];
    for (int i = 0; i < 7; i++) moves[i] = (mt_move){-7, 3};
    assert_int_equal(chosen(square, moves, 7, 0, told), 1);
}

/* Made twice as wide: the points half-way along its sides are inferred. */
static void stretching_needs_corners_only(void **state) {
    (void)state;
    bool told[7];
    mt_move moves[7];
    for (int i = 0; i < 7; i++) moves[i] = (mt_move){square[i].x, 0};
    int count = chosen(square, moves, 7, 0, told);
    assert_true(count <= 4);
    assert_true(worst_miss(square, moves, told, 7) <= 0);
}

static void random_moves_are_inferred_within_the_tolerance(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(2000); n++) {
        mt_random random = mt_random_case(n);
        mt_glyf_point points[POINTS_MAX];
        mt_move moves[POINTS_MAX];
        bool told[POINTS_MAX];
        int count = mt_random_between(&random, 1, POINTS_MAX),
            range = n % 2 ? 4 : 300; /* few places: many coincide */
        for (int i = 0; i < count; i++) {
            int x = mt_random_between(&random, 0, range), y = mt_random_between(&random, 0, range);
            points[i] = (mt_glyf_point){(int16_t)x, (int16_t)y, true};
            moves[i] = (mt_move){(int16_t)(x / 3 + mt_random_between(&random, 0, 2)),
                                 (int16_t)(y / 2 - mt_random_between(&random, 0, 1))};
        }
        double tolerance = mt_random_between(&random, 0, 2) / 2.0;
        chosen(points, moves, count, tolerance, told);
        assert_true(worst_miss(points, moves, told, count) <= tolerance + 1e-9);
        mt_arena_reset(&arena);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_stays_is_not_told),
        cmocka_unit_test(one_point_takes_a_contour_along),
        cmocka_unit_test(stretching_needs_corners_only),
        cmocka_unit_test(random_moves_are_inferred_within_the_tolerance),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
