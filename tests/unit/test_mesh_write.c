/* Meshes written and read again; the library's handles of solids. */
#include "mesh/write.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "mesh/solid_blend.h"
#include "support/allocation.h"
#include "support/check.h"

static mt_vector3 corners[] = {{0, 0, 0}, {0.1, 0, 0}, {0, 1e5, 0}, {0, 0, -3.125}};
static mt_triangle faces[] = {{{0, 1, 2}}, {{0, 3, 1}}, {{1, 3, 2}}, {{0, 2, 3}}};
static const mt_mesh tetrahedron = {4, 4, corners, faces};

static mt_vector3 other_corners[] = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
static mt_triangle other_faces[] = {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{0, 3, 2}}};
static const mt_mesh other = {4, 4, other_corners, other_faces};

/* ---- files ---------------------------------------------------------------------------------------------- */

static bool has_point(const mt_mesh *mesh, mt_vector3 point, bool is_single) {
    for (int i = 0; i < mesh->n_points; i++) {
        mt_vector3 p = mesh->points[i];
        if (is_single && (float)p.x == (float)point.x && (float)p.y == (float)point.y &&
            (float)p.z == (float)point.z)
            return true;
        if (p.x == point.x && p.y == point.y && p.z == point.z) return true;
    }
    return false;
}

static void every_format_brings_a_mesh_back(void **state) {
    (void)state;
    for (int format = MT_MESH_OBJ; format <= MT_MESH_GLB; format++) {
        bool is_text = format == MT_MESH_OBJ || format == MT_MESH_OFF;
        mt_arena arena = {0};
        mt_buffer file;
        mt_mesh mesh;
        mt_mesh_fault fault;
        mt_assert_ok(mt_mesh_write(&tetrahedron, (mt_mesh_format)format, &file));
        mt_assert_ok(mt_mesh_parse(file.bytes, file.length, (mt_mesh_format)format, &arena, &mesh, &fault));
        assert_int_equal(mesh.n_points, 4);
        assert_int_equal(mesh.n_triangles, 4);
        for (int i = 0; i < 4; i++) assert_true(has_point(&mesh, corners[i], !is_text));
        mt_buffer_free(&file);
        mt_arena_release(&arena);
    }
}

/* ---- handles -------------------------------------------------------------------------------------------- */

static mt_solid *solid_of(const mt_mesh *mesh) {
    mt_solid *solid;
    mt_assert_ok(mt_solid_new(mesh, &solid, NULL));
    return solid;
}

static void handles_check_what_they_are_given(void **state) {
    (void)state;
    mt_mesh open = tetrahedron;
    mt_mesh_fault fault;
    mt_solid *solid = NULL;
    open.n_triangles = 3;
    assert_int_equal(mt_solid_new(&open, &solid, NULL), MT_NOT_SOLID);
    assert_int_equal(mt_solid_new(&open, &solid, &fault), MT_NOT_SOLID);
    assert_non_null(strstr(fault.line, "has one triangle"));
    open.n_triangles = INT32_MAX;
    assert_int_equal(mt_solid_new(&open, &solid, &fault), MT_TOO_LARGE);
    assert_int_equal(mt_solid_open("none.obj", &solid, &fault), MT_NO_FILE);
    assert_string_equal(fault.line, "");
    assert_int_equal(mt_solid_open("none.txt", &solid, &fault), MT_UNKNOWN_FORMAT);
    assert_null(solid);
    mt_solid_free(NULL);
}

static void parameters_have_ranges(void **state) {
    (void)state;
    mt_solid *a = solid_of(&tetrahedron), *b = solid_of(&other);
    mt_solid_blend *blend = NULL;
    mt_mesh mesh;
    const mt_solid_params good = mt_solid_params_default();
    mt_solid_params bad[6];
    for (int i = 0; i < 6; i++) bad[i] = good;
    bad[0].depth = 0;
    bad[1].depth = 0.6;
    bad[2].degrees = 361;
    bad[3].axis = (mt_vector3){0};
    bad[4].method = (mt_method)7;
    bad[5].degrees = 0.0 / 0.0;
    for (int i = 0; i < 6; i++) assert_int_equal(mt_solid_blend_new(a, b, &bad[i], &blend), MT_BAD_PARAMETER);
    assert_null(blend);
    mt_assert_ok(mt_solid_blend_new(a, b, &good, &blend));
    mt_solid_free(a);
    mt_solid_free(b);
    assert_int_equal(mt_solid_blend_mesh(blend, 1.5, &mesh), MT_BAD_PARAMETER);
    assert_int_equal(mt_solid_blend_save(blend, 0.5, "x.txt"), MT_UNKNOWN_FORMAT);
    assert_int_equal(mt_solid_blend_save_morph(blend, 2, false, "x.obj"), MT_UNKNOWN_FORMAT);
    assert_int_equal(mt_solid_blend_save_morph(blend, 0, false, "x.glb"), MT_BAD_PARAMETER);
    assert_int_equal(mt_solid_blend_save(blend, 0.5, "nowhere/x.obj"), MT_CANNOT_WRITE);
    mt_assert_ok(mt_solid_blend_mesh(blend, 1, &mesh));
    assert_int_equal(mesh.n_triangles, 4);
    for (int i = 0; i < 4; i++) assert_true(has_point(&mesh, other_corners[i], false));
    mt_mesh_free(&mesh);
    mt_solid_blend_free(blend);
}

/* ---- memory --------------------------------------------------------------------------------------------- */

static mt_status make_all(void) {
    mt_solid *a = NULL, *b = NULL;
    mt_solid_blend *blend = NULL;
    mt_solid_params params = mt_solid_params_default();
    mt_mesh mesh = {0};
    mt_buffer text = {0}, glb = {0}, file = {0};
    params.degrees = 45;
    mt_status status = mt_solid_new(&tetrahedron, &a, NULL);
    if (status == MT_OK) status = mt_solid_new(&other, &b, NULL);
    if (status == MT_OK) status = mt_solid_blend_new(a, b, &params, &blend);
    if (status == MT_OK) status = mt_solid_blend_mesh(blend, 0.5, &mesh);
    if (status == MT_OK) status = mt_mesh_write(&mesh, MT_MESH_PLY, &file);
    if (status == MT_OK) status = mt_solid_blend_json(blend, "a", "b", &text);
    if (status == MT_OK) status = mt_solid_blend_glb(blend, 2, true, &glb);
    mt_buffer_free(&file);
    mt_buffer_free(&text);
    mt_buffer_free(&glb);
    mt_mesh_free(&mesh);
    mt_solid_blend_free(blend);
    mt_solid_free(a);
    mt_solid_free(b);
    return status;
}

static void survives_want_of_memory(void **state) {
    (void)state;
    mt_test_want_of_memory(make_all);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_format_brings_a_mesh_back),
        cmocka_unit_test(handles_check_what_they_are_given),
        cmocka_unit_test(parameters_have_ranges),
        cmocka_unit_test(survives_want_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
