#include "geometry/limits.h"
#include "support/check.h"
#include "support/corpus.h"
#include "support/oracle.h"
#include "support/polygons.h"

#include <math.h>

static mt_arena arena;
static mt_corpus corpus;

static int set_up(void **state) {
    (void)state;
    corpus = mt_corpus_read(&arena);
    return 0;
}

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static const mt_ring *ring_named(const char *name) {
    return &mt_corpus_find(&corpus, name)->rings[0];
}

static void new_rings(void **state) {
    (void)state;
    mt_ring ring;
    mt_assert_ok(mt_ring_new(&arena, 3, &ring));
    assert_int_equal(ring.count, 3);
    assert_true(ring.points[2].x == 0 && ring.marks[2] == 0);
    mt_assert_ok(mt_ring_new(&arena, 0, &ring));
    assert_int_equal(mt_ring_new(&arena, MT_POINTS_MAX + 1, &ring), MT_TOO_LARGE);
}

static void areas_of_the_corpus(void **state) {
    (void)state;
    for (int i = 0; i < corpus.count; i++) {
        const mt_rings *rings = &corpus.shapes[i].rings;
        mt_subject subject = {corpus.shapes[i].name, -1, {rings}};
        mt_require(mt_component_area2(rings) == mt_oracle_area2(rings), &subject);
        double length = 0;
        for (int k = 0; k < rings->count; k++) length += mt_ring_length(&rings->rings[k]);
        mt_require(fabs(mt_oracle_length(rings) / length - 1) < 1e-12 || length == 0, &subject);
    }
}

/* The largest square, and a ring that goes a thousand times around it: 59 bits. */
static void areas_at_the_limits(void **state) {
    (void)state;
    const int32_t m = MT_COORD_MAX;
    const mt_point corners[] = {{-m, -m}, {m, -m}, {m, m}, {-m, m}};
    mt_ring square = mt_test_ring(&arena, 4), often = mt_test_ring(&arena, 4000);
    for (int i = 0; i < often.count; i++) often.points[i] = square.points[i % 4] = corners[i % 4];
    int64_t side = 2 * (int64_t)m;
    assert_true(mt_ring_area2(&square) == 2 * side * side);
    assert_true(mt_ring_area2(&often) == 2000 * side * side);
}

static void lengths(void **state) {
    (void)state;
    assert_true(mt_ring_length(ring_named("square")) == 400);
    assert_true(mt_ring_length(ring_named("square_with_repeats")) == 400);
    assert_true(mt_ring_length(ring_named("one_point")) == 0);
    for (int i = 0; i < 20; i++) {
        mt_random random = mt_random_case(i);
        mt_ring ring = mt_random_scrawl(&random, &arena, 50, MT_COORD_MAX);
        mt_rings alone = {1, &ring};
        assert_true(fabs(mt_ring_length(&ring) / mt_oracle_length(&alone) - 1) < 1e-12);
    }
}

static void boxes(void **state) {
    (void)state;
    mt_box box = mt_ring_box(ring_named("spikes_everywhere"));
    assert_true(box.min.x == -30 && box.min.y == -40 && box.max.x == 160 && box.max.y == 150);
    mt_ring nothing = {0};
    box = mt_ring_box(&nothing);
    assert_true(box.min.x == 0 && box.min.y == 0 && box.max.x == 0 && box.max.y == 0);
    mt_shape none = {0};
    box = mt_shape_box(&none);
    assert_true(box.min.x == 0 && box.max.y == 0);
    mt_component parts[] = {*mt_corpus_find(&corpus, "frame"),
                            mt_test_moved(&arena, mt_corpus_find(&corpus, "arrow"), 2, (mt_point){-50, 300})};
    mt_shape shape = {2, parts};
    box = mt_shape_box(&shape);
    assert_true(box.min.x == -50 && box.min.y == 0 && box.max.x == 150 && box.max.y == 500);
    assert_true(mt_shape_area2(&shape) == mt_oracle_shape_area2(&shape));
}

static void centre_is(const char *name, double x, double y) {
    double cx, cy;
    mt_ring_centre(ring_named(name), &cx, &cy);
    assert_true(fabs(cx - x) < 1e-9 && fabs(cy - y) < 1e-9);
}

static void centres(void **state) {
    (void)state;
    centre_is("triangle", 130 / 3.0, 80 / 3.0);
    centre_is("square", 50, 50);
    centre_is("square_with_runs", 50, 50);
    centre_is("plus", 50, 50);
    centre_is("backwards_square", 50, 50);
    centre_is("l_shape", (40 * 100 * 20 + 60 * 40 * 70) / 6400.0, (100 * 40 * 20 + 40 * 60 * 70) / 6400.0);
    centre_is("no_area", 50, 0);
    centre_is("one_point", 5, 5);
}

