/* Solids drawn: what is seen of a mesh, sample by sample, and where lines are. */
#include "scene/lines.h"
#include "scene/render.h"

#include <math.h>

#include "support/check.h"

enum { SIDE = 40 }; /* pixels */

/* Squares facing the eye, anticlockwise, each at a depth: the left, bottom, right and top of each, and z. */
typedef struct tile {
    double left, low, right, high, z;
} tile;

static mt_mesh mesh_of(const tile *tiles, int count, mt_arena *arena) {
    mt_mesh mesh = {4 * count, 2 * count, mt_arena_new(arena, 4 * (size_t)count, sizeof(mt_vector3)),
                    mt_arena_new(arena, 2 * (size_t)count, sizeof(mt_triangle))};
    for (int i = 0; i < count; i++) {
        tile t = tiles[i];
        mt_vector3 *points = mesh.points + 4 * i;
        points[0] = (mt_vector3){t.left, t.low, t.z};
        points[1] = (mt_vector3){t.right, t.low, t.z};
        points[2] = (mt_vector3){t.right, t.high, t.z};
        points[3] = (mt_vector3){t.left, t.high, t.z};
        mesh.triangles[2 * i] = (mt_triangle){{4 * i, 4 * i + 1, 4 * i + 2}};
        mesh.triangles[2 * i + 1] = (mt_triangle){{4 * i, 4 * i + 2, 4 * i + 3}};
    }
    return mesh;
}

/* The samples of a picture of SIDE pixels, on which a unit is a pixel and (0, 0) the middle. */
static mt_samples take(const mt_mesh *mesh, mt_arena *arena, mt_seen_mesh *seen) {
    mt_samples samples;
    const mt_eye eye = mt_eye_at(0, 0);
    mt_assert_ok(mt_seen_mesh_make(mesh, &eye, (mt_vector3){0}, 1, SIDE, SIDE, arena, seen));
    mt_assert_ok(mt_samples_new(SIDE * MT_SAMPLES, SIDE * MT_SAMPLES, arena, &samples));
    mt_samples_take(seen, 0, &samples);
    return samples;
}

/* The tile seen in the middle of the pixel at (x, y), y upwards from the middle; -1 for none. */
static int tile_at(const mt_samples *samples, int x, int y) {
    size_t row = (size_t)((SIDE / 2 - y) * MT_SAMPLES), column = (size_t)((SIDE / 2 + x) * MT_SAMPLES);
    int triangle = samples->triangle[row * (size_t)samples->width + column];
    return triangle < 0 ? -1 : triangle / 2;
}

static void the_nearest_is_seen(void **state) {
    (void)state;
    static const tile tiles[] = {{-10, -10, 10, 10, 0}, {0, 0, 15, 15, 5}, {-15, -15, 0, 0, -5}};
    mt_arena arena = {0};
    mt_seen_mesh seen;
    mt_mesh mesh = mesh_of(tiles, 3, &arena);
    mt_samples samples = take(&mesh, &arena, &seen);
    assert_int_equal(tile_at(&samples, -5, 5), 0);
    assert_int_equal(tile_at(&samples, 5, 5), 1);
    assert_int_equal(tile_at(&samples, -5, -5), 0);
    assert_int_equal(tile_at(&samples, -12, -12), 2);
    assert_int_equal(tile_at(&samples, 12, -12), -1);
    mt_arena_release(&arena);
}

static void what_faces_away_or_has_no_area_is_not_seen(void **state) {
    (void)state;
    static const tile tiles[] = {{-10, -10, 10, 10, 0}, {-10, -10, 10, -10, 9}, {10, -10, -10, 10, 5}};
    mt_arena arena = {0};
    mt_seen_mesh seen;
    mt_mesh mesh = mesh_of(tiles, 3, &arena);
    mt_samples samples = take(&mesh, &arena, &seen);
    for (int x = -9; x < 10; x++)
        for (int y = -9; y < 10; y++) assert_int_equal(tile_at(&samples, x, y), 0);
    mt_arena_release(&arena);
}

/* A fan around a place that is on no sample: no sample between its triangles is left out, and none is covered twice, since depths tell. */
static void neighbours_leave_no_gap(void **state) {
    (void)state;
    enum { SPOKES = 97 };
    static mt_vector3 points[SPOKES + 1];
    static mt_triangle triangles[SPOKES];
    const mt_mesh mesh = {SPOKES + 1, SPOKES, points, triangles};
    mt_arena arena = {0};
    mt_seen_mesh seen;
    points[SPOKES] = (mt_vector3){0.1234567, -0.7654321, 3};
    for (int i = 0; i < SPOKES; i++) {
        double angle = 2 * acos(-1) * i / SPOKES;
        points[i] = (mt_vector3){15 * cos(angle), 15 * sin(angle), 0};
        triangles[i] = (mt_triangle){{i, (i + 1) % SPOKES, SPOKES}};
    }
    mt_samples samples = take(&mesh, &arena, &seen);
    for (int y = 0; y < samples.rows; y++)
        for (int x = 0; x < samples.width; x++) {
            double dx = x + 0.5 - samples.width / 2.0, dy = y + 0.5 - samples.rows / 2.0;
            bool inside = hypot(dx, dy)<14.9 * MT_SAMPLES, outside = hypot(dx, dy)> 15.1 * MT_SAMPLES;
            int triangle = samples.triangle[y * samples.width + x];
            if (inside) assert_true(triangle >= 0);
            if (outside) assert_true(triangle < 0);
        }
    mt_arena_release(&arena);
}

