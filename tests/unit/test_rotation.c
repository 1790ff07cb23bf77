#include "morph/paper/rotation.h"
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

static void quarter_turns_are_exact(void **state) {
    (void)state;
    mt_point p = {1234567, -765}, centre = {100, 200};
    mt_point quarter = {100 - (-765 - 200), 200 + (1234567 - 100)}, half = {200 - 1234567, 400 + 765};
    assert_true(mt_point_equal(mt_turn(p, centre, 0), p));
    assert_true(mt_point_equal(mt_turn(p, centre, 90), quarter));
    assert_true(mt_point_equal(mt_turn(p, centre, 180), half));
    assert_true(mt_point_equal(mt_turn(p, centre, -270), quarter));
    assert_true(mt_point_equal(mt_turn(p, centre, 360), p));
    assert_true(mt_point_equal(mt_turn(p, centre, -360), p));
}

static void by_the_textbook(void **state) {
    (void)state;
    mt_random random = mt_random_case(0);
    for (int i = 0; i < mt_test_cases(1000); i++) {
        mt_point p = mt_random_point(&random, -500000, 500000);
        mt_point centre = mt_random_point(&random, -500000, 500000);
        double degrees = 720 * mt_random_unit(&random) - 360, q = degrees * M_PI / 180;
        double x = (double)p.x - centre.x, y = (double)p.y - centre.y;
        mt_point turned = mt_turn(p, centre, degrees);
        assert_true(fabs(turned.x - (centre.x + x * cos(q) - y * sin(q))) <= 0.501);
        assert_true(fabs(turned.y - (centre.y + x * sin(q) + y * cos(q))) <= 0.501);
    }
}

static void middles(void **state) {
    (void)state;
    mt_point middle = mt_box_middle((mt_box){{-10, 20}, {30, 50}});
    assert_true(middle.x == 10 && middle.y == 35);
    const int32_t most = (1 << 23) - 1;
    middle = mt_box_middle((mt_box){{-most, -most}, {most, most}});
    assert_true(middle.x == 0 && middle.y == 0);
}

static void shapes_turn_as_they_are(void **state) {
    (void)state;
    mt_component frame = mt_test_moved(&arena, mt_corpus_find(&corpus, "frame"), 1000, (mt_point){0, 0});
    frame.rings[1].marks[2] = MT_CHORD;
    mt_shape shape = mt_test_shape_of(&arena, &frame), turned;
    mt_assert_ok(mt_shape_turn(&shape, (mt_point){5, 5}, 33, &arena, &turned));
    assert_int_equal(turned.components[0].count, 2);
    assert_int_equal(turned.components[0].rings[1].marks[2], MT_CHORD);
    double area = (double)mt_oracle_shape_area2(&turned) / (double)mt_oracle_shape_area2(&shape);
    assert_true(fabs(area - 1) < 1e-4);
    assert_int_equal(frame.rings[0].points[0].x, 0);
}

static mt_shape bar(int width, int height, double degrees) {
    mt_component component = mt_test_rings(&arena, 1);
    component.rings[0] = mt_test_ring(&arena, 4);
    mt_point corners[] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    for (int i = 0; i < 4; i++) component.rings[0].points[i] = corners[i];
    mt_shape shape = mt_test_shape_of(&arena, &component), turned;
    mt_assert_ok(mt_shape_turn(&shape, (mt_point){width / 2, height / 2}, degrees, &arena, &turned));
    return turned;
}

static double found(mt_shape a, mt_shape b) {
    mt_link match = {0, 0};
    mt_links matches = {1, &match};
    return mt_find_rotation(&a, &b, &matches);
}

/* The angle between two bars, with their axes taken without direction: -90 … 90. */
static void finds_the_angle_of_bars(void **state) {
    (void)state;
    for (int q = -80; q <= 80; q += 10) {
        assert_true(fabs(found(bar(100000, 10000, 0), bar(100000, 10000, q)) - q) < 0.01);
        assert_true(fabs(found(bar(100000, 10000, 20), bar(200000, 50000, 20 + q)) - q) < 0.01);
    }
    assert_true(fabs(found(bar(100000, 10000, 0), bar(100000, 10000, 150)) + 30) < 0.01);
}

static void round_things_have_no_say(void **state) {
    (void)state;
    assert_true(found(bar(100000, 100000, 0), bar(100000, 100000, 0)) == 0);
    mt_shape a = {2, mt_arena_new(&arena, 2, sizeof(mt_component))},
             b = {2, mt_arena_new(&arena, 2, sizeof(mt_component))};
    a.components[0] = bar(100000, 10000, 0).components[0];
    b.components[0] = bar(100000, 10000, 25).components[0];
    a.components[1] = bar(90000, 90000, 0).components[0];
    b.components[1] = bar(90000, 90000, 40).components[0];
    mt_link pairs[] = {{0, 0}, {1, 1}};
    mt_links matches = {2, pairs}, none = {0, NULL};
    assert_true(fabs(mt_find_rotation(&a, &b, &matches) - 25) < 0.01);
    assert_true(mt_find_rotation(&a, &b, &none) == 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quarter_turns_are_exact),
        cmocka_unit_test(by_the_textbook),
        cmocka_unit_test(middles),
        cmocka_unit_test(shapes_turn_as_they_are),
        cmocka_unit_test(finds_the_angle_of_bars),
        cmocka_unit_test(round_things_have_no_say),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
