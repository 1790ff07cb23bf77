/* The union against a raster count of pixel centres, and against exact areas where all crossings fall on
 * the grid. */
#include "geometry/union.h"
#include "geometry/limits.h"
#include "support/check.h"
#include "support/oracle.h"
#include "support/polygons.h"

#include <math.h>

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* A crossing is rounded to the grid, by half a unit on each axis; an edge through several of them is bent
 * at each, and stays within √½ of where it was. So a pixel centre farther than one unit from all drawn
 * edges is inside or outside for certain. */
static void check_raster(const mt_rings *drawing, const mt_shape *shape, int extent,
                         const mt_subject *subject) {
    enum { SIDE = 32 };
    int outside = 0;
    for (int i = 0; i < SIDE; i++)
        for (int k = 0; k < SIDE; k++) {
            int64_t step = 4 * (int64_t)extent / SIDE;
            mt_spot spot = {(-2 * (int64_t)extent + i * step) | 1, (-2 * (int64_t)extent + k * step) | 1};
            if (mt_oracle_distance(drawing, 2, spot) <= 1) continue;
            bool ink = mt_oracle_winding(drawing, 2, spot) != 0;
            mt_require(mt_oracle_in_shape(shape, 2, spot) == ink, subject);
            outside += !ink;
        }
    mt_require(outside > 0, subject);
}

static void scrawls(void **state) {
    (void)state;
    static const int extents[] = {300, 10000, MT_EM, MT_COORD_MAX};
    for (int i = 0; i < mt_test_cases(120); i++) {
        mt_random random = mt_random_case(i);
        int extent = extents[i % 4], count = mt_random_between(&random, 1, 3);
        mt_rings drawing = mt_test_rings(&arena, count);
        for (int k = 0; k < count; k++)
            drawing.rings[k] = mt_random_scrawl(&random, &arena, mt_random_between(&random, 3, 24), extent);
        mt_subject subject = {"scrawls", i, {&drawing}};
        mt_shape shape;
        mt_require(mt_union(&drawing, MT_NONZERO, &arena, &shape) == MT_OK, &subject);
        check_raster(&drawing, &shape, extent, &subject);
        mt_arena_reset(&arena);
    }
}

/* Components of any kind over one another, as a glyph drawn in overlapping strokes. */
static void strokes(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(80); i++) {
        mt_random random = mt_random_case(i);
        mt_rings drawing = mt_test_rings(&arena, 16);
        drawing.count = 0;
        for (int k = 0; k < 3; k++) {
            mt_component stroke = mt_random_polygon(
                &random, &arena, (mt_polygon_kind)((i + k) % MT_POLYGON_CELLS), 24, MT_EM / 2);
            for (int r = 0; r < stroke.count; r++) drawing.rings[drawing.count++] = stroke.rings[r];
        }
        mt_subject subject = {"strokes", i, {&drawing}};
        mt_shape shape;
        mt_require(mt_union(&drawing, MT_NONZERO, &arena, &shape) == MT_OK, &subject);
        check_raster(&drawing, &shape, MT_EM / 2, &subject);
        mt_arena_reset(&arena);
    }
}

enum { BOXES = 12, GRID = 24 };

/* Winding numbers of the unit squares; nonzero ones are ink. */
static int64_t ink_of(int winding[GRID][GRID]) {
    int64_t ink = 0;
    for (int x = 0; x < GRID; x++)
        for (int y = 0; y < GRID; y++) ink += winding[x][y] != 0;
    return ink;
}

/* Where the sides of `count` boxes lie on one axis: sides[2 k] and sides[2 k + 1] are box k's. */
static void place_sides(mt_random *random, int count, bool apart, int *sides) {
    for (int i = 0; i < GRID; i++) sides[i] = i;
    for (int i = GRID - 1; i > 0; i--) { /* all different, in any order */
        int k = mt_random_between(random, 0, i), side = sides[i];
        sides[i] = sides[k];
        sides[k] = side;
    }
    for (int k = 0; k < count; k++) {
        int *box = &sides[2 * k];
        if (!apart) box[0] = mt_random_between(random, 0, GRID - 2);
        if (!apart) box[1] = mt_random_between(random, box[0] + 1, GRID - 1);
        if (box[0] < box[1]) continue;
        int side = box[0];
        box[0] = box[1];
        box[1] = side;
    }
}

