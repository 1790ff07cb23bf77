#include "geometry/outline.h"
#include "geometry/union.h"
#include "support/check.h"
#include "support/curves.h"
#include "support/oracle.h"

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static mt_contour box(int left, int low, int right, int high, bool backwards) {
    mt_contour contour = {4, mt_arena_new(&arena, 4, sizeof(mt_segment))};
    mt_point corners[] = {{right, low}, {right, high}, {left, high}, {left, low}};
    for (int i = 0; i < 4; i++)
        contour.segments[i] = (mt_segment){.degree = 1, .end = corners[backwards ? 3 - i : i]};
    return contour;
}

static bool is_clean(mt_contour *contours, int count, int64_t area2) {
    mt_outline outline = {count, contours};
    mt_shape shape;
    bool clean;
    mt_assert_ok(mt_outline_resolve(&outline, 100, &arena, &shape, &clean));
    assert_true(mt_oracle_shape_area2(&shape) == area2);
    return clean;
}

/* Contours that neither cross nor overlap are clean, holes included, and whichever way round the whole is
 * drawn. */
static void clean_outlines(void **state) {
    (void)state;
    mt_contour apart[] = {box(0, 0, 1000, 1000, false), box(2000, 0, 3000, 1000, false)};
    mt_contour frame[] = {box(0, 0, 1000, 1000, false), box(200, 200, 800, 800, true)};
    mt_contour backwards[] = {box(0, 0, 1000, 1000, true), box(200, 200, 800, 800, false)};
    assert_true(is_clean(apart, 2, 4000000));
    assert_true(is_clean(frame, 2, 2 * (1000000 - 360000)));
    assert_true(is_clean(backwards, 2, 2 * (1000000 - 360000)));
    assert_true(is_clean(NULL, 0, 0));
}

static void overlaps(void **state) {
    (void)state;
    mt_contour crossed[] = {box(0, 400, 1000, 600, false), box(400, 0, 600, 1000, false)};
    mt_contour nested[] = {box(0, 0, 1000, 1000, false), box(200, 200, 800, 800, false)};
    mt_contour twice[] = {box(0, 0, 1000, 1000, false), box(0, 0, 1000, 1000, false)};
    assert_false(is_clean(crossed, 2, 2 * (200000 + 200000 - 40000)));
    assert_false(is_clean(nested, 2, 2000000));
    assert_false(is_clean(twice, 2, 2000000));
}

static void a_contour_across_itself(void **state) {
    (void)state;
    mt_segment sides[] = {
        {1, {{0}}, {1000, 1000}}, {1, {{0}}, {1000, 0}}, {1, {{0}}, {0, 1000}}, {1, {{0}}, {0, 0}}};
    mt_contour bow_tie = {4, sides};
    assert_false(is_clean(&bow_tie, 1, 2 * 500000));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clean_outlines),
        cmocka_unit_test(overlaps),
        cmocka_unit_test(a_contour_across_itself),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
