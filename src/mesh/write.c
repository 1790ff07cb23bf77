#include "mesh/write.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/real.h"
#include "mesh/glb_write.h"

#define PROGRAM "Morphotype " MORPHOTYPE_VERSION

/* What has failed to grow takes nothing more. */
typedef struct mt_writing {
    mt_buffer *file;
    mt_status status;
} mt_writing;

static void add(mt_writing *w, const void *bytes, size_t length) {
    if (w->status == MT_OK) w->status = mt_buffer_add(w->file, bytes, length);
}

static void add_text(mt_writing *w, const char *text) {
    add(w, text, strlen(text));
}

/* ---- texts ---------------------------------------------------------------------------------------------- */

static void add_place(mt_writing *w, mt_vector3 p) {
    enum { DIGITS = 9 };
    const double at[3] = {p.x, p.y, p.z};
    for (int i = 0; i < 3; i++) {
        char number[MT_REAL_ROOM];
        mt_real_write(at[i], DIGITS, number);
        if (i > 0) add_text(w, " ");
        add_text(w, number);
    }
    add_text(w, "\n");
}

/* The points count from `first`. */
static void add_triangle(mt_writing *w, const char *before, mt_triangle t, int first) {
    char line[64];
    snprintf(line, sizeof line, "%s %d %d %d\n", before, t.at[0] + first, t.at[1] + first, t.at[2] + first);
    add_text(w, line);
}

static void write_obj(mt_writing *w, const mt_mesh *mesh) {
    add_text(w, "# " PROGRAM "\n");
    for (int i = 0; i < mesh->n_points; i++) {
        add_text(w, "v ");
        add_place(w, mesh->points[i]);
    }
    for (int i = 0; i < mesh->n_triangles; i++) add_triangle(w, "f", mesh->triangles[i], 1);
}

static void write_off(mt_writing *w, const mt_mesh *mesh) {
    char counts[64];
    snprintf(counts, sizeof counts, "OFF\n%d %d 0\n", mesh->n_points, mesh->n_triangles);
    add_text(w, counts);
    for (int i = 0; i < mesh->n_points; i++) add_place(w, mesh->points[i]);
    for (int i = 0; i < mesh->n_triangles; i++) add_triangle(w, "3", mesh->triangles[i], 0);
}

/* ---- binary --------------------------------------------------------------------------------------------- */

static void add_u32(mt_writing *w, uint32_t value) {
    const uint8_t bytes[4] = {(uint8_t)value, (uint8_t)(value >> 8), (uint8_t)(value >> 16),
                              (uint8_t)(value >> 24)};
    add(w, bytes, sizeof bytes);
}

static void add_floats(mt_writing *w, mt_vector3 v) {
    const float values[3] = {(float)v.x, (float)v.y, (float)v.z};
    for (int i = 0; i < 3; i++) {
        uint32_t bits;
        memcpy(&bits, &values[i], sizeof bits);
        add_u32(w, bits);
    }
}

/* Of length 1, or 0 where the triangle has no area. */
static mt_vector3 normal_of(const mt_mesh *mesh, mt_triangle t) {
    mt_vector3 a = mesh->points[t.at[0]], b = mesh->points[t.at[1]], c = mesh->points[t.at[2]];
    mt_vector3 u = {b.x - a.x, b.y - a.y, b.z - a.z}, v = {c.x - a.x, c.y - a.y, c.z - a.z};
    mt_vector3 n = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    double length = sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    return length > 0 ? (mt_vector3){n.x / length, n.y / length, n.z / length} : (mt_vector3){0};
}

static void write_stl(mt_writing *w, const mt_mesh *mesh) {
    const char header[80] = PROGRAM, attribute[2] = {0};
    add(w, header, sizeof header);
    add_u32(w, (uint32_t)mesh->n_triangles);
    for (int i = 0; i < mesh->n_triangles; i++) {
        mt_triangle t = mesh->triangles[i];
        add_floats(w, normal_of(mesh, t));
        for (int k = 0; k < 3; k++) add_floats(w, mesh->points[t.at[k]]);
        add(w, attribute, sizeof attribute);
    }
}

static void write_ply(mt_writing *w, const mt_mesh *mesh) {
    char header[256];
    const uint8_t three = 3;
    snprintf(header, sizeof header,
             "ply\nformat binary_little_endian 1.0\ncomment " PROGRAM
             "\nelement vertex %d\nproperty float x\n"
             "property float y\nproperty float z\nelement face %d\nproperty list uchar int vertex_indices\n"
             "end_header\n",
             mesh->n_points, mesh->n_triangles);
    add_text(w, header);
    for (int i = 0; i < mesh->n_points; i++) add_floats(w, mesh->points[i]);
    for (int i = 0; i < mesh->n_triangles; i++) {
        add(w, &three, 1);
        for (int k = 0; k < 3; k++) add_u32(w, (uint32_t)mesh->triangles[i].at[k]);
    }
}

mt_status mt_mesh_write(const mt_mesh *mesh, mt_mesh_format format, mt_buffer *file) {
    const mt_glb_content still = {.n_points = mesh->n_points,
                                  .n_triangles = mesh->n_triangles,
                                  .at_a = mesh->points,
                                  .triangles = mesh->triangles};
    mt_writing w = {file, MT_OK};
    *file = (mt_buffer){0};
    switch (format) {
    case MT_MESH_OBJ: write_obj(&w, mesh); break;
    case MT_MESH_STL: write_stl(&w, mesh); break;
    case MT_MESH_PLY: write_ply(&w, mesh); break;
    case MT_MESH_OFF: write_off(&w, mesh); break;
    default: return mt_glb_write(&still, file);
    }
    if (w.status != MT_OK) mt_buffer_free(file);
    return w.status;
}