static mt_ring box_ring(const int *x, const int *y, int unit, bool backwards) {
    mt_point corners[] = {{x[0], y[0]}, {x[1], y[0]}, {x[1], y[1]}, {x[0], y[1]}};
    mt_ring ring = mt_test_ring(&arena, 4);
    for (int c = 0; c < 4; c++) {
        mt_point p = corners[backwards ? 3 - c : c];
        ring.points[c] = (mt_point){p.x * unit, p.y * unit};
    }
    return ring;
}

/* Boxes on a coarse grid: every crossing is exact, and so is the area. All the one way round, as sums are,
 * and then many touch and share edges; or either way round, and then no two sides are in line (see
 * unit/known_winding_lost.c). */
static void boxes(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(300); i++) {
        mt_random random = mt_random_case(i);
        int winding[GRID][GRID] = {{0}}, x[GRID], y[GRID], unit = mt_random_between(&random, 1, 10000);
        bool apart = i % 2;
        mt_rings drawing = mt_test_rings(&arena, mt_random_between(&random, 1, BOXES));
        place_sides(&random, drawing.count, apart, x);
        place_sides(&random, drawing.count, apart, y);
        for (int k = 0; k < drawing.count; k++) {
            bool backwards = apart && mt_random_one_in(&random, 3);
            drawing.rings[k] = box_ring(&x[2 * k], &y[2 * k], unit, backwards);
            for (int column = x[2 * k]; column < x[2 * k + 1]; column++)
                for (int row = y[2 * k]; row < y[2 * k + 1]; row++)
                    winding[column][row] += backwards ? -1 : 1;
        }
        mt_subject subject = {"boxes", i, {&drawing}};
        mt_shape shape, again;
        mt_require(mt_union(&drawing, MT_NONZERO, &arena, &shape) == MT_OK, &subject);
        mt_require(mt_oracle_shape_area2(&shape) == (mt_wide)2 * unit * unit * ink_of(winding), &subject);
        for (int k = 0; k < shape.count; k++)
            mt_require(mt_oracle_is_crossing_free(&shape.components[k]), &subject);
        mt_rings all = mt_test_all_rings(&arena, &shape);
        mt_require(mt_union(&all, MT_NONZERO, &arena, &again) == MT_OK, &subject);
        mt_require(mt_oracle_shape_area2(&shape) == mt_oracle_shape_area2(&again), &subject);
        mt_arena_reset(&arena);
    }
}

/* Polygons without crossings come back with their area, whatever touches and repeats: exactly in at least
 * 95 of 100 cases, and always within a band of one unit along the boundary, since edges that come closer
 * to each other than a unit may be taken to cross. */
static void components_come_back(void **state) {
    (void)state;
    int exact = 0, cases = mt_test_cases(300);
    for (int i = 0; i < cases; i++) {
        mt_random random = mt_random_case(i);
        mt_component component = mt_random_component(&random, &arena, 40, i % 2 ? 1000 : MT_EM);
        mt_subject subject = {"components_come_back", i, {&component}};
        mt_shape shape;
        mt_require(mt_union(&component, MT_NONZERO, &arena, &shape) == MT_OK, &subject);
        double off = (double)(mt_oracle_shape_area2(&shape) - mt_oracle_area2(&component)) / 2;
        mt_require(fabs(off) <= mt_oracle_length(&component), &subject);
        exact += off == 0;
        mt_arena_reset(&arena);
    }
    assert_true(100 * exact >= 95 * cases);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scrawls),
        cmocka_unit_test(strokes),
        cmocka_unit_test(boxes),
        cmocka_unit_test(components_come_back),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
