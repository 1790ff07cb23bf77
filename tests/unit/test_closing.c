#include "geometry/enclosed.h"
#include "geometry/limits.h"
#include "geometry/white.h"
#include "morph/join/closing.h"
#include "morph/join/spine.h"
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

/* An O with an inline, wide, and a narrow one half as large: the counters go together, and the inline is left. */
static void inlines_are_filled_and_counters_are_not(void **state) {
    (void)state;
    mt_ring outer[] = {box(0, 0, 600, 700, false), box(80, 80, 440, 540, true)},
            inner[] = {box(110, 110, 380, 480, false), box(200, 200, 200, 300, true)},
            plain[] = {box(50, 0, 300, 350, false), box(100, 50, 200, 250, true)};
    mt_component inlined[] = {{2, outer}, {2, inner}}, solid = {2, plain};
    mt_shape a = {2, inlined}, b = {1, &solid};
    mt_white white[2];
    mt_assert_ok(mt_find_white(&a, &b, &arena, white));
    assert_true(white[0].count == 1 && white[0].ring_count == 2 && white[1].count == 0);
    assert_int_equal(white[0].filled.count, 1);
    assert_int_equal(white[0].filled.components[0].count, 2);
    assert_true(mt_shape_area2(&white[0].filled) == 2 * (int64_t)(600 * 700 - 200 * 300) * UNIT * UNIT);
    mt_assert_ok(mt_find_white(&b, &a, &arena, white));
    assert_true(white[0].count == 0 && white[1].count == 1);
    mt_assert_ok(mt_find_white(&a, &a, &arena, white));
    assert_true(white[0].count == 0 && white[1].count == 0);
}

/* Counters in other places have none of each other. */
static void counters_apart_have_no_counterpart(void **state) {
    (void)state;
    mt_ring left[] = {box(0, 0, 600, 600, false), box(50, 50, 200, 200, true)},
            right[] = {box(0, 0, 600, 600, false), box(180, 180, 200, 200, true)};
    mt_component one = {2, left}, two = {2, right};
    mt_white white[2];
    mt_assert_ok(mt_find_white(&(mt_shape){1, &one}, &(mt_shape){1, &two}, &arena, white));
    assert_true(white[0].count == 1 && white[1].count == 1);
    assert_true(mt_shape_area2(&white[1].filled) == 2 * (int64_t)600 * 600 * UNIT * UNIT);
}

/* A cross of white in a square of ink closes as a line along both arms, which the other square's ink moves with it. */
static void branched_white_closes_on_its_spine(void **state) {
    (void)state;
    const int cross[][2] = {{250, 100}, {250, 250}, {100, 250}, {100, 350}, {250, 350}, {250, 500},
                            {350, 500}, {350, 350}, {500, 350}, {500, 250}, {350, 250}, {350, 100}};
    mt_ring white = mt_test_ring_of(&arena, cross, 12, UNIT), around = box(0, 0, 600, 600, false);
    for (int i = 0; i < white.count; i++) white.marks[i] = MT_CORNER | MT_LINE;
    mt_params params = mt_params_default();
    mt_closing closing = {true, moving(&around, 30, 70), NULL, &params};
    mt_contour_pair made[1];
    int count = 0;
    bool far_left = false, far_up = false;
    mt_assert_ok(mt_close_region(&(mt_rings){1, &white}, &closing, &arena, made, &count));
    assert_int_equal(count, 1);
    for (int i = 0; i < made[0].b.count; i++) {
        mt_point end = made[0].b.segments[i].end;
        assert_true(abs(end.x - 330 * UNIT) <= 25 * UNIT || abs(end.y - 370 * UNIT) <= 25 * UNIT);
        far_left |= end.x < 200 * UNIT;
        far_up |= end.y > 500 * UNIT;
    }
    assert_true(far_left && far_up);
}

/* ---- spines ------------------------------------------------------------------------------------------------- */

static mt_outline lines_of(const mt_component *component, bool left) {
    mt_outline outline = {component->count,
                          mt_arena_new(&arena, (size_t)component->count, sizeof(mt_contour))};
    for (int r = 0; r < component->count; r++) {
        const mt_ring *ring = &component->rings[r];
        mt_contour *contour = &outline.contours[r];
        *contour = (mt_contour){ring->count, mt_arena_new(&arena, (size_t)ring->count, sizeof(mt_segment))};
        for (int i = 0; i < ring->count; i++)
            contour->segments[i] =
                (mt_segment){.degree = 1, .end = ring->points[left ? i : ring->count - 1 - i]};
    }
    return outline;
}

static mt_rings nodes_of(const mt_outline *outline) {
    mt_rings rings = mt_test_rings(&arena, outline->count);
    for (int r = 0; r < outline->count; r++) {
        rings.rings[r] = mt_test_ring(&arena, outline->contours[r].count);
        for (int i = 0; i < outline->contours[r].count; i++)
            rings.rings[r].points[i] = outline->contours[r].segments[i].end;
    }
    return rings;
}

/* Open, the contours are the region's own, with nodes on one another; shut, they enclose nothing. */
static void spines_enclose_nothing(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(200); n++) {
        mt_random random = mt_random_case(n);
        mt_arena_place before = mt_arena_mark(&arena);
        mt_polygon_kind kind = (mt_polygon_kind)(n % MT_POLYGON_CELLS);
        mt_component region = mt_random_polygon(&random, &arena, kind, 40, MT_EM / 2);
        mt_outline drawn = lines_of(&region, n & 1), open, shut;
        double area;
        mt_assert_ok(mt_spine_of(&drawn, n & 1, &arena, &open, &shut));
        mt_rings closed = nodes_of(&shut);
        mt_assert_ok(mt_enclosed_area(&closed, &arena, &area));
        assert_true(area < 1); /* the measure is rounded */
        for (int r = 0; r < drawn.count; r++) {
            int k = 0;
            assert_int_equal(open.contours[r].count, shut.contours[r].count);
            for (int i = 0; i < open.contours[r].count; i++) {
                if (!mt_point_equal(open.contours[r].segments[i].end, drawn.contours[r].segments[k].end)) k++;
                assert_true(
                    mt_point_equal(open.contours[r].segments[i].end, drawn.contours[r].segments[k].end));
            }
            assert_int_equal(k, drawn.contours[r].count - 1);
        }
        mt_arena_rewind(&arena, before);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bar_ends_on_its_middle_line),
        cmocka_unit_test(white_ends_in_the_ink),
        cmocka_unit_test(inlines_are_filled_and_counters_are_not),
        cmocka_unit_test(counters_apart_have_no_counterpart),
        cmocka_unit_test(branched_white_closes_on_its_spine),
        cmocka_unit_test(spines_enclose_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
