#include "geometry/limits.h"
#include "geometry/outline.h"
#include "support/check.h"
#include "support/curves.h"
#include "support/oracle.h"

#include <math.h>

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static mt_ring flattened(const mt_contour *contour, double tolerance) {
    mt_outline outline = mt_curves_outline(&arena, contour);
    mt_rings rings;
    mt_assert_ok(mt_flatten(&outline, tolerance, &arena, &rings));
    assert_int_equal(rings.count, 1);
    return rings.rings[0];
}

static void lines_are_kept(void **state) {
    (void)state;
    mt_segment sides[] = {
        {1, {{0}}, {100, 0}}, {1, {{0}}, {100, 100}}, {1, {{0}}, {0, 100}}, {1, {{0}}, {0, 0}}};
    mt_ring ring = flattened(&(mt_contour){4, sides}, 1);
    assert_int_equal(ring.count, 4);
    for (int i = 0; i < 4; i++) {
        assert_true(mt_point_equal(ring.points[i], sides[i].end));
        assert_int_equal(ring.marks[i], MT_CORNER | MT_LINE);
    }
}

/* A quadratic whose second difference is 8 × 1000 long needs √1000 chords for an error of 1: the bound is
 * exact. */
static void chords_of_a_quadratic(void **state) {
    (void)state;
    mt_segment sides[] = {{2, {{4000, 4000}}, {8000, 0}}, {1, {{0}}, {0, 0}}};
    mt_ring ring = flattened(&(mt_contour){2, sides}, 1);
    assert_int_equal(ring.count, (int)ceil(sqrt(8000 / 4.0)) + 1);
    ring = flattened(&(mt_contour){2, sides}, 2000);
    assert_int_equal(ring.count, 5 + 1); /* it turns by 90°: five chords of 20° or less */
}

static void marks(void **state) {
    (void)state;
    mt_segment sides[] = {
        {1, {{0}}, {1000, 0}},          /* runs on into the curve */
        {2, {{2000, 0}}, {2000, 1000}}, /* a quarter, on into the next */
        {2, {{2000, 2000}}, {1000, 2000}},
        {1, {{0}}, {0, 2000}}, /* a corner at its end */
        {1, {{0}}, {0, 0}},
    };
    mt_ring ring = flattened(&(mt_contour){5, sides}, 10);
    for (int i = 0; i < ring.count; i++) {
        mt_point p = ring.points[i];
        bool corner = p.x == 0, line = p.x == 0 || (p.x == 1000 && p.y == 2000);
        assert_int_equal(ring.marks[i], (corner ? MT_CORNER : 0) | (line ? MT_LINE : MT_CHORD));
    }
}

/* A quarter circle meets a line at a right angle: corners, although a curve takes part. */
static void corners_at_curves(void **state) {
    (void)state;
    mt_segment sides[] = {
        {3, {{1000, 552}, {552, 1000}}, {0, 1000}}, {1, {{0}}, {0, 0}}, {1, {{0}}, {1000, 0}}};
    mt_ring ring = flattened(&(mt_contour){3, sides}, 1);
    int corners = 0;
    for (int i = 0; i < ring.count; i++) corners += ring.marks[i] & MT_CORNER;
    assert_int_equal(corners, 3);
}

static void small_contours_are_left_out(void **state) {
    (void)state;
    mt_segment dot[] = {{1, {{0}}, {5, 5}}, {2, {{5, 5}}, {5, 5}}};
    mt_segment stroke[] = {{1, {{0}}, {100, 0}}, {1, {{0}}, {0, 0}}};
    mt_segment same[] = {{1, {{0}}, {9, 9}}, {1, {{0}}, {9, 9}}, {1, {{0}}, {0, 9}}, {1, {{0}}, {0, 9}}};
    mt_contour contours[] = {{2, dot}, {0, NULL}, {2, stroke}, {4, same}};
    mt_outline outline = {4, contours};
    mt_rings rings;
    mt_assert_ok(mt_flatten(&outline, 1, &arena, &rings));
    assert_int_equal(rings.count, 0);
}

