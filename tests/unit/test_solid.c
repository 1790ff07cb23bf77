/* Cells, cuts, hulls and sums in space on solids that are known. */
#include "solid/cut.h"
#include "solid/decompose.h"
#include "solid/solid_morph.h"
#include "space/hull.h"
#include "space/vector.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/random.h"
#include "support/solids.h"

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static double mesh_volume(const mt_vector3 *points, const mt_triangle *triangles, int n) {
    double sum = 0;
    for (int t = 0; t < n; t++) {
        const int *at = triangles[t].at;
        sum += mt_dot3(points[at[0]], mt_cross3(points[at[1]], points[at[2]]));
    }
    return sum / 6;
}

/* ---- predicates ---------------------------------------------------------------------------------------- */

static void a_place_is_on_its_side_of_a_plane(void **state) {
    (void)state;
    const int32_t far = MT_PLACE_MAX;
    mt_plane plane =
        mt_plane_through((mt_place){-far, -far, 0}, (mt_place){far, -far, 0}, (mt_place){far, far, 0});
    assert_int_equal(mt_plane_side(&plane, (mt_place){far, -far, 1}), 0); /* rounding */
    assert_int_equal(mt_plane_side(&plane, (mt_place){far, -far, 2}), 1);
    assert_int_equal(mt_plane_side(&plane, (mt_place){-far, far, -2}), -1);
    assert_int_equal(mt_plane_side(&plane, (mt_place){-far, far, far}), 1);
    assert_true(mt_plane_height(&plane, (mt_place){far, far, 1}) > 0);
}

static void a_crossing_is_the_same_from_both_ends(void **state) {
    (void)state;
    mt_random random = mt_random_case(0);
    for (int i = 0; i < mt_test_cases(300); i++) {
        mt_place p[5];
        for (int k = 0; k < 5; k++)
            p[k] = (mt_place){mt_random_between(&random, -MT_PLACE_MAX, MT_PLACE_MAX),
                              mt_random_between(&random, -MT_PLACE_MAX, MT_PLACE_MAX),
                              mt_random_between(&random, -MT_PLACE_MAX, MT_PLACE_MAX)};
        mt_plane plane = mt_plane_through(p[0], p[1], p[2]);
        if (mt_plane_side(&plane, p[3]) * mt_plane_side(&plane, p[4]) >= 0) continue;
        mt_place there = mt_plane_crossing(&plane, p[3], p[4]), back = mt_plane_crossing(&plane, p[4], p[3]);
        assert_true(mt_place_equal(there, back));
        assert_int_equal(mt_plane_side(&plane, there), 0);
    }
}

/* ---- hulls --------------------------------------------------------------------------------------------- */

static void a_cube_has_six_facets(void **state) {
    (void)state;
    mt_vector3 points[12];
    mt_polytope hull;
    int n = 0;
    for (int i = 0; i < 8; i++) points[n++] = (mt_vector3){i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1};
    points[n++] = (mt_vector3){0, 0, 0};
    points[n++] = (mt_vector3){0.5, -0.25, 1}; /* within a facet */
    points[n++] = (mt_vector3){1, 1, 0.5};     /* on an edge */
    mt_assert_ok(mt_polytope_around(&arena, points, n, &hull));
    assert_int_equal(hull.n_facets, 6);
    assert_int_equal(hull.n_corners, 24);
    assert_true(fabs(hull.volume - 8) < 1e-12);
    for (int f = 0; f < 6; f++) {
        const int *c = hull.facets[f].corners;
        mt_vector3 normal =
            mt_cross3(mt_minus3(points[c[1]], points[c[0]]), mt_minus3(points[c[2]], points[c[1]]));
        assert_true(mt_dot3(normal, hull.facets[f].normal) > 0); /* anticlockwise */
    }
}

static void flat_points_have_no_hull(void **state) {
    (void)state;
    mt_vector3 points[5] = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {0.5, 0.5, 1}};
    mt_polytope hull;
    double volume = 1;
    assert_int_equal(mt_polytope_around(&arena, points, 5, &hull), MT_BAD_GEOMETRY);
    assert_int_equal(mt_polytope_around(&arena, points, 3, &hull), MT_BAD_GEOMETRY);
    mt_assert_ok(mt_hull_volume(points, 5, &volume));
    assert_true(volume == 0);
}

/* ---- cuts ---------------------------------------------------------------------------------------------- */

