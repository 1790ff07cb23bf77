#include "geometry/limits.h"
#include "morph/fit/contour_pair.h"
#include "morph/fit/smooth.h"
#include "support/check.h"

#include <math.h>

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

enum { UNIT = MT_EM / 1000, SEGMENTS = 5 };

static mt_segment line_to(int x, int y) {
    return (mt_segment){.degree = 1, .end = {x * UNIT, y * UNIT}};
}

static mt_segment curve_to(int cx, int cy, int x, int y) {
    return (mt_segment){.degree = 2, .control = {{cx * UNIT, cy * UNIT}}, .end = {x * UNIT, y * UNIT}};
}

/* A stem's edge that runs into a bracket: up to (0, y), and round to the right. Node 1 is where the line meets the curve. */
static mt_contour bracketed(int y, mt_segment segments[SEGMENTS]) {
    segments[0] = line_to(0, 0);
    segments[1] = line_to(0, y);
    segments[2] = curve_to(0, 500, 300, 500);
    segments[3] = line_to(300, 600);
    segments[4] = line_to(-100, 600);
    return (mt_contour){SEGMENTS, segments};
}

/* The same stem without a bracket, leaning: node 1 is anywhere on its edge. */
static mt_contour leaning(int share, mt_segment segments[SEGMENTS]) {
    segments[0] = line_to(0, 0);
    segments[1] = line_to(share, 3 * share);
    segments[2] = curve_to(150, 450, 200, 600);
    segments[3] = line_to(190, 610);
    segments[4] = line_to(-100, 610);
    return (mt_contour){SEGMENTS, segments};
}

/* How the mix of both turns at node 1, degrees. */
static double turn_between(const mt_contour_pair *masters, double t) {
    mt_contour c;
    mt_assert_ok(mt_contour_pair_mix(masters, mt_weights_at(t), &arena, &c));
    mt_point before = c.segments[0].end, at = c.segments[1].end, after = c.segments[2].control[0];
    double ax = (double)at.x - before.x, ay = (double)at.y - before.y, bx = (double)after.x - at.x,
           by = (double)after.y - at.y;
    return fabs(atan2(ax * by - ay * bx, ax * bx + ay * by)) * 180 / 3.14159265358979323846;
}

static void a_node_on_a_line_follows_the_curve(void **state) {
    (void)state;
    for (int share = 10; share <= 130; share += 40) {
        mt_segment in_a[SEGMENTS], in_b[SEGMENTS];
        mt_contour_pair masters = {.a = bracketed(400, in_a), .b = leaning(share, in_b)};
        double before = turn_between(&masters, 0.5);
        mt_assert_ok(mt_contour_pair_smooth(&masters, UNIT, &arena));
        assert_true(before > 0.5);
        for (int k = 1; k < 8; k++) assert_true(turn_between(&masters, k / 8.0) < 0.05);
        for (int i = 0; i < SEGMENTS; i++) /* A, which is bent there, has nothing to gain */
            assert_true(mt_point_equal(masters.a.segments[i].end, bracketed(400, in_a).segments[i].end));
        mt_point at = masters.b.segments[1].end;
        assert_true(abs(3 * at.x - at.y) <= 4); /* still on its edge */
    }
}

/* Swapping the masters swaps what comes out. */
static void either_way_round(void **state) {
    (void)state;
    mt_segment p[SEGMENTS], q[SEGMENTS], r[SEGMENTS], s[SEGMENTS];
    mt_contour_pair one = {.a = bracketed(350, p), .b = leaning(40, q)},
                    other = {.a = leaning(40, r), .b = bracketed(350, s)};
    mt_assert_ok(mt_contour_pair_smooth(&one, UNIT, &arena));
    mt_assert_ok(mt_contour_pair_smooth(&other, UNIT, &arena));
    for (int i = 0; i < SEGMENTS; i++) {
        assert_true(mt_point_equal(one.a.segments[i].end, other.b.segments[i].end));
        assert_true(mt_point_equal(one.b.segments[i].end, other.a.segments[i].end));
    }
}

/* A corner is no kink. */
static void corners_stay(void **state) {
    (void)state;
    mt_segment in_a[SEGMENTS], in_b[SEGMENTS];
    mt_contour_pair masters = {.a = bracketed(400, in_a), .b = leaning(100, in_b)};
    in_b[1] = line_to(20, 300);
    mt_assert_ok(mt_contour_pair_smooth(&masters, UNIT, &arena));
    assert_true(mt_point_equal(masters.b.segments[1].end, line_to(20, 300).end));
    assert_true(mt_point_equal(masters.a.segments[1].end, line_to(0, 400).end));
}

/* Where both are bent, neither departs from its curve by more than is allowed: by nothing, nothing moves. */
static void no_master_is_bent(void **state) {
    (void)state;
    mt_segment in_a[SEGMENTS], in_b[SEGMENTS];
    mt_contour_pair masters = {.a = bracketed(400, in_a), .b = bracketed(400, in_b)};
    in_a[1] = curve_to(40, 150, 40, 300);
    in_a[2] = curve_to(40, 500, 300, 500);
    in_b[1] = curve_to(100, 0, 200, 100);
    in_b[2] = curve_to(260, 160, 300, 500);
    mt_assert_ok(mt_contour_pair_smooth(&masters, 0, &arena));
    assert_true(mt_point_equal(masters.a.segments[1].end, line_to(40, 300).end));
    assert_true(mt_point_equal(masters.b.segments[1].end, line_to(200, 100).end));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_node_on_a_line_follows_the_curve),
        cmocka_unit_test(either_way_round),
        cmocka_unit_test(corners_stay),
        cmocka_unit_test(no_master_is_bent),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
