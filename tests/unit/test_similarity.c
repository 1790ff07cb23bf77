#include "morph/paper/similarity.h"
#include "support/check.h"
#include "support/corpus.h"
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

static mt_hull hull_of(const mt_component *component, mt_box box) {
    mt_hull hull;
    mt_assert_ok(mt_hull_of(component, box, &arena, &hull));
    return hull;
}

static bool near(double x, double y) {
    return fabs(x - y) < 1e-12;
}

/* An L in the left half of a box of 200 × 100: its hull lacks the corner at (100, 100). */
static void hull_by_hand(void **state) {
    (void)state;
    mt_box box = {{0, 0}, {200, 100}};
    mt_hull hull = hull_of(mt_corpus_find(&corpus, "l_shape"), box);
    double area = 10000 - 60 * 60 / 2.0;
    assert_true(near(hull.area, area / (200 * 200)));
    assert_true(near(hull.low[0], 0) && near(hull.low[1], 0) && near(hull.high[0], 0.5) &&
                near(hull.high[1], 1));
    double centre = (10000 * 50 - 1800 * 80) / area;
    assert_true(near(hull.centre[0], centre / 200) && near(hull.centre[1], centre / 100));
}

/* The place in the glyph's rectangle counts, not that in the plane; holes do not. */
static void moved_and_hollow(void **state) {
    (void)state;
    mt_box box = {{0, 0}, {300, 300}}, moved_box = {{-50, 70}, {250, 370}};
    const mt_component *frame = mt_corpus_find(&corpus, "frame"), *square = mt_corpus_find(&corpus, "square");
    mt_component moved = mt_test_moved(&arena, frame, 1, (mt_point){-50, 70});
    mt_hull one = hull_of(square, box), other = hull_of(&moved, moved_box);
    assert_true(near(one.area, other.area));
    for (int axis = 0; axis < 2; axis++) {
        assert_true(near(one.centre[axis], other.centre[axis]));
        assert_true(near(one.low[axis], other.low[axis]) && near(one.high[axis], other.high[axis]));
    }
}

/* A glyph that is no wider than one unit, or a component that has no width: no division by nothing. */
static void flat(void **state) {
    (void)state;
    const mt_component *smallest = mt_corpus_find(&corpus, "smallest");
    mt_hull hull = hull_of(smallest, (mt_box){{0, 0}, {1, 1}});
    assert_true(isfinite(hull.area) && isfinite(hull.centre[0]) && isfinite(hull.centre[1]));
    hull = hull_of(mt_corpus_find(&corpus, "no_area"), (mt_box){{0, 0}, {100, 0}});
    assert_true(isfinite(hull.area) && isfinite(hull.centre[1]) && isfinite(hull.high[1]));
}

static const double third[3] = {1 / 3.0, 1 / 3.0, 1 / 3.0};

/* m is a similarity: 1 for equal hulls, within 0 … 1, symmetric. */
static void range_and_symmetry(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(300); i++) {
        mt_random random = mt_random_case(i);
        mt_shape shape = mt_random_shape(&random, &arena, 4, 12, 10000);
        mt_box box = mt_shape_box(&shape);
        mt_hull one = hull_of(&shape.components[0], box),
                other = hull_of(&shape.components[shape.count - 1], box);
        double w = mt_random_unit(&random), weights[3] = {w, (1 - w) / 4, 3 * (1 - w) / 4};
        double m = mt_similarity(&one, &other, weights);
        assert_true(m >= 0 && m <= 1 && near(m, mt_similarity(&other, &one, weights)));
        assert_true(near(mt_similarity(&one, &one, weights), 1));
        mt_arena_reset(&arena);
    }
}

/* Each weight alone: by place, by area, by box. */
static void parts(void **state) {
    (void)state;
    mt_hull small = {{0.25, 0.25}, 0.01, {0.2, 0.2}, {0.3, 0.3}},
            large = {{0.75, 0.25}, 0.04, {0.6, 0.1}, {0.9, 0.4}};
    const double place[3] = {1, 0, 0}, area[3] = {0, 1, 0}, box[3] = {0, 0, 1};
    assert_true(near(mt_similarity(&small, &large, place), 1 - 0.25 / (0.5 * 0.5 + 1)));
    assert_true(near(mt_similarity(&small, &large, area), 0.25));
    assert_true(near(mt_similarity(&small, &large, box), 1 - (0.4 + 0.6 + 0.1 + 0.1) / 4));
    double all = (1 - 0.25 / 1.25 + 0.25 + 0.7) / 3;
    assert_true(near(mt_similarity(&small, &large, third), all));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hull_by_hand), cmocka_unit_test(moved_and_hollow),   cmocka_unit_test(flat),
        cmocka_unit_test(parts),        cmocka_unit_test(range_and_symmetry),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
