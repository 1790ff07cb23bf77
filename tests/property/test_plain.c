/* Shapes of rings that crossed: snapped and made anew, they can always be cut into convex pieces, and their ink is where it was. */
#include "geometry/decompose.h"
#include "geometry/limits.h"
#include "geometry/plain.h"
#include "geometry/snap.h"
#include "geometry/union.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/oracle.h"
#include "support/polygons.h"

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* Crossings of many edges within few grid units are rounded onto one another. */
static mt_rings crowded(int number, mt_random *random, int *extent) {
    static const int extents[] = {6, 30, 300, 10000, MT_COORD_MAX};
    *extent = extents[number % 5];
    mt_rings drawing = mt_test_rings(&arena, mt_random_between(random, 1, 3));
    for (int k = 0; k < drawing.count; k++)
        drawing.rings[k] = mt_random_scrawl(random, &arena, mt_random_between(random, 3, 40), *extent);
    return drawing;
}

/* Snapped, edges meet at points of the grid alone; each place that is a grid unit and a half away from all of them lies as deep as before. */
static void snapped(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(200); i++) {
        mt_random random = mt_random_case(i);
        int extent;
        mt_rings made, drawing = crowded(i, &random, &extent);
        mt_subject subject = {"snapped", i, {&drawing}};
        mt_require(mt_snap_rings(&drawing, &arena, &made) == MT_OK, &subject);
        mt_require(mt_oracle_is_crossing_free(&made), &subject);
        for (int k = 0; k < 60; k++) {
            mt_point p = mt_random_point(&random, -extent, extent);
            if (mt_oracle_distance(&drawing, 1, mt_spot_of(p, 1)) <= 1.5) continue;
            mt_require(mt_oracle_winding(&made, 1, mt_spot_of(p, 1)) ==
                           mt_oracle_winding(&drawing, 1, mt_spot_of(p, 1)),
                       &subject);
        }
        mt_arena_reset(&arena);
    }
}

static void check_pieces(const mt_shape *shape, const mt_subject *subject) {
    for (int k = 0; k < shape->count; k++) {
        mt_pieces pieces;
        mt_require(mt_oracle_is_crossing_free(&shape->components[k]), subject);
        mt_require(mt_decompose(&shape->components[k], &arena, &pieces) == MT_OK, subject);
    }
}

/* From the drawing's own rings, whose crossings no union has seen: where all turn one way around, ink is what they enclose. */
static void made_anew(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(200); i++) {
        mt_random random = mt_random_case(i);
        int extent;
        mt_rings drawing = crowded(i, &random, &extent);
        mt_shape plain, given = {1, &drawing};
        mt_subject subject = {"made anew", i, {&drawing}};
        mt_require(mt_shape_make_plain(&given, &arena, &plain) == MT_OK, &subject);
        mt_require(mt_shape_is_valid(&plain), &subject);
        check_pieces(&plain, &subject);
        for (int k = 0; k < 60; k++) {
            mt_spot p = mt_spot_of(mt_random_point(&random, -extent, extent), 1);
            if (mt_oracle_distance(&drawing, 1, p) <= 1.5) continue;
            mt_require(mt_oracle_in_shape(&plain, 1, p) == (mt_oracle_winding(&drawing, 1, p) > 0), &subject);
        }
        mt_arena_reset(&arena);
    }
}

/* What a union made, which may have rings that cross, and which mostly is plain and stays as it is. */
static void unions(void **state) {
    (void)state;
    int kept = 0, cases = mt_test_cases(200);
    for (int i = 0; i < cases; i++) {
        mt_random random = mt_random_case(i);
        int extent;
        mt_rings drawing = crowded(i, &random, &extent);
        mt_shape shape, plain;
        mt_subject subject = {"unions", i, {&drawing}};
        mt_require(mt_union(&drawing, MT_NONZERO, &arena, &shape) == MT_OK, &subject);
        mt_require(mt_shape_make_plain(&shape, &arena, &plain) == MT_OK, &subject);
        check_pieces(&plain, &subject);
        kept += plain.components == shape.components;
        mt_arena_reset(&arena);
    }
    assert_true(kept > cases / 2);
    assert_true(kept < cases);
}

/* Two squares that meet at a corner are two components; a hole that touches the border at a corner is a hole. */
static void corners_that_meet(void **state) {
    (void)state;
    static const int squares[][2] = {{0, 0}, {4, 0}, {4, 4}, {8, 4}, {8, 8}, {4, 8}, {4, 4}, {0, 4}};
    static const int notched[][2] = {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {2, 4}, {4, 2}};
    mt_rings rings = mt_test_rings(&arena, 2);
    mt_shape plain, given = {1, &rings};
    rings.rings[0] = mt_test_ring_of(&arena, squares, 8, 100);
    rings.rings[1] = rings.rings[0]; /* with an area that its triangles have not */
    mt_assert_ok(mt_shape_make_plain(&given, &arena, &plain));
    assert_int_equal(plain.count, 2);
    assert_int_equal(mt_shape_area2(&plain), 2 * 2 * 160000);
    rings.rings[0] = rings.rings[1] = mt_test_ring_of(&arena, notched, 7, 100);
    mt_assert_ok(mt_shape_make_plain(&given, &arena, &plain));
    assert_int_equal(plain.count, 1);
    assert_int_equal(plain.components[0].count, 2);
}

static mt_rings crossing; /* mt_test_want_of_memory gives its callback nothing */

static mt_status make_crossing_plain(void) {
    mt_arena own = {0};
    mt_shape plain, given = {1, &crossing};
    mt_status status = mt_shape_make_plain(&given, &own, &plain);
    mt_arena_release(&own);
    return status;
}

static void want_of_memory(void **state) {
    (void)state;
    mt_random random = mt_random_case(0);
    crossing = mt_test_rings(&arena, 2);
    for (int k = 0; k < 2; k++) crossing.rings[k] = mt_random_scrawl(&random, &arena, 300, 10000);
    mt_test_want_of_memory(make_crossing_plain);
}

/* Where the steps of an arena do not do, the shape is too large. */
static void bounded(void **state) {
    (void)state;
    mt_random random = mt_random_case(0);
    mt_rings drawing = mt_test_rings(&arena, 1);
    drawing.rings[0] = mt_random_scrawl(&random, &arena, 400, MT_EM);
    mt_shape plain, given = {1, &drawing};
    mt_arena own = {0};
    mt_arena_bound(&own, &(mt_allowance){60000, 1 << 24, NULL});
    mt_status status = mt_shape_make_plain(&given, &own, &plain);
    assert_int_equal(mt_arena_verdict(&own, status), MT_TOO_COSTLY);
    mt_arena_release(&own);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(snapped),           cmocka_unit_test(made_anew),      cmocka_unit_test(unions),
        cmocka_unit_test(corners_that_meet), cmocka_unit_test(want_of_memory), cmocka_unit_test(bounded),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
