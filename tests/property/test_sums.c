/* The edge merge of two convex pieces against the convex hull of all sums of their corners. */
#include "geometry/limits.h"
#include "support/check.h"
#include "support/polygons.h"
#include "support/sums.h"

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* Pieces with points in line, as the decomposition leaves them. */
static mt_ring random_piece(mt_random *random, int extent) {
    mt_ring hull =
        mt_random_polygon(random, &arena, MT_POLYGON_CONVEX, mt_random_between(random, 3, 24), extent)
            .rings[0];
    mt_ring piece = mt_test_ring(&arena, 2 * hull.count);
    piece.count = 0;
    for (int i = 0; i < hull.count; i++) {
        mt_point p = hull.points[i], q = hull.points[(i + 1) % hull.count];
        piece.points[piece.count++] = p;
        mt_point middle = {p.x + (q.x - p.x) / 2, p.y + (q.y - p.y) / 2};
        bool exact = mt_oracle_orient(mt_spot_of(p, 1), mt_spot_of(q, 1), mt_spot_of(middle, 1)) == 0;
        if (exact && !mt_point_equal(p, middle) && mt_random_one_in(random, 3))
            piece.points[piece.count++] = middle;
    }
    return piece;
}

static int64_t to_grid(int64_t value) {
    int64_t sum = value + MT_WEIGHT_ONE / 2;
    return sum >= 0 ? sum / MT_WEIGHT_ONE : -((-sum + MT_WEIGHT_ONE - 1) / MT_WEIGHT_ONE);
}

static mt_point rounded(mt_spot spot) {
    return (mt_point){(int32_t)to_grid(spot.x), (int32_t)to_grid(spot.y)};
}

static bool on_hull(const mt_spot *hull, int count, mt_spot spot) {
    for (int i = 0; i < count; i++)
        if (mt_oracle_orient(hull[i], hull[(i + 1) % count], spot) == 0) return true;
    return false;
}

/* Whether a grid point is the rounded sum of two corners whose exact sum lies on the hull's boundary. */
static bool comes_from_boundary(mt_point point, const mt_ring *p, const mt_ring *q, mt_weights weights,
                                const mt_spot *hull, int count) {
    for (int i = 0; i < p->count; i++)
        for (int j = 0; j < q->count; j++) {
            mt_spot a = mt_spot_of(p->points[i], weights.a), b = mt_spot_of(q->points[j], weights.b);
            mt_spot sum = {a.x + b.x, a.y + b.y};
            if (mt_point_equal(rounded(sum), point) && on_hull(hull, count, sum)) return true;
        }
    return false;
}

/* Walks the sum once around from the hull's first corner: all corners come, in order. */
static bool has_corners_in_order(const mt_ring *sum, const mt_spot *hull, int count) {
    int at = 0;
    while (at < sum->count && !mt_point_equal(sum->points[at], rounded(hull[0]))) at++;
    for (int corner = 0, steps = 0; corner < count; corner++)
        while (!mt_point_equal(sum->points[at % sum->count], rounded(hull[corner]))) {
            at++;
            if (++steps > sum->count) return false;
        }
    return true;
}

/* Exact before rounding: each corner of the hull is there, rounded, in order, and nothing else but points
 * on its edges. */
static void check(const mt_ring *p, const mt_ring *q, mt_weights weights, const mt_subject *subject) {
    mt_ring sum = mt_test_ring(&arena, p->count + q->count);
    mt_minkowski(p, q, weights, &sum);
    mt_spot *hull = mt_test_new((size_t)p->count * (size_t)q->count, sizeof *hull);
    int count = mt_sums_hull(p, q, weights, hull);
    mt_require(sum.count <= p->count + q->count, subject);
    mt_require(has_corners_in_order(&sum, hull, count), subject);
    for (int i = 0; i < sum.count; i++) {
        mt_require(comes_from_boundary(sum.points[i], p, q, weights, hull, count), subject);
        mt_require(sum.count == 1 || !mt_point_equal(sum.points[i], sum.points[(i + 1) % sum.count]),
                   subject);
    }
    free(hull);
}

static void merge_is_the_hull_of_all_sums(void **state) {
    (void)state;
    static const int extents[] = {64, 1000, MT_EM, MT_COORD_MAX};
    for (int i = 0; i < mt_test_cases(400); i++) {
        mt_random random = mt_random_case(i);
        mt_ring p = random_piece(&random, extents[i % 4]), q = random_piece(&random, extents[i / 4 % 4]);
        mt_rings first = {1, &p}, second = {1, &q};
        mt_subject subject = {"merge_is_the_hull_of_all_sums", i, {&first, &second}};
        double t = mt_random_one_in(&random, 4) ? 0.5 : mt_random_unit(&random);
        check(&p, &q, mt_weights_at(mt_random_one_in(&random, 20) ? (double)(i % 2) : t), &subject);
        mt_arena_reset(&arena);
    }
}

/* With even coordinates and equal weights nothing is rounded: the sum is the hull, area and all, and
 * convex. */
static void exact_sums(void **state) {
    (void)state;
    const mt_weights half = {MT_WEIGHT_ONE / 2, MT_WEIGHT_ONE / 2, 0};
    for (int i = 0; i < mt_test_cases(300); i++) {
        mt_random random = mt_random_case(i);
        mt_ring pieces[2] = {random_piece(&random, 1000), random_piece(&random, i % 2 ? 1000 : 64)};
        mt_rings both = {2, pieces}, even = mt_test_moved(&arena, &both, 2, (mt_point){0, 0});
        mt_ring sum = mt_test_ring(&arena, even.rings[0].count + even.rings[1].count), *p = even.rings,
                *q = p + 1;
        mt_subject subject = {"exact_sums", i, {&even}};
        check(p, q, half, &subject);
        mt_minkowski(p, q, half, &sum);
        mt_require(mt_oracle_is_convex(&sum), &subject);
        mt_spot *hull = mt_test_new((size_t)p->count * (size_t)q->count, sizeof *hull);
        mt_ring expected = mt_test_ring(&arena, mt_sums_hull(p, q, half, hull));
        for (int k = 0; k < expected.count; k++) expected.points[k] = rounded(hull[k]);
        mt_rings one = {1, &sum}, other = {1, &expected};
        mt_require(mt_oracle_area2(&one) == mt_oracle_area2(&other), &subject);
        free(hull);
        mt_arena_reset(&arena);
    }
}

/* A with weight a and B with weight b is B with b and A with a. */
static void sides_can_be_swapped(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(200); i++) {
        mt_random random = mt_random_case(i);
        mt_ring p = random_piece(&random, MT_EM), q = random_piece(&random, 1000);
        mt_rings first = {1, &p}, second = {1, &q};
        mt_subject subject = {"sides_can_be_swapped", i, {&first, &second}};
        mt_weights weights = mt_weights_at(mt_random_unit(&random)), swapped = {weights.b, weights.a, 0};
        mt_ring one = mt_test_ring(&arena, p.count + q.count), two = mt_test_ring(&arena, p.count + q.count);
        mt_minkowski(&p, &q, weights, &one);
        mt_minkowski(&q, &p, swapped, &two);
        mt_require(one.count == two.count, &subject);
        for (int k = 0; k < one.count; k++)
            mt_require(mt_point_equal(one.points[k], two.points[k]), &subject);
        mt_arena_reset(&arena);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(merge_is_the_hull_of_all_sums),
        cmocka_unit_test(exact_sums),
        cmocka_unit_test(sides_can_be_swapped),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
