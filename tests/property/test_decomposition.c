/* Section 2.1 on random components: the area identity, convexity of each piece, the bounds on their
 * number, Delaunay. */
#include "geometry/decompose.h"
#include "geometry/limits.h"
#include "geometry/union.h"
#include "support/corpus.h"
#include "support/oracle.h"
#include "support/polygons.h"
#include "support/promises.h"

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static void check(const char *name, int number, const mt_component *component) {
    mt_subject subject = {name, number, {component}};
    mt_half_edges mesh;
    mt_pieces pieces;
    mt_require(mt_triangulate(component, &arena, &mesh) == MT_OK, &subject);
    mt_check_mesh(component, &mesh, &subject);
    mt_require(mt_decompose(component, &arena, &pieces) == MT_OK, &subject);
    mt_check_pieces(component, &pieces, &subject);
}

static void random_components(void **state) {
    (void)state;
    static const int extents[] = {64, 1000, MT_EM, MT_COORD_MAX};
    for (int i = 0; i < mt_test_cases(600); i++) {
        mt_random random = mt_random_case(i);
        int size = mt_random_between(&random, 3, i % 10 ? 24 : 120);
        mt_component component = mt_random_component(&random, &arena, size, extents[i % 4]);
        check("random_components", i, &component);
        mt_arena_reset(&arena);
    }
}

/* Coordinates of a few units: most triples are in line or on a circle with a fourth. */
static void crowded_components(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(400); i++) {
        mt_random random = mt_random_case(i);
        mt_component component =
            mt_random_polygon(&random, &arena, MT_POLYGON_TANGLE, mt_random_between(&random, 3, 30), 8);
        check("crowded_components", i, &component);
        mt_component cells =
            mt_random_polygon(&random, &arena, MT_POLYGON_CELLS, mt_random_between(&random, 1, 60), 64);
        check("crowded_cells", i, &cells);
        mt_arena_reset(&arena);
    }
}

/* What the union makes of random scrawls: holes that touch, edges that cross under small angles, slivers
 * between them. Rounding the crossings of a hundred edges may, rarely, make edges cross again: such a
 * component is refused, not drawn. */
static void resolved_scrawls(void **state) {
    (void)state;
    int components = 0, refused = 0;
    for (int i = 0; i < mt_test_cases(150); i++) {
        mt_random random = mt_random_case(i);
        mt_rings drawing = mt_test_rings(&arena, 2);
        for (int k = 0; k < 2; k++)
            drawing.rings[k] = mt_random_scrawl(&random, &arena, mt_random_between(&random, 3, 20), MT_EM);
        mt_shape shape;
        mt_subject subject = {"resolved_scrawls", i, {&drawing}};
        mt_require(mt_union(&drawing, MT_NONZERO, &arena, &shape) == MT_OK, &subject);
        for (int k = 0; k < shape.count; k++, components++) {
            mt_pieces pieces;
            subject.shapes[1] = &shape.components[k];
            mt_status status = mt_decompose(&shape.components[k], &arena, &pieces);
            mt_require(status == MT_OK || status == MT_BAD_GEOMETRY, &subject);
            if (status == MT_OK)
                mt_check_pieces(&shape.components[k], &pieces, &subject);
            else
                refused++;
        }
        mt_arena_reset(&arena);
    }
    assert_true(refused * 100 <= components);
}

static void check_same(const mt_component *component, int factor, mt_point by, const mt_subject *subject) {
    mt_component other = mt_test_moved(&arena, component, factor, by);
    mt_pieces pieces, others;
    mt_require(mt_decompose(component, &arena, &pieces) == MT_OK, subject);
    mt_require(mt_decompose(&other, &arena, &others) == MT_OK, subject);
    mt_require(pieces.count == others.count, subject);
    mt_rings expected = mt_test_moved(&arena, &pieces, factor, by);
    for (int k = 0; k < pieces.count; k++) {
        mt_require(expected.rings[k].count == others.rings[k].count, subject);
        for (int p = 0; p < expected.rings[k].count; p++)
            mt_require(mt_point_equal(expected.rings[k].points[p], others.rings[k].points[p]), subject);
    }
}

/* Moving by whole units and scaling by a whole factor change no predicate: the pieces are the same ones. */
static void moved_components(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(200); i++) {
        mt_random random = mt_random_case(i);
        mt_component component = mt_random_component(&random, &arena, 30, 10000);
        mt_point by = mt_random_point(&random, -90000, 90000);
        mt_subject subject = {"moved_components", i, {&component}};
        check_same(&component, 1, by, &subject);
        mt_arena_reset(&arena);
    }
}

static void scaled_components(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(200); i++) {
        mt_random random = mt_random_case(i);
        mt_component component = mt_random_component(&random, &arena, 30, 10000);
        mt_subject subject = {"scaled_components", i, {&component}};
        check_same(&component, mt_random_between(&random, 2, 64), (mt_point){0, 0}, &subject);
        mt_arena_reset(&arena);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_components), cmocka_unit_test(crowded_components),
        cmocka_unit_test(resolved_scrawls),  cmocka_unit_test(moved_components),
        cmocka_unit_test(scaled_components),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
