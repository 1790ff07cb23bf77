/* Readers of meshes: the same solid in every format, and files that are none. */
#include "mesh/read.h"

#include <stdio.h>
#include <string.h>

#include "support/allocation.h"
#include "support/check.h"

/* A tetrahedron over the origin. */
static const float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
static const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};

/* ---- bytes ---------------------------------------------------------------------------------------------- */

typedef struct file {
    size_t length;
    uint8_t bytes[8192];
} file;

static void put(file *to, const void *bytes, size_t length) {
    assert_true(to->length + length <= sizeof to->bytes);
    memcpy(to->bytes + to->length, bytes, length);
    to->length += length;
}

static void put_text(file *to, const char *text) {
    put(to, text, strlen(text));
}

static void put_number(file *to, uint64_t value, int size, bool big) {
    uint8_t bytes[8];
    for (int i = 0; i < size; i++) bytes[big ? size - 1 - i : i] = (uint8_t)(value >> 8 * i);
    put(to, bytes, (size_t)size);
}

static void put_float(file *to, float value, bool big) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    put_number(to, bits, 4, big);
}

static file text_file(const char *text) {
    file made = {0};
    put_text(&made, text);
    return made;
}

static file binary_stl(void) {
    file made = {0};
    for (int i = 0; i < 80; i++) put_text(&made, "s");
    put_number(&made, 4, 4, false);
    for (int t = 0; t < 4; t++) {
        for (int i = 0; i < 3; i++) put_float(&made, 0, false);
        for (int i = 0; i < 9; i++) put_float(&made, corners[faces[t][i / 3]][i % 3], false);
        put_number(&made, 0, 2, false);
    }
    return made;
}

static file binary_ply(bool big) {
    file made = {0};
    put_text(&made, "ply\nformat binary_");
    put_text(&made, big ? "big" : "little");
    put_text(&made,
             "_endian 1.0\ncomment made here\nelement vertex 4\nproperty uchar red\nproperty double x\n"
             "property float y\nproperty float z\nelement face 4\nproperty list uchar short quality\n"
             "property list ushort int vertex_indices\nend_header\n");
    for (int i = 0; i < 4; i++) {
        uint64_t bits;
        double x = (double)corners[i][0];
        memcpy(&bits, &x, sizeof bits);
        put_number(&made, 200, 1, big);
        put_number(&made, bits, 8, big);
        put_float(&made, corners[i][1], big);
        put_float(&made, corners[i][2], big);
    }
    for (int t = 0; t < 4; t++) {
        put_number(&made, 2, 1, big);
        put_number(&made, 7, 2, big);
        put_number(&made, 7, 2, big);
        put_number(&made, 3, 2, big);
        for (int i = 0; i < 3; i++) put_number(&made, (uint64_t)faces[t][i], 4, big);
    }
    return made;
}

#define GLB_VIEWS                                                                                            \
    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":48},{\"buffer\":0,\"byteOffset\":48,\"byteLength\":12}]," \
    "\"buffers\":[{\"byteLength\":60}]"
#define GLB_ACCESSORS                                                                                        \
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":4},"                \
    "{\"bufferView\":1,\"componentType\":5121,\"type\":\"SCALAR\",\"count\":12}],"
#define GLB_MESH "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}],"
#define GLB_ASSET "{\"asset\":{\"version\":\"2.0\"},"

static file glb(const char *json) {
    file made = {0};
    size_t length = strlen(json), padded = (length + 3) / 4 * 4;
    put_text(&made, "glTF");
    put_number(&made, 2, 4, false);
    put_number(&made, 12 + 8 + padded + 8 + 60, 4, false);
    put_number(&made, padded, 4, false);
    put_text(&made, "JSON");
    put_text(&made, json);
    for (size_t i = length; i < padded; i++) put_text(&made, " ");
    put_number(&made, 60, 4, false);
    put(&made, "BIN", 4);
    for (int i = 0; i < 12; i++) put_float(&made, corners[i / 3][i % 3], false);
    for (int i = 0; i < 12; i++) put_number(&made, (uint64_t)faces[i / 3][i % 3], 1, false);
    return made;
}

