#include "geometry/limits.h"
#include "geometry/triangulate.h"
#include "support/corpus.h"
#include "support/polygons.h"
#include "support/promises.h"

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

static mt_half_edges mesh_of(const char *name) {
    mt_half_edges mesh = {0};
    mt_assert_ok(mt_triangulate(mt_corpus_find(&corpus, name), &arena, &mesh));
    return mesh;
}

static void counts(void **state) {
    (void)state;
    assert_int_equal(mesh_of("triangle").triangle_count, 1);
    assert_int_equal(mesh_of("smallest").triangle_count, 1);
    assert_int_equal(mesh_of("square").triangle_count, 2);
    assert_int_equal(mesh_of("square_with_repeats").triangle_count, 2);
    assert_int_equal(mesh_of("frame").triangle_count, 8);
    assert_int_equal(mesh_of("eight_holes_in_a_row").triangle_count, 4 * 9 + 2 * 8 - 2);
    assert_int_equal(mesh_of("touches_itself_at_a_vertex").triangle_count, 2);
}

/* Of a kite's two diagonals the Delaunay one is the shorter here. */
static void the_better_diagonal(void **state) {
    (void)state;
    mt_ring kite = mt_test_ring(&arena, 4);
    mt_point corners[] = {{0, 0}, {100, -10}, {200, 0}, {100, 10}};
    for (int i = 0; i < 4; i++) kite.points[i] = corners[i];
    mt_component component = {1, &kite};
    mt_half_edges mesh;
    mt_assert_ok(mt_triangulate(&component, &arena, &mesh));
    for (int e = 0; e < 6; e++)
        if (mesh.twin[e] >= 0) assert_int_equal(mesh.points[mesh.start[e]].x, 100);
}

static void corpus_promises(void **state) {
    (void)state;
    for (int i = 0; i < corpus.count; i++) {
        const mt_named *shape = &corpus.shapes[i];
        if (!shape->is_component) continue;
        mt_subject subject = {shape->name, -1, {&shape->rings}};
        mt_half_edges mesh;
        mt_require(mt_triangulate(&shape->rings, &arena, &mesh) == MT_OK, &subject);
        mt_check_mesh(&shape->rings, &mesh, &subject);
    }
}

/* A half-edge on the boundary has the marks of its ring edge's start; a diagonal is a line, from a corner
 * if that vertex is one. */
static void marks_of_edges(void **state) {
    (void)state;
    mt_component component = mt_test_moved(&arena, mt_corpus_find(&corpus, "plus"), 1, (mt_point){0, 0});
    for (int i = 0; i < 12; i++) component.rings[0].marks[i] = i % 2 ? MT_CHORD : MT_CORNER | MT_LINE;
    mt_half_edges mesh;
    mt_assert_ok(mt_triangulate(&component, &arena, &mesh));
    for (int e = 0; e < 3 * mesh.triangle_count; e++) {
        uint8_t own = component.rings[0].marks[mesh.start[e]];
        assert_int_equal(mesh.marks[e], mesh.twin[e] < 0 ? own : (own & MT_CORNER) | MT_LINE);
    }
}

static void crossing_rings_are_refused(void **state) {
    (void)state;
    mt_half_edges mesh;
    static const char *const names[] = {"bow_tie", "crossed_bars", "pentagram", "almost_parallel_bars"};
    for (int i = 0; i < 4; i++)
        assert_int_equal(mt_triangulate(mt_corpus_find(&corpus, names[i]), &arena, &mesh), MT_BAD_GEOMETRY);
}

static void nothing_gives_nothing(void **state) {
    (void)state;
    mt_component none = {0};
    mt_half_edges mesh;
    mt_assert_ok(mt_triangulate(&none, &arena, &mesh));
    assert_int_equal(mesh.triangle_count, 0);
    assert_int_equal(mesh_of("no_area").triangle_count, 0);
    assert_int_equal(mesh_of("one_point").triangle_count, 0);
    assert_int_equal(mesh_of("backwards_square").triangle_count, 0);
}

static void limits(void **state) {
    (void)state;
    const int32_t m = MT_COORD_MAX;
    mt_ring square = mt_test_ring(&arena, 4);
    mt_point corners[] = {{-m, -m}, {m, -m}, {m, m}, {-m, m}};
    for (int i = 0; i < 4; i++) square.points[i] = corners[i];
    mt_component component = {1, &square};
    mt_subject subject = {"the_largest_square", -1, {&component}};
    mt_half_edges mesh;
    mt_assert_ok(mt_triangulate(&component, &arena, &mesh));
    mt_check_mesh(&component, &mesh, &subject);
    square.points[2].x = m + 1;
    assert_int_equal(mt_triangulate(&component, &arena, &mesh), MT_TOO_LARGE);
    square.points[2].x = m;
    square.points[0].y = INT32_MIN;
    assert_int_equal(mt_triangulate(&component, &arena, &mesh), MT_TOO_LARGE);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(counts),
        cmocka_unit_test(the_better_diagonal),
        cmocka_unit_test(corpus_promises),
        cmocka_unit_test(marks_of_edges),
        cmocka_unit_test(crossing_rings_are_refused),
        cmocka_unit_test(nothing_gives_nothing),
        cmocka_unit_test(limits),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
