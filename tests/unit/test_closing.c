#include "geometry/limits.h"
#include "geometry/white.h"
#include "morph/join/closing.h"
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

static mt_ring box(int left, int bottom, int width, int height, bool hole) {
    const int points[][2] = {{left, bottom},
                             {hole ? left : left + width, hole ? bottom + height : bottom},
                             {left + width, bottom + height},
                             {hole ? left + width : left, hole ? bottom : bottom + height}};
    mt_ring ring = mt_test_ring_of(&arena, points, 4, UNIT);
    for (int i = 0; i < 4; i++) ring.marks[i] = MT_CORNER | MT_LINE;
    return ring;
}

/* Contours that move by a vector. */
static mt_carrier moving(const mt_ring *ring, int x, int y) {
    mt_contour_pair pair;
    for (int s = 0; s < 2; s++) {
        mt_contour contour = {ring->count, mt_arena_new(&arena, (size_t)ring->count, sizeof(mt_segment))};
        for (int i = 0; i < ring->count; i++)
            contour.segments[i] = (mt_segment){
                .degree = 1, .end = {ring->points[i].x + s * x * UNIT, ring->points[i].y + s * y * UNIT}};
        *(s ? &pair.b : &pair.a) = contour;
    }
    mt_carrier carrier;
    mt_box any = mt_ring_box(ring);
    mt_assert_ok(mt_carrier_of(&pair, 1, true, any, any, &arena, &carrier));
    return carrier;
}

static bool is_near(mt_point p, int x, int y) {
    return abs(p.x - x * UNIT) <= 2 && abs(p.y - y * UNIT) <= 2;
}

/* A bar of ink that only A has ends as the line along its middle, where the contours around it have moved. */
static void a_bar_ends_on_its_middle_line(void **state) {
    (void)state;
    mt_ring bar = box(0, 0, 500, 40, false), around = box(-200, -200, 900, 440, false);
    mt_params params = mt_params_default();
    mt_closing closing = {true, moving(&around, 30, 70), NULL, &params};
    mt_contour_pair made[1];
    int count = 0;
    mt_assert_ok(mt_close_region(&(mt_rings){1, &bar}, &closing, &arena, made, &count));
    assert_int_equal(count, 1);
    int corners = 0;
    for (int i = 0; i < made[0].b.count; i++) {
        mt_point open = made[0].a.segments[i].end, shut = made[0].b.segments[i].end;
        bool corner = (open.x == 0 || open.x == 500 * UNIT) && (open.y == 0 || open.y == 40 * UNIT);
        corners += corner;
        assert_true(abs(shut.y - 90 * UNIT) <= 2);
        assert_true(!corner || is_near(shut, 30 + (open.x == 0 ? 20 : 480), 90));
    }
    assert_int_equal(corners, 4);
}

/* White that would end beside the ink ends on its border. */
static void white_ends_in_the_ink(void **state) {
    (void)state;
    mt_ring slit = box(0, 0, 500, 40, true), around = box(-200, -200, 900, 440, false),
            ink = box(100, 0, 300, 200, false);
    mt_component component = {1, &ink};
    mt_shape other = {1, &component};
    mt_params params = mt_params_default();
    mt_closing closing = {true, moving(&around, 0, 0), &other, &params};
    mt_contour_pair made[1];
    int count = 0;
    mt_assert_ok(mt_close_region(&(mt_rings){1, &slit}, &closing, &arena, made, &count));
    for (int i = 0; i < made[0].b.count; i++) {
        mt_point end = made[0].b.segments[i].end;
        assert_true(abs(end.y - 20 * UNIT) <= 2 && end.x >= 100 * UNIT - 2 && end.x <= 400 * UNIT + 2);
    }
}

/* An O with an inline: three holes and an island against one hole. The inline is narrow and filled, the counter is not. */
static void inlines_are_filled_and_counters_are_not(void **state) {
    (void)state;
    mt_ring outer[] = {box(0, 0, 600, 700, false), box(80, 80, 440, 540, true)},
            inner[] = {box(110, 110, 380, 480, false), box(200, 200, 200, 300, true)},
            plain[] = {box(0, 0, 600, 700, false), box(200, 200, 200, 300, true)};
    mt_component inlined[] = {{2, outer}, {2, inner}}, solid = {2, plain};
    mt_shape a = {2, inlined}, b = {1, &solid};
    mt_white white;
    mt_assert_ok(mt_find_white(&a, &b, &arena, &white));
    assert_true(white.in_a && white.count == 1 && white.ring_count == 2);
    assert_int_equal(white.filled.count, 1);
    assert_int_equal(white.filled.components[0].count, 2);
    assert_int_equal(mt_shape_area2(&white.filled), mt_shape_area2(&b));
    mt_assert_ok(mt_find_white(&b, &a, &arena, &white));
    assert_true(!white.in_a && white.count == 1);
    mt_assert_ok(mt_find_white(&b, &b, &arena, &white));
    assert_int_equal(white.count, 0);
}

/* A wide counter that only one side has is no inline. */
static void wide_white_stays(void **state) {
    (void)state;
    mt_ring open[] = {box(0, 0, 600, 700, false)},
            closed[] = {box(0, 0, 600, 700, false), box(150, 150, 300, 400, true)};
    mt_component one = {1, open}, two = {2, closed};
    mt_white white;
    mt_assert_ok(mt_find_white(&(mt_shape){1, &two}, &(mt_shape){1, &one}, &arena, &white));
    assert_int_equal(white.count, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bar_ends_on_its_middle_line),
        cmocka_unit_test(white_ends_in_the_ink),
        cmocka_unit_test(inlines_are_filled_and_counters_are_not),
        cmocka_unit_test(wide_white_stays),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
