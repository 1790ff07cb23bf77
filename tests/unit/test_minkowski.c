#include "geometry/limits.h"
#include "support/check.h"
#include "support/polygons.h"
#include "support/sums.h"

#include <math.h>

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static const mt_weights all_a = {MT_WEIGHT_ONE, 0, 0}, all_b = {0, MT_WEIGHT_ONE, 0};
static const mt_weights half = {MT_WEIGHT_ONE / 2, MT_WEIGHT_ONE / 2, 0};

static mt_ring sum_of(const mt_ring *p, const mt_ring *q, mt_weights weights) {
    mt_ring sum = mt_test_ring(&arena, p->count + q->count);
    mt_minkowski(p, q, weights, &sum);
    return sum;
}

static mt_ring box(int left, int bottom, int right, int top) {
    mt_ring ring = mt_test_ring(&arena, 4);
    mt_point corners[] = {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
    for (int i = 0; i < 4; i++) ring.points[i] = corners[i];
    return ring;
}

static void weights_add_up(void **state) {
    (void)state;
    for (int i = 0; i <= 1000; i++) {
        mt_weights weights = mt_weights_at(i / 1000.0);
        assert_int_equal(weights.a + weights.b, MT_WEIGHT_ONE);
        assert_true(fabs(weights.b - i / 1000.0 * MT_WEIGHT_ONE) <= 0.5);
    }
    assert_int_equal(mt_weights_at(0).b, 0);
    assert_int_equal(mt_weights_at(1).a, 0);
}

/* floor((a p + b q) / one + 1/2), in 128 bits. */
static int32_t mixed(mt_weights weights, int32_t p, int32_t q) {
    mt_wide sum = (mt_wide)weights.a * p + (mt_wide)weights.b * q + MT_WEIGHT_ONE / 2;
    mt_wide quotient = sum / MT_WEIGHT_ONE;
    return (int32_t)(quotient - (sum % MT_WEIGHT_ONE < 0));
}

static void mixes(void **state) {
    (void)state;
    const int m = MT_COORD_MAX;
    mt_random random = mt_random_case(0);
    for (int i = 0; i < mt_test_cases(10000); i++) {
        mt_weights weights = mt_weights_at(mt_random_unit(&random));
        mt_point p = mt_random_point(&random, -m, m);
        mt_point q = mt_random_point(&random, -m, m);
        mt_point mix = mt_mix(weights, p, q);
        assert_int_equal(mix.x, mixed(weights, p.x, q.x));
        assert_int_equal(mix.y, mixed(weights, p.y, q.y));
        assert_true(mt_point_equal(mt_mix(weights, p, p), p));
        assert_true(mt_point_equal(mt_mix(all_a, p, q), p));
        assert_true(mt_point_equal(mt_mix(all_b, p, q), q));
    }
    assert_int_equal(mt_mix(half, (mt_point){0, 0}, (mt_point){1, -1}).x, 1); /* halves up */
    assert_int_equal(mt_mix(half, (mt_point){0, 0}, (mt_point){1, -1}).y, 0);
}

static void boxes(void **state) {
    (void)state;
    mt_ring p = box(0, 0, 100, 40), q = box(20, 30, 40, 130), sum = sum_of(&p, &q, half);
    assert_int_equal(sum.count, 4);
    mt_box around = mt_ring_box(&sum);
    assert_true(around.min.x == 10 && around.min.y == 15 && around.max.x == 70 && around.max.y == 85);
}

/* Edges of different directions all appear: a square and a diamond make an octagon. */
static void octagon(void **state) {
    (void)state;
    mt_ring square = box(0, 0, 100, 100), diamond = mt_test_ring(&arena, 4);
    mt_point corners[] = {{0, -50}, {50, 0}, {0, 50}, {-50, 0}};
    for (int i = 0; i < 4; i++) diamond.points[i] = corners[i];
    mt_ring sum = sum_of(&square, &diamond, half);
    assert_int_equal(sum.count, 8);
    assert_true(mt_ring_area2(&sum) == 2 * (100 * 100 - 2 * 25 * 25));
}

/* The ends give the pieces themselves, from the lowest point on; a piece with itself gives it back at any
 * weight. */
static void ends(void **state) {
    (void)state;
    for (int i = 0; i < 50; i++) {
        mt_random random = mt_random_case(i);
        mt_ring p = mt_random_polygon(&random, &arena, MT_POLYGON_CONVEX, 20, MT_EM).rings[0];
        mt_ring q = mt_random_polygon(&random, &arena, MT_POLYGON_CONVEX, 9, MT_EM).rings[0];
        mt_ring sums[] = {sum_of(&p, &q, all_a), sum_of(&q, &p, all_b),
                          sum_of(&p, &p, mt_weights_at(mt_random_unit(&random)))};
        for (int k = 0; k < 3; k++) {
            assert_int_equal(sums[k].count, p.count);
            for (int c = 0; c < p.count; c++) assert_true(mt_point_equal(sums[k].points[c], p.points[c]));
        }
        mt_arena_reset(&arena);
    }
}

/* Whether a point is to the left of all edges, but for what two rounded corners may be off. */
static bool is_inside(const mt_ring *ring, mt_point point) {
    for (int i = 0; i < ring->count; i++) {
        mt_point a = ring->points[i], b = ring->points[(i + 1) % ring->count];
        double length = hypot(b.x - a.x, b.y - a.y);
        if ((double)mt_orient(a, b, point) < -2 * length - 2) return false;
    }
    return true;
}

/* With other weights upwards than across the sum is the hull of all weighted corners, in both directions, at its ends too. */
static void directions(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(300); i++) {
        mt_random random = mt_random_case(i);
        mt_ring p = mt_random_polygon(&random, &arena, MT_POLYGON_CONVEX, 20, MT_EM).rings[0];
        mt_ring q = mt_random_polygon(&random, &arena, MT_POLYGON_CONVEX, 9, MT_EM).rings[0];
        mt_at at = {mt_random_one_in(&random, 5) ? i % 2 : mt_random_unit(&random),
                    mt_random_one_in(&random, 5) ? i % 2 : mt_random_unit(&random)};
        mt_weights weights = mt_weights_of(at);
        mt_ring sum = sum_of(&p, &q, weights);
        assert_true(mt_ring_area2(&sum) > 0);
        for (int k = 0; k < p.count; k++)
            for (int l = 0; l < q.count; l++)
                assert_true(is_inside(&sum, mt_mix(weights, p.points[k], q.points[l])));
        mt_arena_reset(&arena);
    }
}

