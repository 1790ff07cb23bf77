/* Each validator takes what its constructor makes, and refuses it with any one invariant broken. */
#include "geometry/decompose.h"
#include "geometry/limits.h"
#include "geometry/outline.h"
#include "geometry/trace.h"
#include "geometry/triangulate.h"
#include "morph/align/align.h"
#include "morph/divide/division.h"
#include "morph/divide/ring_matching.h"
#include "morph/paper/similarity.h"
#include "support/check.h"
#include "support/polygons.h"

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static const int corners[][2] = {{0, 0}, {60, 0}, {60, 40}, {30, 50}, {0, 40}};

static mt_component house(void) {
    mt_component made = mt_test_rings(&arena, 1);
    made.rings[0] = mt_test_ring_of(&arena, corners, 5, 100);
    return made;
}

/* Takes the struct as it is, refuses it with a place changed, and puts that back. */
#define refuses(valid, place, broken)                                                                        \
    do {                                                                                                     \
        assert_true(valid);                                                                                  \
        const __typeof__(place) before = (place);                                                            \
        (place) = (broken);                                                                                  \
        assert_false(valid);                                                                                 \
        (place) = before;                                                                                    \
    } while (0)

static void rings_and_shapes(void **state) {
    (void)state;
    mt_component component = house();
    mt_ring *ring = &component.rings[0];
    mt_shape shape = {1, &component};
    refuses(mt_ring_is_valid(ring), ring->points[1].x, 5 * MT_COORD_MAX);
    refuses(mt_ring_is_valid(ring), ring->marks[2], (uint8_t)~0);
    refuses(mt_ring_is_valid(ring), ring->marks, NULL);
    refuses(mt_component_is_valid(&component), ring->count, 2);
    refuses(mt_shape_is_valid(&shape), component.count, 0);
    mt_ring hole = mt_test_ring_of(&arena, corners, 5, 10);
    mt_ring both[] = {*ring, hole};
    assert_false(mt_component_is_valid(&(mt_component){2, both})); /* a hole runs clockwise */
    mt_pieces pieces = {1, ring};
    refuses(mt_pieces_is_valid(&pieces), ring->points[3].y, 1000);
}

static void meshes_and_traces(void **state) {
    (void)state;
    mt_component component = house();
    mt_half_edges mesh;
    mt_trace trace;
    mt_assert_ok(mt_triangulate(&component, &arena, &mesh));
    refuses(mt_half_edges_is_valid(&mesh), mesh.start[0], mesh.vertex_count);
    refuses(mt_half_edges_is_valid(&mesh), mesh.start[0], mesh.start[1]);
    for (int e = 0; e < 3 * mesh.triangle_count; e++)
        if (mesh.twin[e] >= 0) refuses(mt_half_edges_is_valid(&mesh), mesh.twin[e], e);
    mt_assert_ok(mt_trace_ring(&component.rings[0], 50, &arena, &trace));
    refuses(mt_trace_is_valid(&trace), trace.length[0], -1);
    refuses(mt_trace_is_valid(&trace), trace.turn[1], 4);
    refuses(mt_trace_is_valid(&trace), trace.ring.count, 2);
}

static void outlines_and_pairs(void **state) {
    (void)state;
    mt_component component = house();
    mt_outline outline;
    mt_assert_ok(mt_fit(&component, 50, 50, &arena, &outline));
    mt_contour contour = outline.contours[0];
    refuses(mt_outline_is_valid(&outline), contour.segments[0].degree, 4);
    refuses(mt_contour_is_valid(&contour), contour.count, 0);
    mt_contour_pair pair = {.a = contour, .b = contour};
    mt_variable_outline variable = {1, &pair};
    refuses(mt_variable_outline_is_valid(&variable), pair.b.count, contour.count - 1);
    refuses(mt_contour_pair_is_valid(&pair), contour.segments[1].degree, 3);
}

