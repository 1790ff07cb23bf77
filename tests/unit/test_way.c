#include "morph/check/way.h"
#include "support/check.h"
#include "support/random.h"

static const mt_steps whole = {0, MT_WAY_STEPS, true, true}, closed = {0, MT_WAY_STEPS, false, false};

static mt_way way(int x, int y, int to_x, int to_y) {
    return (mt_way){{{x, y}, {to_x, to_y}}};
}

static mt_way still(int x, int y) {
    return way(x, y, x, y);
}

static void a_side_is_known_where_it_stays(void **state) {
    (void)state;
    mt_way a = still(0, 0), b = still(100, 0), above = way(10, 5, 90, 1), across = way(50, 5, 50, -5),
           lifting = way(50, 0, 50, 1), on = way(10, 0, 90, 0);
    assert_int_equal(mt_steady_side(&a, &b, &above, whole), 1);
    assert_int_equal(mt_steady_side(&b, &a, &above, whole), -1);
    assert_int_equal(mt_steady_side(&a, &b, &across, whole), 0);
    assert_int_equal(mt_steady_side(&a, &b, &lifting, whole), 1);
    assert_int_equal(mt_steady_side(&a, &b, &lifting, closed), 0);
    assert_int_equal(mt_steady_side(&a, &b, &on, whole), 0);
}

/* A third of the way is no step: between two. */
static void a_pass_is_found_to_a_step(void **state) {
    (void)state;
    mt_way a = still(0, 0), b = still(100, 0), down = way(50, 10, 50, -20), beside = way(150, 10, 150, -20);
    mt_steps found[MT_PASSES_MOST];
    assert_int_equal(mt_passes(&a, &b, &down, whole, found), 1);
    assert_int_equal(found[0].from, MT_WAY_STEPS / 3);
    assert_int_equal(found[0].to, MT_WAY_STEPS / 3 + 1);
    assert_true(mt_stays_between(&a, &b, &down, found[0]));
    assert_int_equal(mt_passes(&a, &b, &beside, whole, found), 0);
}

/* The segment tilts while the point moves along it: over it, and back. */
static void a_quadratic_has_two_passes(void **state) {
    (void)state;
    mt_way a = way(-100, 6, -100, -2), b = way(100, -2, 100, 6), c = way(-50, 3, 50, 3);
    mt_steps found[MT_PASSES_MOST];
    assert_int_equal(mt_passes(&a, &b, &c, whole, found), 2);
    assert_true(found[0].to < found[1].from);
}

static void touching_at_a_place_is_a_pass(void **state) {
    (void)state;
    mt_way a = way(0, 0, 100, 0), b = way(200, 100, 100, 100),
           c = way(50, 50, 100, 50); /* the same motion half-way */
    mt_way d = way(50, 10, 50, 0);   /* arrives at the end only */
    mt_way e = still(0, 0), f = still(100, 0);
    mt_steps found[MT_PASSES_MOST];
    assert_true(mt_passes(&a, &b, &c, closed, found) != 0);
    assert_int_equal(mt_passes(&e, &f, &d, whole, found), 0);
    assert_int_equal(mt_passes(&e, &f, &d, closed, found), 1);
    assert_int_equal(found[0].to, MT_WAY_STEPS);
}

static void what_stays_on_the_line_is_told(void **state) {
    (void)state;
    mt_way a = way(0, 0, 7, 100), b = way(100, 0, 107, 100), on = way(10, 0, 97, 100),
           off = way(110, 0, 117, 100);
    mt_steps found[MT_PASSES_MOST];
    assert_int_equal(mt_passes(&a, &b, &on, whole, found), -1);
    assert_int_equal(mt_passes(&a, &b, &off, whole, found), 0);
}

