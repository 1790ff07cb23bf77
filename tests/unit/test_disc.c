#include "geometry/disc.h"
#include "geometry/limits.h"
#include "support/check.h"
#include "support/polygons.h"

#include <math.h>

enum { UNIT = MT_EM / 1000 };

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static mt_rings box(int width, int height, mt_ring *ring) {
    const int points[][2] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    *ring = mt_test_ring_of(&arena, points, 4, UNIT);
    return (mt_rings){1, ring};
}

static void assert_near(double found, double expected) {
    if (fabs(found - expected * UNIT) > 0.01 * UNIT) fail_msg("%f instead of %f", found / UNIT, expected);
}

/* In a bar, a corner's disc touches three sides: its middle is half the bar's thickness from each. */
static void corners_lead_to_the_middle_line(void **state) {
    (void)state;
    mt_ring ring;
    mt_rings bar = box(500, 40, &ring);
    const int to[][2] = {{20, 20}, {480, 20}, {480, 20}, {20, 20}};
    for (int i = 0; i < 4; i++) {
        mt_vector way = mt_way_to_middle(&bar, 0, i, true);
        assert_near(ring.points[i].x + way.x, to[i][0]);
        assert_near(ring.points[i].y + way.y, to[i][1]);
    }
}

/* White around an island: the middle line is half-way between hole and island. */
static void islands_bound_white(void **state) {
    (void)state;
    const int hole[][2] = {{0, 0}, {0, 400}, {400, 400}, {400, 0}},
              island[][2] = {{60, 60}, {340, 60}, {340, 340}, {60, 340}};
    mt_ring rings[] = {mt_test_ring_of(&arena, hole, 4, UNIT), mt_test_ring_of(&arena, island, 4, UNIT)};
    mt_rings white = {2, rings};
    mt_vector way = mt_way_to_middle(&white, 0, 0, false);
    /* From (0, 0), the disc grows until the island's corner stops it: its middle is as far from there as from both sides. */
    double radius = 60 * sqrt(2) / (1 + sqrt(2));
    assert_near(way.x, radius);
    assert_near(way.y, radius);
    way = mt_way_to_middle(&white, 1, 0, false);
    assert_true(way.x < 0 && way.y < 0);
}

static void the_largest_disc_is_found(void **state) {
    (void)state;
    mt_ring ring;
    mt_rings bar = box(500, 40, &ring);
    assert_near(mt_largest_disc(&bar, 0), 20);
    assert_near(mt_largest_disc(&bar, 30 * UNIT), 30);
    /* Two bars that cross have more ink in the middle: a disc there touches four corners. */
    const int cross[][2] = {{200, 0},   {240, 0},   {240, 200}, {440, 200}, {440, 240}, {240, 240},
                            {240, 440}, {200, 440}, {200, 240}, {0, 240},   {0, 200},   {200, 200}};
    ring = mt_test_ring_of(&arena, cross, 12, UNIT);
    assert_near(mt_largest_disc(&(mt_rings){1, &ring}, 0), 20 * sqrt(2));
}

static void nothing_has_no_disc(void **state) {
    (void)state;
    assert_true(mt_largest_disc(&(mt_rings){0}, 0) == 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(corners_lead_to_the_middle_line),
        cmocka_unit_test(islands_bound_white),
        cmocka_unit_test(the_largest_disc_is_found),
        cmocka_unit_test(nothing_has_no_disc),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