/* The volume of all cells, and how many are balls. */
static double cells_volume(const mt_cells *cells, int *balls) {
    double sum = 0;
    *balls = 0;
    for (int i = 0; i < cells->n_cells; i++) {
        mt_part part;
        bool ball;
        mt_assert_ok(mt_part_of(&arena, cells, i, -1, &part));
        mt_assert_ok(mt_part_is_ball(&arena, &part, &ball));
        sum += mt_part_volume(&part);
        *balls += ball;
    }
    return sum;
}

static void a_cut_leaves_the_volume(void **state) {
    (void)state;
    mt_mesh block = mt_test_block(&arena);
    mt_cells cells;
    int balls;
    mt_assert_ok(mt_cells_of(&arena, &block, &cells));
    double before = cells_volume(&cells, &balls);
    assert_int_equal(balls, 0);
    /* Across the hole: a cap with a hole, and two blocks with holes. */
    mt_assert_ok(mt_cells_cut(&cells, 0, mt_plane_at(0, 1, 0, (mt_place){0, 0, 0})));
    assert_int_equal(cells.n_cells, 2);
    assert_true(fabs(cells_volume(&cells, &balls) / before - 1) < 1e-12);
    assert_int_equal(balls, 0);
    /* Along it, aslant: two caps, and nothing is round any more. */
    for (int i = 0; i < 2; i++)
        mt_assert_ok(mt_cells_cut(&cells, i, mt_plane_at(3, 1, 2, (mt_place){1, 2, 3})));
    assert_int_equal(cells.n_cells, 4);
    assert_true(fabs(cells_volume(&cells, &balls) / before - 1) < 1e-6);
    assert_int_equal(balls, 4);
}

static void a_plane_beside_a_cell_does_not_cut_it(void **state) {
    (void)state;
    mt_mesh block = mt_test_block(&arena);
    mt_cells cells;
    mt_assert_ok(mt_cells_of(&arena, &block, &cells));
    int n_points = cells.n_points, n_walls = cells.n_walls;
    mt_place corner = {MT_PLACE_MAX, 0, 0};
    assert_int_equal(mt_cells_cut(&cells, 0, mt_plane_at(1, 0, 0, corner)), MT_BAD_GEOMETRY);
    assert_true(cells.n_cells == 1 && cells.n_points == n_points && cells.n_walls == n_walls);
}

static void a_block_with_a_hole_has_four_convex_parts(void **state) {
    (void)state;
    mt_mesh block = mt_test_block(&arena);
    mt_cells cells;
    int balls;
    mt_assert_ok(mt_cells_of(&arena, &block, &cells));
    double before = cells_volume(&cells, &balls);
    mt_assert_ok(mt_cells_decompose(&cells, 0));
    assert_int_equal(cells.n_cells, 4);
    assert_true(fabs(cells_volume(&cells, &balls) / before - 1) < 1e-6);
    assert_int_equal(balls, 4);
}

/* ---- morphs -------------------------------------------------------------------------------------------- */

static void a_cube_and_a_cube_turned_make_a_box_with_its_corners_cut(void **state) {
    (void)state;
    mt_mesh cube = mt_test_box(&arena, (mt_vector3){-1, -1, -1}, (mt_vector3){1, 1, 1});
    mt_solid_params params = {.depth = 0.03};
    mt_mesh other = mt_test_box(&arena, (mt_vector3){-1, -1, -1}, (mt_vector3){1, 1, 1}), at;
    mt_solid_morph morph;
    for (int i = 0; i < 8; i++) { /* by 45 degrees about z */
        mt_vector3 p = other.points[i];
        other.points[i] = (mt_vector3){(p.x - p.y) * M_SQRT1_2, (p.x + p.y) * M_SQRT1_2, p.z};
    }
    mt_assert_ok(mt_solid_prepare(&arena, &cube, &other, &params, &morph));
    mt_assert_ok(mt_solid_at(&arena, &morph, 0.5, &at));
    /* The octagon: both squares at half their size, and what their edges span. */
    double area = 1 + 1 + 4 * 0.5 * M_SQRT2 / 2 * 2;
    assert_true(fabs(mesh_volume(at.points, at.triangles, at.n_triangles) - 2 * area) < 1e-6);
}

