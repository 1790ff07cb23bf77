#include "mesh/solid_blend.h"

#include <errno.h>
#include <math.h>
#include <string.h>

#include "arithmetic/angles.h"
#include "base/file.h"
#include "mesh/glb_write.h"
#include "mesh/read.h"
#include "mesh/write.h"

/* ---- solids --------------------------------------------------------------------------------------------- */

typedef mt_status (*mt_mesh_maker)(const void *from, mt_arena *arena, mt_mesh *mesh, mt_mesh_fault *fault);

static mt_status make_from_file(const void *path, mt_arena *arena, mt_mesh *mesh, mt_mesh_fault *fault) {
    return mt_mesh_read(path, arena, mesh, fault);
}

static mt_status make_from_mesh(const void *given, mt_arena *arena, mt_mesh *mesh, mt_mesh_fault *fault) {
    return mt_mesh_check(given, arena, mesh, fault);
}

static mt_status make_solid(mt_mesh_maker make, const void *from, mt_solid **solid, mt_mesh_fault *fault) {
    mt_mesh_fault own;
    mt_solid *made = mt_new(1, sizeof *made);
    if (fault) fault->line[0] = '\0';
    if (!made) return MT_NO_MEMORY;
    mt_status status = make(from, &made->arena, &made->mesh, fault ? fault : &own);
    int why = errno;
    if (status == MT_OK)
        *solid = made;
    else
        mt_solid_free(made);
    errno = why;
    return status;
}

mt_status mt_solid_open(const char *path, mt_solid **solid, mt_mesh_fault *fault) {
    return make_solid(make_from_file, path, solid, fault);
}

mt_status mt_solid_new(const mt_mesh *mesh, mt_solid **solid, mt_mesh_fault *fault) {
    return make_solid(make_from_mesh, mesh, solid, fault);
}

const mt_mesh *mt_solid_mesh(const mt_solid *solid) {
    return &solid->mesh;
}

void mt_solid_free(mt_solid *solid) {
    if (!solid) return;
    mt_arena_release(&solid->arena);
    mt_free(solid);
}

/* ---- blends --------------------------------------------------------------------------------------------- */

#define DEPTH 0.03

mt_solid_params mt_solid_params_default(void) {
    return (mt_solid_params){.method = MT_METHOD_JOINT, .depth = DEPTH, .axis = {0, 1, 0}};
}

/* Checks the parameters, and makes the axis one of length 1. */
static bool take_params(const mt_solid_params *given, mt_solid_params *params) {
    double length = mt_hypot(mt_hypot(given->axis.x, given->axis.y), given->axis.z);
    bool known = given->method == MT_METHOD_JOINT || given->method == MT_METHOD_PAPER;
    bool good = known && given->depth >= MT_SOLID_DEPTH_MIN && given->depth <= MT_SOLID_DEPTH_MAX &&
                fabs(given->degrees) <= 360 && isfinite(length) && length > 0;
    *params = *given;
    params->axis = (mt_vector3){given->axis.x / length, given->axis.y / length, given->axis.z / length};
    return good;
}

static void fill_mesh(const mt_mesh *mesh, mt_mesh *copy) {
    memcpy(copy->points, mesh->points, (size_t)mesh->n_points * sizeof *copy->points);
    memcpy(copy->triangles, mesh->triangles, (size_t)mesh->n_triangles * sizeof *copy->triangles);
}

static mt_status copy_mesh(const mt_mesh *mesh, mt_arena *arena, mt_mesh *copy) {
    copy->points = mt_arena_new(arena, (size_t)mesh->n_points, sizeof *copy->points);
    copy->triangles = mt_arena_new(arena, (size_t)mesh->n_triangles, sizeof *copy->triangles);
    if (!copy->points || !copy->triangles) return MT_NO_MEMORY;
    fill_mesh(mesh, copy);
    copy->n_points = mesh->n_points;
    copy->n_triangles = mesh->n_triangles;
    return MT_OK;
}

