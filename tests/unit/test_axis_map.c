/* Maps of the axis: what is taken, and where they lead. */
#include "sfnt/axis_map.h"

#include <math.h>

#include "sfnt/axis.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/random.h"

enum { POINTS_MAX = 8 };

typedef struct row {
    int count;
    double values[POINTS_MAX], places[POINTS_MAX];
} row;

static mt_axis_map map_of(const row *r) {
    mt_axis_map map;
    mt_assert_ok(mt_axis_map_make(r->values, r->places, r->count, &map));
    return map;
}

static void ends_go_without_saying(void **state) {
    (void)state;
    static const row rows[] = {
        {1, {25}, {10}}, {2, {0, 25}, {0, 10}}, {2, {25, 100}, {10, 100}}, {3, {0, 25, 100}, {0, 10, 100}}};
    for (int i = 0; i < 4; i++) {
        mt_axis_map map = map_of(&rows[i]);
        assert_int_equal(map.count, 3);
        assert_true(map.points[0].value == 0 && map.points[0].place == 0);
        assert_true(map.points[1].value == 25 && map.points[1].place == 10);
        assert_true(map.points[2].value == 100 && map.points[2].place == 100);
        mt_axis_map_free(&map);
    }
}

static void what_is_no_map_is_refused(void **state) {
    (void)state;
    static const row rows[] = {
        {1, {0}, {5}},
        {1, {100}, {95}},
        {1, {25}, {101}},
        {1, {25}, {-1}},
        {1, {-1}, {0}},
        {1, {101}, {100}},
        {1, {NAN}, {10}},
        {1, {10}, {NAN}},
        {1, {-INFINITY}, {10}},
        {1, {INFINITY}, {10}},
        {2, {50, 25}, {40, 50}},
        {2, {25, 25}, {10, 40}},
        {2, {25, 50}, {40, 10}},
        {2, {50, 50.002}, {40, 50}}, /* one place of the tables */
        {1, {99.998}, {50}},         /* the end's */
        {1, {0.002}, {50}},
        {2, {0, 0}, {0, 0}},
        {2, {100, 100}, {100, 100}},
        {-1, {0}, {0}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        mt_axis_map map = {7, NULL};
        assert_int_equal(mt_axis_map_make(rows[i].values, rows[i].places, rows[i].count, &map),
                         MT_BAD_PARAMETER);
        assert_int_equal(map.count, 7);
    }
}

static void leads_along_straight_lines(void **state) {
    (void)state;
    const row r = {3, {25, 50, 75}, {10, 40, 40}};
    mt_axis_map map = map_of(&r), none = {0};
    static const double rows[][2] = {{0, 0},   {5, 2},   {25, 10},   {37.5, 25}, {50, 40},
                                     {60, 40}, {75, 40}, {87.5, 70}, {100, 100}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double value = rows[i][0], place = rows[i][1];
        bool flat = value > 50 && value <= 75;
        assert_true(fabs(mt_axis_map_place(&map, value) - place) < 1e-12);
        assert_true(mt_axis_map_place(&none, value) == value);
        double back = mt_axis_map_value(&map, mt_axis_place(place));
        assert_true(fabs(back - (flat ? 50 : value)) < 3 * mt_axis_value(1));
    }
    mt_axis_map_free(&map);
}

/* Where the tables lead to, places both, by who does not round on the way. */
static double led_to(const mt_axis_map *map, double at) {
    int i = 1;
    while (i + 1 < map->count && mt_axis_place(map->points[i].value) < at) i++;
    mt_map_point p = map->points[i - 1], q = map->points[i];
    double from = mt_axis_place(p.value), to = mt_axis_place(p.place);
    return to + (at - from) / (mt_axis_place(q.value) - from) * (mt_axis_place(q.place) - to);
}

/* At most a hundredth apart, or far. */
static row random_row(mt_random *random) {
    row r = {0};
    int value = 0, place = 0; /* hundredths */
    for (;;) {
        value += mt_random_between(random, 1, mt_random_one_in(random, 2) ? 3 : 2500);
        place = mt_random_between(random, place, mt_random_one_in(random, 4) ? place : 10000);
        if (value >= 10000 || r.count == POINTS_MAX) return r;
        r.values[r.count] = value / 100.0;
        r.places[r.count++] = place / 100.0;
    }
}

/* Random maps are taken; what is to be set for a place is not past it, and the next place of the axis is. */
static void random_maps(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(200); n++) {
        mt_random random = mt_random_case(n);
        const row r = random_row(&random);
        mt_axis_map map = map_of(&r);
        for (int i = 1; i < map.count; i++)
            assert_true(mt_axis_place(map.points[i].value) > mt_axis_place(map.points[i - 1].value));
        for (int i = 0; i < 100; i++) {
            int place = mt_random_between(&random, 1, MT_PLACE_ONE);
            double value = mt_axis_map_value(&map, place), at = value / MT_AXIS_END * MT_PLACE_ONE;
            assert_true(value >= 0 && value <= MT_AXIS_END);
            assert_true(led_to(&map, at) <= place + 1e-6);
            assert_true(led_to(&map, fmin(floor(at + 1e-6) + 1, MT_PLACE_ONE)) >= place - 1e-6);
        }
        mt_axis_map_free(&map);
    }
}

static void survives_want_of_memory(void **state) {
    (void)state;
    const double value = 25, place = 10;
    mt_axis_map map;
    mt_allocation_watch();
    mt_allocation_fail(0, true);
    assert_int_equal(mt_axis_map_make(&value, &place, 1, &map), MT_NO_MEMORY);
    mt_allocation_succeed();
    assert_int_equal(mt_allocation_live(), 0);
    mt_allocation_unwatch();
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ends_go_without_saying),     cmocka_unit_test(what_is_no_map_is_refused),
        cmocka_unit_test(leads_along_straight_lines), cmocka_unit_test(random_maps),
        cmocka_unit_test(survives_want_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