static void turning_ends_where_the_solids_are(void **state) {
    (void)state;
    mt_mesh a = mt_test_block(&arena), b = mt_test_box(&arena, (mt_vector3){3, 0, 0}, (mt_vector3){4, 2, 3}),
            at;
    mt_solid_params params = {.depth = 0.03, .axis = {1, 2, 2}, .degrees = 70};
    mt_solid_morph morph;
    mt_assert_ok(mt_solid_prepare(&arena, &a, &b, &params, &morph));
    mt_assert_ok(mt_solid_at(&arena, &morph, 0, &at));
    for (int i = 0; i < at.n_points; i++) { /* some where the box is cut */
        mt_vector3 p = at.points[i];
        assert_true(fmin(p.x - 3, fmin(p.y, p.z)) > -1e-6 && fmin(4 - p.x, fmin(2 - p.y, 3 - p.z)) > -1e-6);
    }
    for (int k = 0; k < b.n_points; k++) {
        double nearest = INFINITY;
        for (int i = 0; i < at.n_points; i++)
            nearest = fmin(nearest, mt_length3(mt_minus3(at.points[i], b.points[k])));
        assert_true(nearest < 1e-6);
    }
}

/* Two boxes that are one solid: 3 × 1 and 1 × 2, one on the other. */
static mt_mesh corner_of(mt_arena *own) {
    static const double outline[6][2] = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    static const int caps[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {3, 4, 5}};
    mt_mesh mesh = {12, 20, mt_arena_new(own, 12, sizeof(mt_vector3)),
                    mt_arena_new(own, 20, sizeof(mt_triangle))};
    if (!mesh.points || !mesh.triangles) return (mt_mesh){0};
    mt_triangle *next = mesh.triangles;
    for (int i = 0; i < 12; i++) mesh.points[i] = (mt_vector3){outline[i % 6][0], outline[i % 6][1], i / 6};
    for (int i = 0; i < 6; i++) {
        int k = (i + 1) % 6;
        *next++ = (mt_triangle){{i, k, k + 6}};
        *next++ = (mt_triangle){{i, k + 6, i + 6}};
    }
    for (int i = 0; i < 4; i++) {
        *next++ = (mt_triangle){{caps[i][0], caps[i][2], caps[i][1]}};
        *next++ = (mt_triangle){{caps[i][0] + 6, caps[i][1] + 6, caps[i][2] + 6}};
    }
    return mesh;
}

static double piece_volume(const mt_mesh *piece) {
    return mesh_volume(piece->points, piece->triangles, piece->n_triangles);
}

static void a_piece_is_divided_among_counterparts_that_meet(void **state) {
    (void)state;
    mt_mesh box = mt_test_box(&arena, (mt_vector3){0, 0, 0}, (mt_vector3){2, 2, 2}),
            corner = corner_of(&arena);
    mt_solid_params params = {.depth = 0.03};
    mt_solid_morph morph;
    mt_assert_ok(mt_solid_prepare(&arena, &box, &corner, &params, &morph));
    assert_int_equal(morph.a.n_pieces, 2);
    assert_int_equal(morph.b.n_pieces, 2);
    assert_int_equal(morph.n_links, 2);
    for (int i = 0; i < 2; i++) { /* as large as it is of the five units of the corner */
        const mt_solid_link *link = &morph.links[i];
        double own = piece_volume(&morph.a.pieces[link->piece_a]),
               wanted = piece_volume(&morph.b.pieces[link->piece_b]);
        assert_true(fabs(own / 8 - wanted / 5) < 0.01);
    }
    params.method = MT_METHOD_PAPER;
    mt_assert_ok(mt_solid_prepare(&arena, &box, &corner, &params, &morph));
    assert_int_equal(morph.a.n_pieces, 1);
    assert_int_equal(morph.n_links, 2);
}

static mt_status morph_in_want(void) {
    mt_arena own = {0};
    mt_solid_params params = {.depth = 0.03};
    mt_solid_morph morph;
    mt_mesh a = corner_of(&own), b = mt_test_box(&own, (mt_vector3){0, 0, 0}, (mt_vector3){1, 2, 3});
    mt_status status = a.points && b.points ? mt_solid_prepare(&own, &a, &b, &params, &morph) : MT_NO_MEMORY;
    mt_arena_release(&own);
    return status;
}

static void want_of_memory(void **state) {
    (void)state;
    mt_test_want_of_memory(morph_in_want);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_place_is_on_its_side_of_a_plane),
        cmocka_unit_test(a_crossing_is_the_same_from_both_ends),
        cmocka_unit_test(a_cube_has_six_facets),
        cmocka_unit_test(flat_points_have_no_hull),
        cmocka_unit_test(a_cut_leaves_the_volume),
        cmocka_unit_test(a_plane_beside_a_cell_does_not_cut_it),
        cmocka_unit_test(a_block_with_a_hole_has_four_convex_parts),
        cmocka_unit_test(a_cube_and_a_cube_turned_make_a_box_with_its_corners_cut),
        cmocka_unit_test(a_piece_is_divided_among_counterparts_that_meet),
        cmocka_unit_test(turning_ends_where_the_solids_are),
        cmocka_unit_test(want_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