static void directions_are_apart(void **state) {
    (void)state;
    mt_ring p = box(0, 0, 100, 40), q = box(20, 30, 40, 130),
            sum = sum_of(&p, &q, mt_weights_of((mt_at){0.25, 0.75}));
    mt_box around = mt_ring_box(&sum);
    assert_true(around.min.x == 5 && around.max.x == 85);
    assert_true(around.min.y == 23 && around.max.y == 108); /* 22.5 and 107.5, halves up */
}

/* Where one of the two corners is smooth the sum is smooth; at the ends only that end's own marks count; a
 * line with a chord along it is a line. */
static void marks(void **state) {
    (void)state;
    mt_ring p = box(0, 0, 100, 100), q = box(0, 0, 50, 50);
    for (int i = 0; i < 4; i++) {
        p.marks[i] = MT_CORNER | MT_LINE;
        q.marks[i] = MT_CHORD;
    }
    mt_ring at_a = sum_of(&p, &q, all_a), between = sum_of(&p, &q, half), at_b = sum_of(&p, &q, all_b);
    mt_ring corners = sum_of(&p, &p, half);
    for (int i = 0; i < 4; i++) {
        assert_int_equal(at_a.marks[i], MT_CORNER | MT_LINE);
        assert_int_equal(between.marks[i], MT_LINE);
        assert_int_equal(at_b.marks[i], MT_CHORD);
        assert_int_equal(corners.marks[i], MT_CORNER | MT_LINE);
    }
}

/* Edges that no edge of the other piece is parallel to keep their own marks. */
static void marks_of_edges(void **state) {
    (void)state;
    mt_ring square = box(0, 0, 100, 100), diamond = mt_test_ring(&arena, 4);
    mt_point corners[] = {{0, -50}, {50, 0}, {0, 50}, {-50, 0}};
    for (int i = 0; i < 4; i++) {
        diamond.points[i] = corners[i];
        diamond.marks[i] = MT_CORNER | MT_CHORD;
        square.marks[i] = MT_CORNER | MT_LINE;
    }
    mt_ring sum = sum_of(&square, &diamond, half);
    for (int i = 0; i < 8; i++) {
        mt_point p = sum.points[i], q = sum.points[(i + 1) % 8];
        bool upright = p.x == q.x || p.y == q.y;
        assert_int_equal(sum.marks[i], MT_CORNER | (upright ? MT_LINE : MT_CHORD));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(weights_add_up),
        cmocka_unit_test(mixes),
        cmocka_unit_test(boxes),
        cmocka_unit_test(octagon),
        cmocka_unit_test(ends),
        cmocka_unit_test(marks),
        cmocka_unit_test(marks_of_edges),
        cmocka_unit_test(directions),
        cmocka_unit_test(directions_are_apart),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