/* ---- the same solid ------------------------------------------------------------------------------------- */

static mt_status parse(const file *given, mt_mesh_format format, mt_arena *arena, mt_mesh *mesh,
                       mt_mesh_fault *fault) {
    uint8_t *bytes = mt_test_new(given->length + 1, 1);
    memcpy(bytes, given->bytes, given->length);
    mt_status status = mt_mesh_parse(bytes, given->length, format, arena, mesh, fault);
    free(bytes);
    return status;
}

/* Six times the volume. */
static double volume6(const mt_mesh *mesh) {
    double sum = 0;
    for (int t = 0; t < mesh->n_triangles; t++) {
        const int *at = mesh->triangles[t].at;
        mt_vector3 p = mesh->points[at[0]], q = mesh->points[at[1]], r = mesh->points[at[2]];
        sum += p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) + p.z * (q.x * r.y - q.y * r.x);
    }
    return sum;
}

static void expect(file given, mt_mesh_format format, int triangles, double volume) {
    mt_arena arena = {0};
    mt_mesh mesh;
    mt_mesh_fault fault;
    mt_status status = parse(&given, format, &arena, &mesh, &fault);
    if (status != MT_OK) print_error("%s\n", fault.line);
    mt_assert_ok(status);
    assert_int_equal(mesh.n_triangles, triangles);
    assert_int_equal(mesh.n_points, triangles / 2 + 2);
    assert_float_equal(volume6(&mesh), volume, 1e-6);
    mt_arena_release(&arena);
}

#define OBJ_POINTS "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"

static void every_format_gives_the_same_solid(void **state) {
    (void)state;
    expect(text_file("# a comment\no name\n" OBJ_POINTS
                     "g side\nf 1 3 2\nf 1/7/1 2/2/2 4//3\nf -3 \\\n -2 -1\r\nf 1 4 3"),
           MT_MESH_OBJ, 4, 1);
    expect(text_file(
               "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\n"
               "endfacet\nfacet\nouter loop vertex 0 0 0 vertex 1 0 0 vertex 0 0 1 endloop endfacet\n"
               "facet outer loop vertex 1 0 0 vertex 0 1e0 0 vertex 0 0 1. endloop endfacet\n"
               "facet outer loop vertex 0 0 0 vertex 0 0 1 vertex 0 1 0 endloop endfacet\nendsolid a\n"),
           MT_MESH_STL, 4, 1);
    expect(binary_stl(), MT_MESH_STL, 4, 1);
    expect(
        text_file(
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float z\nproperty float y\nproperty float x\n"
            "element edge 0\nelement face 4\nproperty list uchar int vertex_index\nend_header\n"
            "0 0 0\n0 0 1\n0 1 0\n1 0 0\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"),
        MT_MESH_PLY, 4, 1);
    expect(binary_ply(false), MT_MESH_PLY, 4, 1);
    expect(binary_ply(true), MT_MESH_PLY, 4, 1);
    expect(
        text_file("COFF # with colours\n\n4 4 6\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1\n0 0 1 1 0 0 1\n"
                  "3 0 2 1\n3 0 1 3 255 0 0\n3 1 2 3\n3 0 3 2\n"),
        MT_MESH_OFF, 4, 1);
    expect(text_file("4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"), MT_MESH_OFF,
           4, 1);
    expect(glb(GLB_ASSET GLB_MESH GLB_ACCESSORS GLB_VIEWS
               ",\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}]}"),
           MT_MESH_GLB, 4, 1);
}

