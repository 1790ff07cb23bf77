/* The oracles themselves, on figures that can be worked out by hand, and the shapes of the corpus. */
#include "support/check.h"
#include "support/corpus.h"
#include "support/polygons.h"
#include "support/sums.h"

#include <math.h>

static mt_corpus corpus;
static mt_arena arena;

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

static void areas(void **state) {
    (void)state;
    assert_true(mt_oracle_area2(mt_corpus_find(&corpus, "square")) == 20000);
    assert_true(mt_oracle_area2(mt_corpus_find(&corpus, "frame")) == 20000 - 7200);
    assert_true(mt_oracle_area2(mt_corpus_find(&corpus, "smallest")) == 1);
    assert_true(mt_oracle_area2(mt_corpus_find(&corpus, "bow_tie")) == 0);
    assert_true(mt_oracle_area2(mt_corpus_find(&corpus, "backwards_square")) == -20000);
}

static void circles(void **state) {
    (void)state;
    mt_point a = {0, 0}, b = {10, 0}, c = {0, 10};
    assert_int_equal(mt_oracle_in_circle(a, b, c, (mt_point){10, 10}), 0);
    assert_int_equal(mt_oracle_in_circle(a, b, c, (mt_point){9, 9}), 1);
    assert_int_equal(mt_oracle_in_circle(a, b, c, (mt_point){11, 10}), -1);
}

static void convexity(void **state) {
    (void)state;
    const char *convex[] = {"triangle", "square", "square_with_runs", "square_with_repeats", "sliver"};
    const char *not_convex[] = {"arrow", "l_shape", "bow_tie", "pentagram", "no_area", "backwards_square"};
    for (int i = 0; i < 5; i++)
        assert_true(mt_oracle_is_convex(&mt_corpus_find(&corpus, convex[i])->rings[0]));
    for (int i = 0; i < 6; i++)
        assert_false(mt_oracle_is_convex(&mt_corpus_find(&corpus, not_convex[i])->rings[0]));
    assert_int_equal(mt_oracle_reflex_count(mt_corpus_find(&corpus, "arrow")), 1);
    assert_int_equal(mt_oracle_reflex_count(mt_corpus_find(&corpus, "plus")), 4);
    assert_int_equal(mt_oracle_reflex_count(mt_corpus_find(&corpus, "frame")), 4);
}

static void touching(void **state) {
    (void)state;
    const char *clean[] = {"square_with_repeats", "spiral", "frame", "comb_of_slivers",
                           "repeat_across_the_start"};
    const char *touches[] = {
        "touches_itself_at_a_vertex", "hole_touches_an_edge",  "slit_to_a_hole", "spike_outwards",
        "spike_on_the_edge",          "holes_touch_each_other"};
    for (int i = 0; i < 5; i++) assert_true(mt_oracle_is_clean(mt_corpus_find(&corpus, clean[i])));
    for (int i = 0; i < 6; i++) assert_false(mt_oracle_is_clean(mt_corpus_find(&corpus, touches[i])));
    assert_false(mt_oracle_is_crossing_free(mt_corpus_find(&corpus, "bow_tie")));
}

static void windings(void **state) {
    (void)state;
    const mt_rings *frame = mt_corpus_find(&corpus, "frame");
    assert_int_equal(mt_oracle_winding(frame, 2, (mt_spot){21, 21}), 1);
    assert_int_equal(mt_oracle_winding(frame, 2, (mt_spot){101, 101}), 0);
    assert_int_equal(mt_oracle_winding(mt_corpus_find(&corpus, "same_ring_twice"), 1, (mt_spot){50, 50}), 2);
    assert_int_equal(mt_oracle_winding(mt_corpus_find(&corpus, "pentagram"), 1, (mt_spot){0, 0}), -2);
}

static void hulls(void **state) {
    (void)state;
    mt_spot spots[] = {{5, 5}, {0, 0}, {10, 0}, {5, 0}, {10, 10}, {0, 10}, {0, 5}, {10, 0}}, hull[8];
    assert_int_equal(mt_oracle_hull(spots, 8, hull), 4);
    assert_true(hull[0].x == 0 && hull[0].y == 0 && hull[1].x == 10 && hull[1].y == 0 && hull[2].y == 10);
    assert_int_equal(mt_oracle_hull(spots, 1, hull), 1);
}

/* Half a square of side 100 and half a frame of side 100 with a hole of 60: no hole is left but of side
 * 10. */
static void sums(void **state) {
    (void)state;
    mt_shape frame = mt_test_shape_of(&arena, mt_corpus_find(&corpus, "frame"));
    mt_rings dot = mt_test_moved(&arena, mt_corpus_find(&corpus, "smallest"), 10, (mt_point){0, 0});
    mt_shape small = mt_test_shape_of(&arena, &dot);
    mt_weights half = {MT_WEIGHT_ONE / 2, MT_WEIGHT_ONE / 2, 0};
    assert_true(mt_sums_distance(&frame, &small, half, (mt_point){2, 2}) == 0);
    assert_true(mt_sums_distance(&frame, &small, half, (mt_point){54, 2}) == 0);
    assert_true(mt_sums_distance(&frame, &small, half, (mt_point){20, 20}) == 5);
    assert_true(fabs(mt_sums_distance(&frame, &small, half, (mt_point){-3, -4}) - 5) < 1e-9);
}

static void components_of_the_corpus(void **state) {
    (void)state;
    for (int i = 0; i < corpus.count; i++) {
        const mt_named *shape = &corpus.shapes[i];
        mt_subject subject = {shape->name, -1, {&shape->rings}};
        if (!shape->is_component) continue;
        mt_require(mt_oracle_area2(&shape->rings) > 0, &subject);
        mt_require(mt_oracle_is_crossing_free(&shape->rings), &subject);
        for (int x = -101; x < 340; x += 6)
            for (int y = -101; y < 340; y += 6) {
                int winding = mt_oracle_winding(&shape->rings, 2, (mt_spot){x, y});
                mt_require(winding == 0 || winding == 1, &subject);
            }
    }
}

static void random_polygons(void **state) {
    (void)state;
    int kinds[MT_POLYGON_KINDS] = {0};
    for (int i = 0; i < 120; i++) {
        mt_random random = mt_random_case(i);
        mt_polygon_kind kind = (mt_polygon_kind)(i % MT_POLYGON_KINDS);
        mt_component component = mt_random_polygon(&random, &arena, kind, 8 + i / 2, 1000);
        mt_subject subject = {"random_polygons", i, {&component}};
        mt_require(mt_oracle_area2(&component) > 0, &subject);
        mt_require(mt_oracle_is_crossing_free(&component), &subject);
        if (kind != MT_POLYGON_CELLS) mt_require(mt_oracle_is_clean(&component), &subject);
        kinds[kind] += kind == MT_POLYGON_CONVEX || mt_oracle_reflex_count(&component) > 0;
    }
    for (int kind = 0; kind < MT_POLYGON_KINDS; kind++) assert_true(kinds[kind] > 10);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(areas),
        cmocka_unit_test(circles),
        cmocka_unit_test(convexity),
        cmocka_unit_test(touching),
        cmocka_unit_test(windings),
        cmocka_unit_test(hulls),
        cmocka_unit_test(sums),
        cmocka_unit_test(components_of_the_corpus),
        cmocka_unit_test(random_polygons),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
