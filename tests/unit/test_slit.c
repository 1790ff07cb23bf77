#include "geometry/limits.h"
#include "morph/divide/boundary_graph.h"
#include "morph/divide/cut.h"
#include "morph/divide/slit.h"
#include "support/check.h"
#include "support/oracle.h"
#include "support/polygons.h"

#include <math.h>

enum { UNIT = MT_EM / 1000, CHORD = MT_EM / 2000 };

static mt_arena arena;
static const mt_settings settings = {.flatness = CHORD, .align = {3, 4, 1}, .step = 12, .jumps = true};

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* ---- an O and a C ---------------------------------------------------------------------------------------- */

/* Turned by a quarter to the left, about the middle of 600 × 600, so many times. */
static mt_ring turned(mt_ring ring, int quarters) {
    for (int k = 0; k < quarters; k++)
        for (int i = 0; i < ring.count; i++)
            ring.points[i] = (mt_point){600 * UNIT - ring.points[i].y, ring.points[i].x};
    return ring;
}

/* A square O, 600/1000 em wide, its strokes 100. */
static mt_component an_o(void) {
    static const int outer[][2] = {{0, 0}, {600, 0}, {600, 600}, {0, 600}},
                     hole[][2] = {{100, 100}, {100, 500}, {500, 500}, {500, 100}};
    mt_component component = mt_test_rings(&arena, 2);
    component.rings[0] = mt_test_ring_of(&arena, outer, 4, UNIT);
    component.rings[1] = mt_test_ring_of(&arena, hole, 4, UNIT);
    return component;
}

/* The same open at the right by a gap of 30, turned. */
static mt_ring a_c(int quarters) {
    static const int points[][2] = {{0, 0},     {600, 0},   {600, 285}, {500, 285}, {500, 100}, {100, 100},
                                    {100, 500}, {500, 500}, {500, 315}, {600, 315}, {600, 600}, {0, 600}};
    return turned(mt_test_ring_of(&arena, points, 12, UNIT), quarters);
}

static mt_status slit(const mt_component *component, const mt_ring **counterpart, mt_component *opened,
                      bool *done) {
    mt_box box = {{0, 0}, {600 * UNIT, 600 * UNIT}};
    mt_slit_case in = {component, mt_frame_of_box(box), counterpart, mt_frame_of_box(box)};
    return mt_slit(&in, 1, &settings, &arena, opened, done);
}

/* The middle of the slit: the points that a ring has twice. */
static mt_point slit_place(const mt_ring *ring) {
    int64_t x = 0, y = 0, count = 0;
    for (int i = 0; i < ring->count; i++)
        for (int k = 0; k < i; k++) {
            if (!mt_point_equal(ring->points[i], ring->points[k])) continue;
            assert_true(ring->marks[i] & ring->marks[k] & MT_CORNER);
            x += ring->points[i].x;
            y += ring->points[i].y;
            count++;
        }
    assert_int_equal(count, 2);
    return (mt_point){(int32_t)(x / 2), (int32_t)(y / 2)};
}

/* The O is slit where the C is open, whichever side that is, and has the same ink. */
static void an_o_opens_where_a_c_is_open(void **state) {
    (void)state;
    for (int quarters = 0; quarters < 4; quarters++) {
        mt_component o = an_o(), opened;
        mt_ring c = a_c(quarters), gap = mt_test_ring(&arena, 1);
        gap.points[0] = (mt_point){550 * UNIT, 300 * UNIT};
        mt_point expected = turned(gap, quarters).points[0];
        const mt_ring *counterpart[] = {&c, NULL};
        bool done = false;
        mt_assert_ok(slit(&o, counterpart, &opened, &done));
        assert_true(done);
        assert_int_equal(opened.count, 1);
        assert_true(mt_oracle_area2(&opened) == mt_oracle_area2(&o));
        mt_point place = slit_place(&opened.rings[0]);
        assert_true(sqrt((double)mt_distance2(place, expected)) < 80 * UNIT);
    }
}