/* A thin ring far from the origin: the barycentre stays in its box. */
static void centre_of_a_sliver_far_out(void **state) {
    (void)state;
    const int32_t m = MT_COORD_MAX;
    mt_ring ring = mt_test_ring(&arena, 3);
    ring.points[0] = (mt_point){m - 2000, m};
    ring.points[1] = (mt_point){m - 1000, m - 1};
    ring.points[2] = (mt_point){m, m - 1};
    double x, y;
    mt_ring_centre(&ring, &x, &y);
    assert_true(fabs(x - (m - 1000)) < 1e-6 && fabs(y - (m - 2.0 / 3)) < 1e-6);
}

static bool has_repeats(const mt_ring *ring) {
    for (int i = 0; i < ring->count; i++)
        if (mt_point_equal(ring->points[i], ring->points[(i + 1) % ring->count])) return true;
    return false;
}

/* A repeated point is no turn, and a ring with one not convex. */
static void convexity(void **state) {
    (void)state;
    for (int i = 0; i < corpus.count; i++)
        for (int k = 0; k < corpus.shapes[i].rings.count; k++) {
            mt_rings one = {1, &corpus.shapes[i].rings.rings[k]};
            mt_subject subject = {corpus.shapes[i].name, -1, {&one}};
            bool expected = mt_oracle_is_convex(&one.rings[0]) && !has_repeats(&one.rings[0]);
            mt_require(mt_ring_is_convex(&one.rings[0]) == expected, &subject);
        }
    assert_true(mt_ring_is_convex(ring_named("square_with_runs")));
    assert_true(mt_ring_is_convex(ring_named("sliver")));
    assert_false(mt_ring_is_convex(ring_named("pentagram")));
    assert_false(mt_ring_is_convex(ring_named("no_area")));
    assert_false(mt_ring_is_convex(ring_named("backwards_square")));
    assert_false(mt_ring_is_convex(ring_named("spike_on_the_edge")));
}

static void convexity_of_a_ring_twice_around(void **state) {
    (void)state;
    mt_ring twice = mt_test_ring(&arena, 8);
    for (int i = 0; i < 8; i++) twice.points[i] = ring_named("square")->points[i % 4];
    assert_false(mt_ring_is_convex(&twice));
}

static void convexity_of_random_rings(void **state) {
    (void)state;
    int convex = 0;
    for (int i = 0; i < mt_test_cases(3000); i++) {
        mt_random random = mt_random_case(i);
        mt_ring ring = mt_random_scrawl(&random, &arena, mt_random_between(&random, 0, 6), i % 2 ? 3 : 100);
        mt_rings one = {1, &ring};
        mt_subject subject = {"convexity_of_random_rings", i, {&one}};
        mt_require(mt_ring_is_convex(&ring) == (mt_oracle_is_convex(&ring) && !has_repeats(&ring)), &subject);
        convex += mt_ring_is_convex(&ring);
        mt_arena_place place = mt_arena_mark(&arena);
        mt_component polygon = mt_random_polygon(&random, &arena, MT_POLYGON_CONVEX, 12, 1000);
        mt_require(mt_ring_is_convex(&polygon.rings[0]), &subject);
        mt_arena_rewind(&arena, place);
    }
    assert_true(convex > 50);
}

static bool in_hull(const mt_spot *hull, int count, mt_point p) {
    for (int i = 0; i < count; i++)
        if (hull[i].x == p.x && hull[i].y == p.y) return true;
    return false;
}

static void hulls(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(500); i++) {
        mt_random random = mt_random_case(i);
        mt_point points[40], hull[41];
        mt_spot spots[40], expected[40];
        int n = mt_random_between(&random, 1, 40), reach = i % 3 ? 4 : MT_COORD_MAX;
        for (int k = 0; k < n; k++) {
            points[k] = mt_random_point(&random, -reach, reach);
            spots[k] = mt_spot_of(points[k], 1);
        }
        int count = mt_convex_hull(points, n, hull);
        assert_int_equal(count, mt_oracle_hull(spots, n, expected));
        for (int k = 0; k < count; k++) assert_true(in_hull(expected, count, hull[k]));
        mt_ring ring = {count, hull, NULL};
        if (count > 2) assert_true(mt_oracle_is_convex(&ring));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(new_rings),
        cmocka_unit_test(areas_of_the_corpus),
        cmocka_unit_test(areas_at_the_limits),
        cmocka_unit_test(lengths),
        cmocka_unit_test(boxes),
        cmocka_unit_test(centres),
        cmocka_unit_test(centre_of_a_sliver_far_out),
        cmocka_unit_test(convexity),
        cmocka_unit_test(convexity_of_a_ring_twice_around),
        cmocka_unit_test(convexity_of_random_rings),
        cmocka_unit_test(hulls),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
