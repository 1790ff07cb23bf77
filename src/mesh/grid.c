#include "mesh/grid.h"

#include <math.h>
#include <stdlib.h>

#include "mesh/limits.h"
#include "mesh/polygon.h"

/* ---- predicates ---------------------------------------------------------------------------------------- */

int mt_grid_side(mt_grid_point a, mt_grid_point b, mt_grid_point c, mt_grid_point d) {
    double ax = a.x - d.x, ay = a.y - d.y, az = a.z - d.z, bx = b.x - d.x, by = b.y - d.y, bz = b.z - d.z,
           cx = c.x - d.x, cy = c.y - d.y, cz = c.z - d.z;
    double sum = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
    /* Six products under 2^66, each rounded three times by 2^-53 at most: off by less than 2^18. */
    if (sum > 262144 || sum < -262144) return sum > 0 ? 1 : -1;
    mt_grid_normal n = mt_grid_normal_of(d, b, c);
    mt_int128 whole = (mt_int128)(a.x - d.x) * n.x + (mt_int128)(a.y - d.y) * n.y + (mt_int128)(a.z - d.z) * n.z;
    return whole > 0 ? 1 : whole < 0 ? -1 : 0;
}

mt_grid_normal mt_grid_normal_of(mt_grid_point a, mt_grid_point b, mt_grid_point c) {
    int64_t bx = b.x - a.x, by = b.y - a.y, bz = b.z - a.z, cx = c.x - a.x, cy = c.y - a.y, cz = c.z - a.z;
    return (mt_grid_normal){by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx};
}

mt_grid_flat mt_grid_drop(mt_grid_point point, mt_grid_normal normal) {
    int64_t x = llabs(normal.x), y = llabs(normal.y), z = llabs(normal.z);
    mt_grid_flat flat = {point.x, point.y};
    bool turned = normal.z < 0;
    if (x >= y && x >= z) {
        flat = (mt_grid_flat){point.y, point.z};
        turned = normal.x < 0;
    } else if (y >= z) {
        flat = (mt_grid_flat){point.z, point.x};
        turned = normal.y < 0;
    }
    return turned ? (mt_grid_flat){flat.y, flat.x} : flat;
}

int mt_grid_turn(mt_grid_flat a, mt_grid_flat b, mt_grid_flat c) {
    int64_t turn = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    return (turn > 0) - (turn < 0);
}

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