/* An O whose stroke is thinnest on the side where the C is open. */
static void a_thin_side_opens(void **state) {
    (void)state;
    for (int quarters = 0; quarters < 4; quarters++) {
        mt_component o = an_o(), opened;
        for (int i = 2; i < 4; i++) o.rings[1].points[i].x += 40 * UNIT;
        for (int r = 0; r < 2; r++) o.rings[r] = turned(o.rings[r], quarters);
        mt_ring c = a_c(quarters), gap = mt_test_ring(&arena, 1);
        gap.points[0] = (mt_point){570 * UNIT, 300 * UNIT};
        const mt_ring *counterpart[] = {&c, NULL};
        bool done = false;
        mt_assert_ok(slit(&o, counterpart, &opened, &done));
        assert_true(done);
        assert_int_equal(opened.count, 1);
        assert_true(mt_oracle_area2(&opened) == mt_oracle_area2(&o));
        mt_point place = slit_place(&opened.rings[0]), expected = turned(gap, quarters).points[0];
        assert_true(sqrt((double)mt_distance2(place, expected)) < 150 * UNIT);
    }
}

/* Not where the other side is the same O without its hole: what comes of a slit would go with that worse than before. */
static void an_o_stays_closed_beside_a_block(void **state) {
    (void)state;
    mt_component o = an_o(), opened;
    const mt_ring *counterpart[] = {&o.rings[0], NULL};
    bool done = true;
    mt_assert_ok(slit(&o, counterpart, &opened, &done));
    assert_false(done);
}

/* Nor into a ring that has no counterpart. */
static void only_into_rings_with_a_counterpart(void **state) {
    (void)state;
    mt_component o = an_o(), opened;
    const mt_ring *counterpart[] = {NULL, NULL};
    bool done = true;
    mt_assert_ok(slit(&o, counterpart, &opened, &done));
    assert_false(done);
}

/* Nor through ink too wide: more than 300/1000 em. */
static void not_through_wide_ink(void **state) {
    (void)state;
    static const int outer[][2] = {{0, 0}, {700, 0}, {700, 700}, {0, 700}},
                     hole[][2] = {{340, 340}, {340, 360}, {360, 360}, {360, 340}},
                     c[][2] = {{0, 0},     {700, 0},   {700, 345}, {360, 345}, {360, 340}, {340, 340},
                               {340, 360}, {360, 360}, {360, 355}, {700, 355}, {700, 700}, {0, 700}};
    mt_component component = mt_test_rings(&arena, 2), opened;
    component.rings[0] = mt_test_ring_of(&arena, outer, 4, UNIT);
    component.rings[1] = mt_test_ring_of(&arena, hole, 4, UNIT);
    mt_ring open = mt_test_ring_of(&arena, c, 12, UNIT);
    mt_box box = {{0, 0}, {700 * UNIT, 700 * UNIT}};
    const mt_ring *counterpart[] = {&open, NULL};
    mt_slit_case in = {&component, mt_frame_of_box(box), counterpart, mt_frame_of_box(box)};
    bool done = true;
    mt_assert_ok(mt_slit(&in, 1, &settings, &arena, &opened, &done));
    assert_false(done);
}

