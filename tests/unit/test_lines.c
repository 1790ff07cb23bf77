#include "geometry/limits.h"
#include "morph/fit/lines.h"
#include "support/check.h"

enum { UNIT = MT_EM / 1000, SEGMENTS = 6 };

static mt_segment line_to(int x, int y) {
    return (mt_segment){.degree = 1, .end = {x * UNIT, y * UNIT}};
}

static mt_segment curve_to(int cx, int cy, int x, int y) {
    return (mt_segment){.degree = 2, .control = {{cx * UNIT, cy * UNIT}}, .end = {x * UNIT, y * UNIT}};
}

static mt_contour_pair masters_of(mt_segment *a, mt_segment *b, int count) {
    return (mt_contour_pair){.a = {count, a}, .b = {count, b}};
}

/* A node in the middle of a side of both squares goes, with its step; one that is a corner of either stays. */
static void one_line_in_several(void **state) {
    (void)state;
    mt_segment a[] = {line_to(0, 0),    line_to(30, 0),    line_to(100, 0),
                      line_to(100, 50), line_to(100, 100), line_to(0, 100)};
    mt_segment b[] = {line_to(0, 0),    line_to(80, 0),    line_to(100, 0),
                      line_to(120, 40), line_to(100, 100), line_to(0, 100)};
    int steps[] = {3, 5, 8, 9, 12, 20};
    mt_contour_pair m = masters_of(a, b, SEGMENTS);
    mt_contour_pair_tidy_lines(&m, steps, UNIT / 10);
    assert_int_equal(m.a.count, SEGMENTS - 1);
    assert_int_equal(m.b.count, SEGMENTS - 1);
    assert_true(mt_point_equal(m.a.segments[1].end, line_to(100, 0).end));
    assert_true(mt_point_equal(m.b.segments[2].end, line_to(120, 40).end));
    assert_true(steps[0] == 3 && steps[1] == 8 && steps[2] == 9);
}

/* What has no length in either master goes; where only the one waits, the other's line stays. */
static void nothing_in_both(void **state) {
    (void)state;
    for (int moves = 0; moves < 2; moves++) {
        mt_segment a[] = {line_to(0, 0), line_to(100, 0), line_to(100, 0), line_to(0, 100)};
        mt_segment b[] = {line_to(0, 0), line_to(90, 0), line_to(90, 10 * moves), line_to(0, 70)};
        int steps[] = {0, 1, 2, 3};
        mt_contour_pair m = masters_of(a, b, 4);
        mt_contour_pair_tidy_lines(&m, steps, UNIT / 10);
        assert_int_equal(m.a.count, 3 + moves);
        assert_true(mt_point_equal(m.a.segments[1].end, line_to(100, 0).end));
        assert_true(mt_point_equal(m.b.segments[m.b.count - 1].end, line_to(0, 70).end));
    }
}

/* A line between two curves, smooth at both ends in both masters, becomes a curve where it is short and would make a kink. */
static void short_lines_bend(void **state) {
    (void)state;
    for (int length = 4; length <= 40; length += 36) {
        mt_segment a[] = {line_to(0, 0), curve_to(100, 0, 100, 100), line_to(100, 100 + length),
                          curve_to(100, 200, 0, 200)};
        mt_segment b[] = {line_to(0, 0), curve_to(50, 0, 100, 50), line_to(100 + length, 50 + length),
                          curve_to(200, 150, 0, 200)};
        int steps[] = {0, 1, 2, 3};
        mt_contour_pair m = masters_of(a, b, 4);
        mt_contour_pair_tidy_lines(&m, steps, UNIT / 10);
        assert_int_equal(m.a.count, 4);
        assert_int_equal(m.a.segments[2].degree, length < 10 ? 2 : 1);
        assert_int_equal(m.b.segments[2].degree, m.a.segments[2].degree);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_line_in_several),
        cmocka_unit_test(nothing_in_both),
        cmocka_unit_test(short_lines_bend),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