/* Nodes scale, move, turn and mirror; what is mirrored still faces outwards. */
static void nodes_place_meshes(void **state) {
    (void)state;
    static const struct {
        const char *nodes;
        int triangles;
        double volume;
    } cases[] = {
        {"\"scenes\":[{\"nodes\":[1]}],\"nodes\":[{\"mesh\":0,\"scale\":[2,3,-1]},{\"children\":[0],"
         "\"translation\":[5,0,0]}]",
         4, 6},
        {"\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[{\"mesh\":0},{\"mesh\":0,\"matrix\":[2,0,0,0,0,2,0,0,0,0,"
         "2,0,9,9,9,1]}]",
         8, 9},
        {"\"scene\":1,\"scenes\":[{},{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"rotation\":[0,0,0.6,0.8]}]", 4,
         1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char json[2048];
        snprintf(json, sizeof json, "%s%s}", GLB_ASSET GLB_MESH GLB_ACCESSORS GLB_VIEWS ",", cases[i].nodes);
        file given = glb(json);
        mt_arena arena = {0};
        mt_mesh mesh;
        mt_mesh_fault fault;
        mt_assert_ok(parse(&given, MT_MESH_GLB, &arena, &mesh, &fault));
        assert_int_equal(mesh.n_triangles, cases[i].triangles);
        assert_float_equal(volume6(&mesh), cases[i].volume, 1e-5);
        mt_arena_release(&arena);
    }
}

/* A prism over an L. */
static void polygons_are_cut_by_ears(void **state) {
    (void)state;
    expect(
        text_file("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 "
                  "1\nv 1 2 1\n"
                  "v 0 2 1\nf 6 5 4 3 2 1\nf 7 8 9 10 11 12\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\n"
                  "f 5 6 12 11\nf 6 1 7 12\n"),
        MT_MESH_OBJ, 20, 18);
}

/* Points that repeat, triangles without an area: twice the same corner, and three in a line. */
static void doubles_and_slivers_go(void **state) {
    (void)state;
    expect(text_file(OBJ_POINTS "v 0 0 0\nf 5 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nf 1 5 4\n"), MT_MESH_OBJ, 4, 1);
    /* The edge from 1 to 2 has a point in its middle on one side, and a sliver closes the gap. */
    expect(text_file(
               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv .5 0 0\nf 1 3 5\nf 5 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
               "f 2 1 5\n"),
           MT_MESH_OBJ, 6, 1);
}

static void shells_are_turned(void **state) {
    (void)state;
    static const char outer[] = "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\n",
                      inner[] = "v 1 1 1\nv 2 1 1\nv 1 2 1\nv 1 1 2\n";
    static const char out[] = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n",
                      in[] = "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 1 3 4\n";
    static const char hollow[] = "f 5 6 7\nf 5 8 6\nf 6 8 7\nf 5 7 8\n",
                      lump[] = "f 5 7 6\nf 5 6 8\nf 6 7 8\nf 5 8 7\n";
    char text[512];
    mt_arena arena = {0};
    mt_mesh mesh;
    mt_mesh_fault fault;
    expect(text_file("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 1 3 4\n"), MT_MESH_OBJ,
           4, 1);
    for (int i = 0; i < 2; i++) { /* as it should be, and the whole turned inside out */
        snprintf(text, sizeof text, "%s%s%s%s", outer, inner, i ? in : out, i ? lump : hollow);
        file given = text_file(text);
        mt_assert_ok(parse(&given, MT_MESH_OBJ, &arena, &mesh, &fault));
        assert_float_equal(volume6(&mesh), 728, 1e-9);
    }
    snprintf(text, sizeof text, "%s%s%s%s", outer, inner, out, lump);
    file given = text_file(text);
    assert_int_equal(parse(&given, MT_MESH_OBJ, &arena, &mesh, &fault), MT_NOT_SOLID);
    assert_non_null(strstr(fault.line, "stands inside another"));
    mt_arena_release(&arena);
}

/* ---- faults --------------------------------------------------------------------------------------------- */

static void refuse(file given, mt_mesh_format format, mt_status status, const char *says) {
    mt_arena arena = {0};
    mt_mesh mesh;
    mt_mesh_fault fault;
    mt_status got = parse(&given, format, &arena, &mesh, &fault);
    if (got != status || !strstr(fault.line, says))
        print_error("\"%s\" in place of \"%s\" for: %.200s\n", fault.line, says, (const char *)given.bytes);
    assert_int_equal(got, status);
    assert_non_null(strstr(fault.line, says));
    mt_arena_release(&arena);
}

static void what_is_no_solid_is_refused_with_its_place(void **state) {
    (void)state;
    static const struct {
        const char *text, *says;
        mt_status status;
    } cases[] = {
        {"", "no triangles", MT_NOT_SOLID},
        {OBJ_POINTS, "no triangles", MT_NOT_SOLID},
        {OBJ_POINTS "f 1 3 2\nf 1 2 4\nf 2 3 4\n", "the edge from (0, 0, 0) to (0, 0, 1) has one triangle",
         MT_NOT_SOLID},
        {OBJ_POINTS "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 3 4\n", "face opposite sides", MT_NOT_SOLID},
        {OBJ_POINTS
         "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nv 1 1 -1\nv 0 0 -1\nf 1 2 5\nf 1 5 6\nf 2 6 5\nf 1 6 2\n",
         "from (0, 0, 0) to (1, 0, 0) has 4 triangles", MT_NOT_SOLID},
        {OBJ_POINTS "f 1 2 3\nf 1 3 2\n", "cross or touch", MT_NOT_SOLID},
        {OBJ_POINTS
         "v .2 .2 .2\nv 3 .2 .2\nv .2 3 .2\nv .2 .2 3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nf 5 7 6\nf 5 6 8\n"
         "f 6 7 8\nf 5 8 7\n",
         "cross or touch", MT_NOT_SOLID},
        {"v 1 1 1\nf 1 1 1\n", "none of its triangles has an area", MT_NOT_SOLID},
        {"v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\nf 3 2 1\n", "none of its triangles has an area", MT_NOT_SOLID},
        {"v nan 0 0\n", "line 1: v wants three numbers", MT_BAD_MESH},
        {"v 0 0\n", "line 1: v wants three numbers", MT_BAD_MESH},
        {"v 0 0 2e9\n", "point 1 has a coordinate", MT_BAD_MESH},
        {OBJ_POINTS "f 1 2\n", "polygon 1 has 2 corners", MT_BAD_MESH},
        {OBJ_POINTS "f 1 2 5\n", "polygon 1 has a corner at no point", MT_BAD_MESH},
        {OBJ_POINTS "f 1 2 0\n", "line 5: f wants numbers of points", MT_BAD_MESH},
        {OBJ_POINTS "f 1 2 -5\n", "line 5: f wants numbers of points", MT_BAD_MESH},
        {OBJ_POINTS "f 1 2 x\n", "line 5: f wants numbers of points", MT_BAD_MESH},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        refuse(text_file(cases[i].text), MT_MESH_OBJ, cases[i].status, cases[i].says);
}

/* A cube with a pit, whose deepest point lies near the bottom. */
#define PIT(height)                                                                                          \
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv .4 .3 " height                \
    "\nf 1 4 3 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 5 6 9\nf 6 7 9\nf 7 8 9\nf 8 5 9\n"

static void a_slip_between_neighbours_is_no_crossing(void **state) {
    (void)state;
    static const char *const solids[] = {PIT("1e-4"), PIT("-1e-4")};
    static const char *const crossing[] = {PIT("0"), PIT("-1e-2")};
    for (int i = 0; i < 2; i++) {
        mt_arena arena = {0};
        mt_mesh mesh;
        mt_mesh_fault fault;
        file given = text_file(solids[i]);
        mt_assert_ok(parse(&given, MT_MESH_OBJ, &arena, &mesh, &fault));
        assert_int_equal(mesh.n_triangles, 14);
        mt_arena_release(&arena);
        refuse(text_file(crossing[i]), MT_MESH_OBJ, MT_NOT_SOLID, "cross or touch");
    }
}

static void damaged_files_are_refused(void **state) {
    (void)state;
    file stl = binary_stl();
    stl.length -= 60;
    refuse(stl, MT_MESH_STL, MT_BAD_MESH, "4 triangles are told, 2 are there");
    memcpy(stl.bytes + 80, "\x40\x42\x0f\0", 4);
    refuse(stl, MT_MESH_STL, MT_TOO_LARGE, "1000000 triangles");
    stl = binary_stl();
    memcpy(stl.bytes + 96, "\0\0\xc0\x7f", 4);
    refuse(stl, MT_MESH_STL, MT_BAD_MESH, "point 1 has a coordinate");
    refuse(text_file("x"), MT_MESH_STL, MT_BAD_MESH, "no STL");
    refuse(text_file("solid\nvertex 0 0 0\n"), MT_MESH_STL, MT_BAD_MESH, "does not end");
    refuse(text_file("solid\nvertex 0 0 0\nvertex 0 0 1\nendloop\n"), MT_MESH_STL, MT_BAD_MESH,
           "a facet of 2 vertices");
    refuse(text_file("ply\n"), MT_MESH_PLY, MT_BAD_MESH, "the header does not end");
    refuse(text_file("plx\n"), MT_MESH_PLY, MT_BAD_MESH, "no PLY");
    refuse(text_file("ply\nproperty float x\n"), MT_MESH_PLY, MT_BAD_MESH, "without an element");
    refuse(text_file("ply\nelement vertex 1\nproperty list float int x\n"), MT_MESH_PLY, MT_BAD_MESH,
           "malformed property");
    refuse(text_file("ply\nelement face 1000000\n"), MT_MESH_PLY, MT_TOO_LARGE, "1000000 triangles");
    file ply = binary_ply(true);
    ply.length -= 5;
    refuse(ply, MT_MESH_PLY, MT_BAD_MESH, "cut short");
    refuse(text_file("OFF\n4 4\n0 0 0\n"), MT_MESH_OFF, MT_BAD_MESH,
           "4 points and 4 polygons are told, 1 lines are there");
    refuse(text_file("OFF\n-1 4\n"), MT_MESH_OFF, MT_BAD_MESH, "line 2: no counts");
    refuse(text_file("OFF"), MT_MESH_OFF, MT_BAD_MESH, "no counts");
    refuse(text_file("4OFF\n1 1 1\n"), MT_MESH_OFF, MT_BAD_MESH, "line 1: no counts");
}

#define GLB_REST GLB_ACCESSORS GLB_VIEWS ",\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}]}"

static void what_glb_does_not_hold_is_named(void **state) {
    (void)state;
    static const char *const cases[][2] = {
        {"", "damaged"},
        {"{\"asset\":{\"version\":\"1.0\"}}", "version 2"},
        {GLB_ASSET "\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]}", "KHR_draco_mesh_compression"},
        {GLB_ASSET "\"extensionsRequired\":[7]}", "no name"},
        {GLB_ASSET "\"scenes\":[]}", "no scene"},
        {GLB_ASSET "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"children\":[0]}]}", "below itself"},
        {GLB_ASSET "\"scenes\":[{\"nodes\":[3]}],\"nodes\":[{}]}", "a node is not there"},
        {GLB_ASSET "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":4}]}", "a mesh that is not there"},
        {GLB_ASSET GLB_MESH
         "\"accessors\":[{\"sparse\":{},\"componentType\":5126,\"type\":\"VEC3\",\"count\":4}],"
         "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}]}",
         "sparse"},
        {GLB_ASSET GLB_MESH GLB_ACCESSORS "\"bufferViews\":[{\"buffer\":0,\"byteLength\":48}],\"buffers\":[{"
                                          "\"uri\":\"a.bin\",\"byteLength\":60}],"
                                          "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}]}",
         "outside of its binary chunk"},
        {GLB_ASSET GLB_MESH GLB_ACCESSORS
         "\"bufferViews\":[{\"buffer\":0,\"byteLength\":44}],\"buffers\":[{\"byteLength\":60}],"
         "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}]}",
         "larger than its buffer view"},
        {GLB_ASSET GLB_MESH GLB_ACCESSORS "\"bufferViews\":[{\"buffer\":0,\"byteOffset\":2147483647,"
                                          "\"byteLength\":48}],\"buffers\":[{\"byteLength\":60}],"
                                          "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}]}",
         "larger than its buffer"},
        {GLB_ASSET "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":1}}]}]," GLB_REST, "not read"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        refuse(glb(cases[i][0]), MT_MESH_GLB, MT_BAD_MESH, cases[i][1]);
    refuse(glb(GLB_ASSET "\"meshes\":[{\"primitives\":[{\"mode\":1}]}]," GLB_REST), MT_MESH_GLB, MT_NOT_SOLID,
           "no triangles");
    file cut = glb(GLB_ASSET GLB_MESH GLB_REST);
    cut.length -= 1;
    refuse(cut, MT_MESH_GLB, MT_BAD_MESH, "cut short");
}