static void no_point_twice(const mt_ring *ring) {
    for (int i = 0; i < ring->count; i++)
        assert_false(mt_point_equal(ring->points[i], ring->points[(i + 1) % ring->count]));
}

/* Vertices lie on the curve but for rounding (√½ of a unit, and the oracle's own chords); the curve keeps
 * to the ring within the tolerance and that much. */
static void within_tolerance(void **state) {
    (void)state;
    static const double tolerances[] = {1, 13, 256, 2560};
    for (int n = 0; n < mt_test_cases(24); n++) {
        mt_random random = mt_random_case(n);
        mt_contour contour = mt_random_contour(&random, &arena, mt_random_between(&random, 3, 6), MT_EM);
        mt_outline outline = mt_curves_outline(&arena, &contour);
        double tolerance = tolerances[n % 4], rounding = sqrt(0.5) + 0.05;
        mt_ring ring = flattened(&contour, tolerance);
        mt_rings alone = {1, &ring};
        mt_subject subject = {"within_tolerance", n, {&alone}};
        no_point_twice(&ring);
        for (int i = 0; i < ring.count; i += 1 + ring.count / 50)
            mt_require(mt_curves_distance(&outline, ring.points[i].x, ring.points[i].y) <= rounding,
                       &subject);
        for (int i = 0; i < contour.count; i++)
            for (int k = 0; k < 100; k++) {
                mt_place2 p = mt_curves_at(&contour, i, k / 100.0);
                mt_spot spot = {llround(p.x * 1024), llround(p.y * 1024)};
                mt_require(mt_oracle_distance(&alone, 1024, spot) <= tolerance + rounding, &subject);
            }
        mt_arena_reset(&arena);
    }
}

static double turn_at(const mt_ring *ring, int i) {
    mt_point a = ring->points[(i + ring->count - 1) % ring->count], b = ring->points[i];
    mt_point c = ring->points[(i + 1) % ring->count];
    return fabs(atan2((double)mt_cross(a, b, b, c), (double)mt_dot(a, b, b, c))) * 180 / M_PI;
}

/* However loose the tolerance, a circle of four cubics turns by at most MT_CHORD_TURN at a vertex, 1.5
 * times that where the curve turns faster than on average. */
static void rounds_stay_round(void **state) {
    (void)state;
    const int r = 100000, c = 55228;
    mt_segment quarters[] = {{3, {{r, c}, {c, r}}, {0, r}},
                             {3, {{-c, r}, {-r, c}}, {-r, 0}},
                             {3, {{-r, -c}, {-c, -r}}, {0, -r}},
                             {3, {{c, -r}, {r, -c}}, {r, 0}}};
    mt_ring ring = flattened(&(mt_contour){4, quarters}, 1e6);
    assert_true(ring.count >= 18);
    for (int i = 0; i < ring.count; i++) {
        assert_true(turn_at(&ring, i) <= 1.5 * MT_CHORD_TURN);
        assert_int_equal(ring.marks[i], MT_CHORD);
    }
}

static void too_many_points(void **state) {
    (void)state;
    int count = 2000;
    mt_contour contour = {count, mt_arena_new(&arena, (size_t)count, sizeof(mt_segment))};
    for (int i = 0; i < count; i++)
        contour.segments[i] =
            (mt_segment){2, {{MT_COORD_MAX, MT_COORD_MAX}}, {-MT_COORD_MAX, i % 2 ? 0 : -MT_COORD_MAX}};
    mt_outline outline = mt_curves_outline(&arena, &contour);
    mt_rings rings;
    assert_int_equal(mt_flatten(&outline, 1, &arena, &rings), MT_TOO_LARGE);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_are_kept),
        cmocka_unit_test(chords_of_a_quadratic),
        cmocka_unit_test(marks),
        cmocka_unit_test(corners_at_curves),
        cmocka_unit_test(rounds_stay_round),
        cmocka_unit_test(small_contours_are_left_out),
        cmocka_unit_test(within_tolerance),
        cmocka_unit_test(too_many_points),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