/* How many samples of the row through the middle have ink. */
static int ink_across(const mt_seen_mesh *seen, const mt_samples *samples, mt_arena *arena) {
    size_t count = (size_t)samples->width * (size_t)samples->rows;
    uint8_t *marks = mt_arena_new(arena, count, 1), *ink = mt_arena_new(arena, count, 1);
    int sum = 0;
    mt_lines_find(seen, samples, marks, ink);
    for (int x = 0; x < samples->width; x++) sum += ink[samples->rows / 2 * samples->width + x];
    return sum;
}

static void lines_are_at_edges_steps_and_creases(void **state) {
    (void)state;
    enum { LINE = 2 * MT_LINE_REACH + 1 };
    static const struct {
        tile tiles[2];
        double lifted; /* how much nearer the right side of the second tile is than its left */
        int lines;
    } cases[] = {
        {{{-10, -10, 0, 10, 0}, {0, -10, 10, 10, 0}}, 0, 2},   /* two halves of one face */
        {{{-10, -10, 0, 10, 0}, {0, -10, 10, 10, 5}}, 0, 3},   /* one half nearer */
        {{{-10, -10, 0, 10, 0}, {0, -10, 10, 10, 0}}, 10, 3},  /* at 45 degrees */
        {{{-10, -10, 0, 10, 0}, {0, -10, 10, 10, 0}}, 3, 2},   /* at 17 degrees */
        {{{-10, -10, 10, 10, 0}, {-5, -10, 5, 10, -2}}, 0, 2}, /* hidden */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        mt_arena arena = {0};
        mt_seen_mesh seen;
        mt_mesh mesh = mesh_of(cases[i].tiles, 2, &arena);
        mesh.points[5].z += cases[i].lifted;
        mesh.points[6].z += cases[i].lifted;
        mt_samples samples = take(&mesh, &arena, &seen);
        assert_in_range(ink_across(&seen, &samples, &arena), (cases[i].lines * LINE) - 2,
                        cases[i].lines * LINE + 2);
        mt_arena_release(&arena);
    }
}

/* A strip at 45 degrees between two halves of one face. */
static void what_is_narrower_than_a_pixel_makes_no_lines(void **state) {
    (void)state;
    enum { LINE = 2 * MT_LINE_REACH + 1 };
    static const struct {
        double width;
        int lines;
    } cases[] = {{0.5, 2}, {4, 4}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        tile tiles[] = {
            {-10, -10, 0, 10, 0}, {0, -10, cases[i].width, 10, 0}, {cases[i].width, -10, 10, 10, 0}};
        mt_arena arena = {0};
        mt_seen_mesh seen;
        mt_mesh mesh = mesh_of(tiles, 3, &arena);
        mesh.points[5].z = mesh.points[6].z = cases[i].width;
        mt_samples samples = take(&mesh, &arena, &seen);
        assert_in_range(ink_across(&seen, &samples, &arena), (cases[i].lines * LINE) - 2,
                        cases[i].lines * LINE + 2);
        mt_arena_release(&arena);
    }
}

/* Bands of rows join without a seam: a picture moved by some rows is the same picture. */
static void bands_leave_no_seam(void **state) {
    (void)state;
    enum { HEIGHT = 150, SHIFT = 13 };
    static const tile tiles[] = {{-10, -60, 10, 60, 0}, {-5, -50, 15, 40, 4}};
    mt_arena arena = {0};
    mt_mesh mesh = mesh_of(tiles, 2, &arena);
    cairo_surface_t *images[2];
    for (int i = 0; i < 2; i++) {
        mt_render render = {mt_eye_at(0, 0), {0, i * SHIFT, 0}, 1, SIDE, HEIGHT};
        mt_assert_ok(mt_render_mesh(&mesh, &render, &images[i]));
    }
    int stride = cairo_image_surface_get_stride(images[0]);
    for (int y = 0; y + SHIFT < HEIGHT; y++)
        assert_memory_equal(cairo_image_surface_get_data(images[0]) + y * stride,
                            cairo_image_surface_get_data(images[1]) + (y + SHIFT) * stride, 4 * SIDE);
    for (int i = 0; i < 2; i++) cairo_surface_destroy(images[i]);
    mt_arena_release(&arena);
}

static void the_eye_stands_where_it_is_told(void **state) {
    (void)state;
    static const struct {
        double turn, tilt;
        mt_vector3 right, up;
    } cases[] = {
        {0, 0, {1, 0, 0}, {0, 1, 0}},
        {90, 0, {0, 0, -1}, {0, 1, 0}},
        {0, 90, {1, 0, 0}, {0, 0, -1}},
        {180, 0, {-1, 0, 0}, {0, 1, 0}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        mt_eye eye = mt_eye_at(cases[i].turn, cases[i].tilt);
        mt_vector3 right = mt_eye_sees(&eye, cases[i].right), up = mt_eye_sees(&eye, cases[i].up);
        assert_true(fabs(right.x - 1) < 1e-12);
        assert_true(fabs(up.y - 1) < 1e-12);
        assert_true(fabs(right.y) + fabs(up.x) + fabs(right.z) + fabs(up.z) < 1e-12);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_nearest_is_seen),
        cmocka_unit_test(what_faces_away_or_has_no_area_is_not_seen),
        cmocka_unit_test(neighbours_leave_no_gap),
        cmocka_unit_test(lines_are_at_edges_steps_and_creases),
        cmocka_unit_test(what_is_narrower_than_a_pixel_makes_no_lines),
        cmocka_unit_test(bands_leave_no_seam),
        cmocka_unit_test(the_eye_stands_where_it_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