/* A file that ends anywhere, and one with any of its bytes changed, is read or refused. */
static void any_damage_ends_in_a_status(void **state) {
    (void)state;
    const file files[] = {binary_stl(), binary_ply(true), glb(GLB_ASSET GLB_MESH GLB_REST)};
    static const mt_mesh_format formats[] = {MT_MESH_STL, MT_MESH_PLY, MT_MESH_GLB};
    mt_arena arena = {0};
    mt_mesh mesh;
    mt_mesh_fault fault;
    for (int f = 0; f < 3; f++)
        for (size_t i = 0; i < files[f].length; i++) {
            file cut = files[f], changed = files[f];
            cut.length = i;
            changed.bytes[i] = (uint8_t)(changed.bytes[i] * 7 + 129);
            assert_int_not_equal(parse(&cut, formats[f], &arena, &mesh, &fault), MT_OK);
            (void)parse(&changed, formats[f], &arena, &mesh, &fault);
            mt_arena_reset(&arena);
        }
    mt_arena_release(&arena);
}

static mt_status read_twice(void) {
    file given = glb(GLB_ASSET GLB_MESH GLB_REST),
         text = text_file(OBJ_POINTS "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    mt_arena arena = {0};
    mt_mesh mesh, checked;
    mt_mesh_fault fault;
    mt_status status = mt_mesh_parse(given.bytes, given.length, MT_MESH_GLB, &arena, &mesh, &fault);
    if (status == MT_OK) status = mt_mesh_parse(text.bytes, text.length, MT_MESH_OBJ, &arena, &mesh, &fault);
    if (status == MT_OK) status = mt_mesh_check(&mesh, &arena, &checked, &fault);
    mt_arena_release(&arena);
    return status;
}

static void survives_want_of_memory(void **state) {
    (void)state;
    mt_test_want_of_memory(read_twice);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_format_gives_the_same_solid),
        cmocka_unit_test(nodes_place_meshes),
        cmocka_unit_test(polygons_are_cut_by_ears),
        cmocka_unit_test(doubles_and_slivers_go),
        cmocka_unit_test(shells_are_turned),
        cmocka_unit_test(what_is_no_solid_is_refused_with_its_place),
        cmocka_unit_test(a_slip_between_neighbours_is_no_crossing),
        cmocka_unit_test(damaged_files_are_refused),
        cmocka_unit_test(what_glb_does_not_hold_is_named),
        cmocka_unit_test(any_damage_ends_in_a_status),
        cmocka_unit_test(survives_want_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
