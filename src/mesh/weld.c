#include "mesh/weld.h"

#include <math.h>
#include <stdlib.h>

#include "mesh/limits.h"
#include "mesh/polygon.h"

/* ---- points -------------------------------------------------------------------------------------------- */

typedef struct mt_snapped {
    mt_grid_point at;
    int point; /* of the draft */
} mt_snapped;

static int compare(const void *left, const void *right) {
    const mt_snapped *a = left, *b = right;
    if (a->at.x != b->at.x) return a->at.x < b->at.x ? -1 : 1;
    if (a->at.y != b->at.y) return a->at.y < b->at.y ? -1 : 1;
    if (a->at.z != b->at.z) return a->at.z < b->at.z ? -1 : 1;
    return (a->point > b->point) - (a->point < b->point);
}

/* Whether a polygon has the point. */
static bool *find_used(const mt_draft *draft, mt_arena *arena) {
    bool *used = mt_arena_new(arena, (size_t)draft->n_points, sizeof *used);
    for (int i = 0; used && i < draft->n_corners; i++) used[draft->corners[i]] = true;
    return used;
}

/* The lowest corner of the box around all points that are used, and its longest side. */
static double measure(const mt_draft *draft, const bool *used, mt_vector3 *low) {
    mt_vector3 high = {-INFINITY, -INFINITY, -INFINITY};
    *low = (mt_vector3){INFINITY, INFINITY, INFINITY};
    for (int i = 0; i < draft->n_points; i++) {
        mt_vector3 p = draft->points[i];
        if (!used[i]) continue;
        *low = (mt_vector3){fmin(low->x, p.x), fmin(low->y, p.y), fmin(low->z, p.z)};
        high = (mt_vector3){fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z)};
    }
    return fmax(fmax(high.x - low->x, high.y - low->y), high.z - low->z);
}

/* Lists the points that are used, sorted by their places on the grid; how many. */
static int snap(const mt_draft *draft, const bool *used, mt_snapped *list) {
    mt_vector3 low;
    double side = measure(draft, used, &low), scale = side >= MT_MESH_SIDE_MIN ? MT_GRID_CELLS / side : 0;
    int count = 0;
    for (int i = 0; i < draft->n_points; i++) {
        mt_vector3 p = draft->points[i];
        if (!used[i]) continue;
        mt_grid_point at = {(int32_t)lround((p.x - low.x) * scale), (int32_t)lround((p.y - low.y) * scale),
                            (int32_t)lround((p.z - low.z) * scale)};
        list[count++] = (mt_snapped){at, i};
    }
    qsort(list, (size_t)count, sizeof *list, compare);
    return count;
}

static bool same_place(mt_grid_point a, mt_grid_point b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* `welded` has for each point of the draft that of the grid. */
static mt_status weld_points(const mt_draft *draft, mt_arena *arena, int *welded, mt_grid_mesh *grid) {
    size_t room = (size_t)draft->n_points;
    bool *used = find_used(draft, arena);
    mt_snapped *list = mt_arena_new(arena, room, sizeof *list);
    grid->at = mt_arena_new(arena, room, sizeof *grid->at);
    grid->mesh.points = mt_arena_new(arena, room, sizeof *grid->mesh.points);
    if (!used || !list || !grid->at || !grid->mesh.points) return MT_NO_MEMORY;
    int count = snap(draft, used, list), n = 0;
    for (int i = 0; i < count; i++) {
        if (n == 0 || !same_place(grid->at[n - 1], list[i].at)) {
            grid->at[n] = list[i].at;
            grid->mesh.points[n++] = draft->points[list[i].point];
        }
        welded[list[i].point] = n - 1;
    }
    grid->mesh.n_points = n;
    return MT_OK;
}

/* ---- triangles ----------------------------------------------------------------------------------------- */

/* The polygon's corners on the grid, without those that repeat the one before. */
static int weld_polygon(const mt_draft *draft, const int *welded, int begin, int end, int *corners) {
    int count = 0;
    for (int i = begin; i < end; i++) {
        int corner = welded[draft->corners[i]];
        if (count == 0 || corners[count - 1] != corner) corners[count++] = corner;
    }
    while (count > 1 && corners[count - 1] == corners[0]) count--;
    return count;
}

static mt_status make_triangles(const mt_draft *draft, mt_arena *arena, const int *welded,
                                mt_grid_mesh *grid) {
    int corners[MT_MESH_CORNERS_MAX];
    int64_t work = 0;
    size_t room = (size_t)(draft->n_corners - 2 * draft->n_polygons);
    grid->mesh.triangles = mt_arena_new(arena, room, sizeof *grid->mesh.triangles);
    if (!grid->mesh.triangles) return MT_NO_MEMORY;
    for (int i = 0, begin = 0; i < draft->n_polygons; begin = draft->ends[i++]) {
        int count = weld_polygon(draft, welded, begin, draft->ends[i], corners);
        mt_triangle *made = grid->mesh.triangles + grid->mesh.n_triangles;
        grid->mesh.n_triangles += mt_polygon_triangles(grid->at, corners, count, made, &work);
        if (work > MT_POLYGON_WORK_MAX)
            return mt_mesh_say(draft->fault, MT_TOO_LARGE, "polygon %d has too intricate an outline", i + 1);
    }
    return MT_OK;
}

mt_status mt_grid_weld(const mt_draft *draft, mt_arena *arena, mt_grid_mesh *grid) {
    *grid = (mt_grid_mesh){0};
    if (draft->n_polygons == 0) return mt_mesh_say(draft->fault, MT_NOT_SOLID, "it has no triangles");
    int *welded = mt_arena_new(arena, (size_t)draft->n_points, sizeof *welded);
    mt_status status = welded ? weld_points(draft, arena, welded, grid) : MT_NO_MEMORY;
    if (status == MT_OK) status = make_triangles(draft, arena, welded, grid);
    if (status == MT_OK && grid->mesh.n_triangles == 0)
        status = mt_mesh_say(draft->fault, MT_NOT_SOLID, "none of its triangles has an area");
    return status;
}