static void links_and_sides(void **state) {
    (void)state;
    mt_link list[] = {{0, 1}, {1, 0}};
    mt_links links = {2, list};
    refuses(mt_links_is_valid(&links, 2, 2), list[1].a, 0);
    refuses(mt_links_is_valid(&links, 2, 2), list[0].b, 2);
    mt_component component = house();
    mt_pieces pieces;
    mt_assert_ok(mt_decompose(&component, &arena, &pieces));
    bool aligned = false;
    int first[] = {0, pieces.count};
    mt_shape shape = {1, &component};
    mt_morph morph = {
        .a = {.whole = shape, .shape = shape, .aligned = &aligned, .pieces = pieces, .first = first}};
    morph.b = morph.a;
    refuses(mt_side_is_valid(&morph.a), aligned, true);
    refuses(mt_side_is_valid(&morph.a), first[1], 0);
    morph.matches = (mt_links){1, list};
    list[0].b = 0;
    refuses(mt_morph_is_valid(&morph), list[0].a, 1);
    mt_hull hull;
    mt_assert_ok(mt_hull_of(&component, mt_shape_box(&shape), &arena, &hull));
    refuses(mt_hull_is_valid(&hull), hull.centre[0], 2);
    refuses(mt_hull_is_valid(&hull), hull.area, -1);
}

static void alignments(void **state) {
    (void)state;
    mt_component component = house();
    mt_ring_samples samples;
    mt_alignment alignment;
    mt_params params = mt_params_default();
    mt_settings settings = mt_settings_at(0, &params);
    mt_frame frame = mt_frame_of_box(mt_ring_box(&component.rings[0]));
    refuses(mt_frame_is_valid(&frame), frame.box.min.x, frame.box.max.x + 1);
    refuses(mt_frame_is_valid(&frame), frame.y[2], NAN);
    refuses(mt_frame_is_valid(&frame), frame.heading[3], -1);
    mt_assert_ok(mt_ring_samples_at_least(&component.rings[0], 50, 20, &arena, &samples));
    mt_assert_ok(
        mt_align(&samples, &frame, &samples, &frame, &settings.align, &(mt_links){0}, &arena, &alignment));
    refuses(mt_alignment_is_valid(&alignment), alignment.steps[2].a, alignment.steps[2].a + 3);
    refuses(mt_alignment_is_valid(&alignment), alignment.steps[1], alignment.steps[0]);
    refuses(mt_alignment_is_valid(&alignment), alignment.count, 0);
}

static void graphs_and_matches(void **state) {
    (void)state;
    static const int bar[][2] = {{0, 0}, {60, 0}, {60, 10}, {0, 10}};
    mt_component component = mt_test_rings(&arena, 1);
    component.rings[0] = mt_test_ring_of(&arena, bar, 4, 1000);
    mt_shape shape = {1, &component};
    mt_boundary graph;
    mt_ring_match match;
    mt_params params = mt_params_default();
    mt_settings settings = mt_settings_at(0, &params);
    mt_frame frame = mt_frame_of_box(mt_shape_box(&shape));
    mt_assert_ok(mt_boundary_of(&shape, &frame, &settings, 20000, &arena, &graph));
    refuses(mt_boundary_is_valid(&graph), graph.first_sample[1], graph.count + 1);
    assert_true(graph.first_chord[graph.count] > 0);
    refuses(mt_boundary_is_valid(&graph), graph.chords[0].to, graph.count);
    refuses(mt_boundary_is_valid(&graph), graph.chords[0].cost, 0);
    mt_assert_ok(mt_match_ring(&graph, 0, &graph, &settings.match, NULL, &arena, &match));
    refuses(mt_ring_match_is_valid(&match), match.steps[0].there, match.steps[0].there + 1);
    refuses(mt_ring_match_is_valid(&match), match.steps[1], match.steps[0]);
}

static void divided_sides(void **state) {
    (void)state;
    mt_component component = house();
    int to_b[] = {0}, to_a[] = {0};
    mt_cut_side a = {{1, &component}, to_b}, b = {{1, &component}, to_a};
    refuses(mt_cut_side_is_valid(&a, &b), to_a[0], -1);
    refuses(mt_cut_side_is_valid(&a, &b), to_b[0], 1);
    refuses(mt_cut_side_is_valid(&a, &b), component.rings[0].count, 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rings_and_shapes),   cmocka_unit_test(meshes_and_traces),
        cmocka_unit_test(outlines_and_pairs), cmocka_unit_test(links_and_sides),
        cmocka_unit_test(alignments),         cmocka_unit_test(graphs_and_matches),
        cmocka_unit_test(divided_sides),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