static void folds_are_found_and_straight_angles_are_not(void **state) {
    (void)state;
    mt_way v = still(0, 0), a = still(100, 0), folding = way(50, 10, 50, -10),
           straight = way(-50, 10, -50, -10);
    mt_steps found[MT_PASSES_MOST];
    assert_int_equal(mt_folds(&v, &a, &folding, whole, found), 1);
    assert_int_equal(mt_folds(&v, &a, &straight, whole, found), 0);
}

/* ---- at random -------------------------------------------------------------------------------------------------- */

static int64_t at(const mt_way *w, int axis, int step) {
    int64_t from = axis ? w->at[0].y : w->at[0].x, to = axis ? w->at[1].y : w->at[1].x;
    return from * (MT_WAY_STEPS - step) + to * step;
}

static mt_wide side_at(const mt_way *a, const mt_way *b, const mt_way *c, int step) {
    return (mt_wide)(at(b, 0, step) - at(a, 0, step)) * (at(c, 1, step) - at(a, 1, step)) -
           (mt_wide)(at(b, 1, step) - at(a, 1, step)) * (at(c, 0, step) - at(a, 0, step));
}

static mt_wide along_at(const mt_way *a, const mt_way *b, const mt_way *from, const mt_way *c, int step) {
    return (mt_wide)(at(b, 0, step) - at(a, 0, step)) * (at(c, 0, step) - at(from, 0, step)) +
           (mt_wide)(at(b, 1, step) - at(a, 1, step)) * (at(c, 1, step) - at(from, 1, step));
}

static mt_way random_way(mt_random *random, int extent) {
    return (mt_way){{mt_random_point(random, -extent, extent), mt_random_point(random, -extent, extent)}};
}

static bool is_in(const mt_steps *found, int count, int from, int to) {
    for (int i = 0; i < count; i++)
        if (found[i].from < to && from < found[i].to) return true;
    return false;
}

/* Where the side changes between two steps with the point between the ends at both, a pass is found there; and at a pass the side
 * changes, or the point is near an end, or only touches. */
static void passes_are_where_the_side_changes(void **state) {
    (void)state;
    static const int extents[] = {20, 10000, MT_WAY_MOST};
    enum { STRIDE = MT_WAY_STEPS / 64 };
    int passes = 0, free_ways = 0;
    for (int i = 0; i < mt_test_cases(3000); i++) {
        mt_random random = mt_random_case(i);
        int extent = extents[i % 3];
        mt_way a = random_way(&random, extent), b = random_way(&random, extent),
               c = random_way(&random, extent);
        mt_steps found[MT_PASSES_MOST];
        int count = mt_passes(&a, &b, &c, whole, found);
        for (int k = 0; k < MT_WAY_STEPS && count >= 0; k += STRIDE) {
            bool changes = (side_at(&a, &b, &c, k) > 0) != (side_at(&a, &b, &c, k + STRIDE) > 0),
                 between = true;
            for (int n = k; n <= k + STRIDE; n += STRIDE / 64)
                between = between && along_at(&a, &b, &a, &c, n) > 0 && along_at(&a, &b, &b, &c, n) < 0;
            if (changes && between) assert_true(is_in(found, count, k, k + STRIDE));
        }
        for (int k = 0; k < count; k++)
            if (mt_stays_between(&a, &b, &c, found[k]) && found[k].to - found[k].from == 1)
                passes += (side_at(&a, &b, &c, found[k].from) > 0) != (side_at(&a, &b, &c, found[k].to) > 0);
        free_ways += count == 0;
    }
    assert_true(passes > 100 && free_ways > 100);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_side_is_known_where_it_stays),
        cmocka_unit_test(a_pass_is_found_to_a_step),
        cmocka_unit_test(a_quadratic_has_two_passes),
        cmocka_unit_test(touching_at_a_place_is_a_pass),
        cmocka_unit_test(what_stays_on_the_line_is_told),
        cmocka_unit_test(folds_are_found_and_straight_angles_are_not),
        cmocka_unit_test(passes_are_where_the_side_changes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