mt_status mt_solid_blend_new(const mt_solid *a, const mt_solid *b, const mt_solid_params *params,
                             mt_solid_blend **blend) {
    mt_solid_blend *made = mt_new(1, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    mt_status status = take_params(params, &made->params) ? MT_OK : MT_BAD_PARAMETER;
    if (status == MT_OK) status = copy_mesh(&a->mesh, &made->arena, &made->a);
    if (status == MT_OK) status = copy_mesh(&b->mesh, &made->arena, &made->b);
    if (status == MT_OK)
        status = mt_solid_prepare(&made->arena, &made->a, &made->b, &made->params, &made->morph);
    if (status == MT_OK)
        *blend = made;
    else
        mt_solid_blend_free(made);
    return status;
}

void mt_solid_blend_free(mt_solid_blend *blend) {
    if (!blend) return;
    mt_arena_release(&blend->arena);
    mt_free(blend);
}

mt_status mt_solid_blend_at(const mt_solid_blend *blend, double t, mt_arena *arena, mt_mesh *mesh) {
    if (!(t >= 0 && t <= 1)) return MT_BAD_PARAMETER;
    if (t == 0 || t == 1) return copy_mesh(t == 0 ? &blend->a : &blend->b, arena, mesh);
    return mt_solid_at(arena, &blend->morph, 1 - t, mesh);
}

/* ---- meshes out ----------------------------------------------------------------------------------------- */

/* A copy that outlives the arena. */
static mt_status own_mesh(const mt_mesh *mesh, mt_mesh *own) {
    mt_mesh copy = *mesh;
    copy.points = mt_new((size_t)mesh->n_points, sizeof *copy.points);
    copy.triangles = mt_new((size_t)mesh->n_triangles, sizeof *copy.triangles);
    if (!copy.points || !copy.triangles) {
        mt_mesh_free(&copy);
        return MT_NO_MEMORY;
    }
    fill_mesh(mesh, &copy);
    *own = copy;
    return MT_OK;
}

mt_status mt_solid_blend_mesh(const mt_solid_blend *blend, double t, mt_mesh *mesh) {
    mt_arena arena = {0};
    mt_mesh made;
    mt_status status = mt_solid_blend_at(blend, t, &arena, &made);
    if (status == MT_OK) status = own_mesh(&made, mesh);
    mt_arena_release(&arena);
    return status;
}

void mt_mesh_free(mt_mesh *mesh) {
    mt_free(mesh->points);
    mt_free(mesh->triangles);
    *mesh = (mt_mesh){0};
}

/* Writes what was made with `status`. */
static mt_status save(mt_status status, mt_buffer *file, const char *path) {
    if (status == MT_OK) status = mt_file_write(path, file->bytes, file->length);
    int why = errno;
    mt_buffer_free(file);
    errno = why;
    return status;
}

mt_status mt_solid_blend_save(const mt_solid_blend *blend, double t, const char *path) {
    mt_mesh_format format;
    mt_arena arena = {0};
    mt_mesh mesh;
    mt_buffer file = {0};
    if (!mt_mesh_format_of(path, &format)) return MT_UNKNOWN_FORMAT;
    mt_status status = mt_solid_blend_at(blend, t, &arena, &mesh);
    if (status == MT_OK) status = mt_mesh_write(&mesh, format, &file);
    mt_arena_release(&arena);
    return save(status, &file, path);
}

/* ---- the morph as a target ------------------------------------------------------------------------------ */

/* All links as one mesh that moves. */
static mt_status join_links(const mt_solid_morph *morph, mt_arena *arena, mt_glb_content *content) {
    size_t points = 0, triangles = 0;
    for (int i = 0; i < morph->n_links; i++) {
        points += (size_t)morph->links[i].n_points;
        triangles += (size_t)morph->links[i].n_triangles;
    }
    if (points > INT32_MAX / 32 || triangles > INT32_MAX / 32) return MT_TOO_LARGE;
    mt_vector3 *at_a = mt_arena_new(arena, points, sizeof *at_a),
               *at_b = mt_arena_new(arena, points, sizeof *at_b);
    mt_triangle *list = mt_arena_new(arena, triangles, sizeof *list);
    if (!at_a || !at_b || !list) return MT_NO_MEMORY;
    for (int i = 0, point = 0, triangle = 0; i < morph->n_links; i++) {
        const mt_solid_link *link = &morph->links[i];
        for (int k = 0; k < link->n_triangles; k++, triangle++)
            for (int c = 0; c < 3; c++) list[triangle].at[c] = link->triangles[k].at[c] + point;
        for (int k = 0; k < link->n_points; k++, point++) {
            at_a[point] = link->at_a[k];
            at_b[point] = link->at_b[k];
        }
    }
    content->n_points = (int)points;
    content->n_triangles = (int)triangles;
    content->at_a = at_a;
    content->at_b = at_b;
    content->triangles = list;
    return MT_OK;
}

mt_status mt_solid_blend_glb(const mt_solid_blend *blend, double duration, bool yoyo, mt_buffer *file) {
    const mt_solid_morph *morph = &blend->morph;
    mt_arena arena = {0};
    mt_glb_content content = {.duration = duration,
                              .yoyo = yoyo,
                              .degrees = morph->degrees,
                              .axis = morph->axis,
                              .middle_a = morph->middle_a,
                              .middle_b = morph->middle_b};
    mt_status status = join_links(morph, &arena, &content);
    if (status == MT_OK) status = mt_glb_write(&content, file);
    mt_arena_release(&arena);
    return status;
}

mt_status mt_solid_blend_save_morph(const mt_solid_blend *blend, double duration, bool yoyo,
                                    const char *path) {
    mt_mesh_format format;
    mt_buffer file = {0};
    if (!mt_mesh_format_of(path, &format) || format != MT_MESH_GLB) return MT_UNKNOWN_FORMAT;
    if (!(duration >= 0.01 && duration <= 600)) return MT_BAD_PARAMETER;
    mt_status status = mt_solid_blend_glb(blend, duration, yoyo, &file);
    return save(status, &file, path);
}