/* A hole may open into another hole: 8 against a 0 that has its two holes in one. */
static void a_hole_opens_into_a_hole(void **state) {
    (void)state;
    static const int outer[][2] = {{0, 0}, {600, 0}, {600, 600}, {0, 600}},
                     low[][2] = {{100, 100}, {100, 270}, {500, 270}, {500, 100}},
                     high[][2] = {{100, 330}, {100, 500}, {500, 500}, {500, 330}};
    mt_component eight = mt_test_rings(&arena, 3), opened;
    eight.rings[0] = mt_test_ring_of(&arena, outer, 4, UNIT);
    eight.rings[1] = mt_test_ring_of(&arena, high, 4, UNIT);
    eight.rings[2] = mt_test_ring_of(&arena, low, 4, UNIT);
    static const int both[][2] = {{100, 100}, {100, 270}, {290, 270}, {290, 330}, {100, 330}, {100, 500},
                                  {500, 500}, {500, 330}, {310, 330}, {310, 270}, {500, 270}, {500, 100}};
    mt_ring joined = mt_test_ring_of(&arena, both, 12, UNIT);
    const mt_ring *counterpart[] = {NULL, NULL, &joined};
    bool done = false;
    mt_assert_ok(slit(&eight, counterpart, &opened, &done));
    assert_true(done);
    assert_int_equal(opened.count, 2);
    assert_true(mt_oracle_area2(&opened) == mt_oracle_area2(&eight));
    assert_int_equal(opened.rings[0].count, 4);
    mt_point place = slit_place(&opened.rings[1]);
    assert_true(place.y == 300 * UNIT && abs(place.x - 300 * UNIT) < 100 * UNIT);
}

/* ---- what is slit can be cut again ------------------------------------------------------------------------- */

/* A square with a triangle for a hole, slit from the hole to a corner: one ring. */
static mt_component slit_open(mt_random *random) {
    static const int outer[][2] = {{0, 0}, {700, 0}, {700, 700}, {0, 700}};
    mt_component closed = mt_test_rings(&arena, 2), opened = mt_test_rings(&arena, 1);
    closed.rings[0] = mt_test_ring_of(&arena, outer, 4, UNIT);
    mt_ring hole = mt_test_ring(&arena, 3);
    hole.points[0] = mt_random_point(random, 20000, 90000);
    hole.points[1] = (mt_point){hole.points[0].x + 10000, hole.points[0].y + 50000};
    hole.points[2] = (mt_point){hole.points[0].x + 50000, hole.points[0].y + 10000};
    opened.rings[0] = mt_test_ring(&arena, 9);
    for (int i = 0; i < 9; i++) /* 0, 1, 2, 3, 0, and around the hole from where it is nearest */
        opened.rings[0].points[i] = i < 5 ? closed.rings[0].points[i % 4] : hole.points[(i - 5) % 3];
    return opened;
}

/* Both sides of a slit have their samples at the same places: put together again without a cut, the boundary is the component that it
 * was made of, and nothing lies between the two sides. */
static void both_sides_of_a_slit_are_alike(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(50); n++) {
        mt_random random = mt_random_case(n);
        mt_component component = slit_open(&random);
        mt_subject subject = {"both_sides_of_a_slit_are_alike", n, {&component}};
        mt_shape whole = mt_test_shape_of(&arena, &component), shares;
        mt_boundary boundary;
        mt_frame frame = mt_frame_of_box(mt_shape_box(&whole));
        mt_require(mt_boundary_of(&whole, &frame, &settings, 300 * UNIT, &arena, &boundary) == MT_OK,
                   &subject);
        size_t triangles = (size_t)boundary.meshes[0].triangle_count;
        bool *cut = mt_arena_new(&arena, 3 * triangles, sizeof *cut);
        int *share_of = mt_arena_new(&arena, triangles, sizeof *share_of);
        mt_cut_plan uncut = {&boundary.meshes[0], boundary.drawn[0], cut};
        mt_assert_ok(mt_cut(&uncut, &arena, &shares, share_of));
        mt_require(shares.count == 1 && shares.components[0].count == 1, &subject);
        mt_require(shares.components[0].rings[0].count == 9, &subject);
        mt_require(mt_oracle_shape_area2(&shares) == mt_oracle_area2(&component), &subject);
        mt_arena_reset(&arena);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_o_opens_where_a_c_is_open),
        cmocka_unit_test(a_thin_side_opens),
        cmocka_unit_test(an_o_stays_closed_beside_a_block),
        cmocka_unit_test(only_into_rings_with_a_counterpart),
        cmocka_unit_test(not_through_wide_ink),
        cmocka_unit_test(a_hole_opens_into_a_hole),
        cmocka_unit_test(both_sides_of_a_slit_are_alike),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
