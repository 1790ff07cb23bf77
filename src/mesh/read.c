#include "mesh/read.h"

#include <errno.h>
#include <string.h>
#include <strings.h>

#include "base/file.h"
#include "mesh/crossing.h"
#include "mesh/formats.h"
#include "mesh/limits.h"
#include "mesh/shells.h"
#include "mesh/weld.h"

bool mt_mesh_format_of(const char *path, mt_mesh_format *format) {
    static const char *const extensions[] = {".obj", ".stl", ".ply", ".off", ".glb"};
    const char *dot = strrchr(path, '.');
    for (int i = 0; dot && i < 5; i++) {
        if (strcasecmp(dot, extensions[i]) != 0) continue;
        *format = (mt_mesh_format)i;
        return true;
    }
    return false;
}

/* ---- from a draft to a solid ---------------------------------------------------------------------------- */

/* Leaves out points that no triangle has. */
static mt_status gather_points(mt_mesh *mesh, mt_arena *arena) {
    int *number = mt_arena_new(arena, (size_t)mesh->n_points, sizeof *number), n = 0;
    if (!number) return MT_NO_MEMORY;
    for (int i = 0; i < 3 * mesh->n_triangles; i++) number[mesh->triangles[i / 3].at[i % 3]] = 1;
    for (int i = 0; i < mesh->n_points; i++) {
        if (!number[i]) continue;
        mesh->points[n] = mesh->points[i];
        number[i] = n++;
    }
    for (int i = 0; i < 3 * mesh->n_triangles; i++) {
        int *at = &mesh->triangles[i / 3].at[i % 3];
        *at = number[*at];
    }
    mesh->n_points = n;
    return MT_OK;
}

static mt_status make_surface(mt_grid_mesh *grid, mt_arena *arena, mt_mesh_fault *fault,
                              mt_surface *surface) {
    int removed = 0;
    mt_status status = mt_surface_make(grid, arena, fault, surface);
    if (status == MT_OK) status = mt_surface_remove_slivers(surface, fault, &removed);
    if (status == MT_OK && removed > 0) status = mt_surface_make(grid, arena, fault, surface);
    return status;
}

static mt_status check_draft(const mt_draft *draft, mt_arena *arena, mt_mesh *mesh) {
    mt_grid_mesh grid;
    mt_surface surface;
    mt_status status = mt_draft_end(draft);
    if (status == MT_OK) status = mt_grid_weld(draft, arena, &grid);
    if (status == MT_OK) status = make_surface(&grid, arena, draft->fault, &surface);
    if (status == MT_OK) status = mt_surface_check_crossings(&surface, arena, draft->fault);
    if (status == MT_OK) status = mt_surface_turn_shells(&surface, arena, draft->fault);
    if (status == MT_OK) status = gather_points(&grid.mesh, arena);
    if (status == MT_OK) *mesh = grid.mesh;
    return status;
}

/* ---- where drafts come from ------------------------------------------------------------------------------ */

static mt_status read_draft(uint8_t *bytes, size_t length, mt_mesh_format format, mt_draft *draft) {
    switch (format) {
    case MT_MESH_OBJ: return mt_read_obj(bytes, length, draft);
    case MT_MESH_STL: return mt_read_stl(bytes, length, draft);
    case MT_MESH_PLY: return mt_read_ply(bytes, length, draft);
    case MT_MESH_OFF: return mt_read_off(bytes, length, draft);
    default: return mt_read_glb(bytes, length, draft);
    }
}

mt_status mt_mesh_parse(uint8_t *bytes, size_t length, mt_mesh_format format, mt_arena *arena, mt_mesh *mesh,
                        mt_mesh_fault *fault) {
    mt_draft draft = {.fault = fault};
    fault->line[0] = '\0';
    mt_status status = read_draft(bytes, length, format, &draft);
    if (status == MT_OK) status = check_draft(&draft, arena, mesh);
    mt_draft_free(&draft);
    return status;
}

mt_status mt_mesh_read(const char *path, mt_arena *arena, mt_mesh *mesh, mt_mesh_fault *fault) {
    mt_mesh_format format;
    uint8_t *bytes;
    size_t length;
    fault->line[0] = '\0';
    if (!mt_mesh_format_of(path, &format)) return MT_UNKNOWN_FORMAT;
    mt_status status = mt_file_read(path, MT_MESH_BYTES_MAX, &bytes, &length);
    if (status == MT_TOO_LARGE) return mt_mesh_say(fault, status, "over %zu MB", MT_MESH_BYTES_MAX >> 20);
    if (status != MT_OK) return status;
    status = mt_mesh_parse(bytes, length, format, arena, mesh, fault);
    mt_free(bytes);
    return status;
}

mt_status mt_mesh_check(const mt_mesh *given, mt_arena *arena, mt_mesh *mesh, mt_mesh_fault *fault) {
    mt_draft draft = {.fault = fault};
    fault->line[0] = '\0';
    mt_status status = mt_draft_expect(&draft, given->n_triangles);
    for (int i = 0; i < given->n_points && status == MT_OK; i++)
        status = mt_draft_point(&draft, given->points[i].x, given->points[i].y, given->points[i].z);
    for (int i = 0; i < given->n_triangles && status == MT_OK; i++)
        status = mt_draft_polygon(&draft, given->triangles[i].at, 3);
    if (status == MT_OK) status = check_draft(&draft, arena, mesh);
    mt_draft_free(&draft);
    return status;
}
