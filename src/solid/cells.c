/* Cells and their parts. Invariants: every wall has two different cells, or one and the outside; the walls around a cell are closed:
 * each edge is run along as often one way as the other. */
#include "solid/cells.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "arithmetic/angles.h"
#include "space/vector.h"

/* ---- from a mesh --------------------------------------------------------------------------------------- */

mt_vector3 mt_cells_place(const mt_cells *cells, int point) {
    if (point < cells->n_source) return cells->mesh->points[cells->source[point]];
    return mt_plus3(cells->origin, mt_times3(cells->unit, mt_place_vector(cells->points[point])));
}

/* The grid: some 2^24 units along the longest side of the box, its middle in the middle. */
static mt_status lay_grid(mt_cells *cells, const mt_mesh *mesh) {
    mt_vector3 low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < mesh->n_points; i++) {
        mt_vector3 p = mesh->points[i];
        if (!isfinite(p.x) || !isfinite(p.y) || !isfinite(p.z)) return MT_BAD_GEOMETRY;
        low = (mt_vector3){fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z)};
        high = (mt_vector3){fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z)};
    }
    mt_vector3 sides = mt_minus3(high, low);
    double longest = fmax(sides.x, fmax(sides.y, sides.z));
    if (!(longest > 0) || !isfinite(longest)) return MT_BAD_GEOMETRY;
    cells->origin = mt_between3(low, high, 0.5);
    cells->unit = longest / (2.0 * (MT_PLACE_MAX - 1));
    cells->diagonal = mt_length3(sides) / cells->unit;
    return cells->unit > 0 ? MT_OK : MT_BAD_GEOMETRY;
}

typedef struct mt_numbered_place {
    mt_place place;
    int number;
} mt_numbered_place;

static int by_place(const void *p, const void *q) {
    const mt_numbered_place *x = p, *y = q;
    mt_place a = x->place, b = y->place;
    if (a.x != b.x) return a.x < b.x ? -1 : 1;
    if (a.y != b.y) return a.y < b.y ? -1 : 1;
    if (a.z != b.z) return a.z < b.z ? -1 : 1;
    return (x->number > y->number) - (x->number < y->number);
}

/* Points on the grid, equal ones once; point_of: of each point of the mesh. */
static mt_status take_points(mt_cells *cells, const mt_mesh *mesh, int *point_of) {
    size_t n = (size_t)mesh->n_points;
    mt_numbered_place *sorted = mt_arena_new(cells->arena, n, sizeof *sorted);
    cells->points_room = mesh->n_points;
    cells->points = mt_arena_new(cells->arena, n, sizeof *cells->points);
    cells->source = mt_arena_new(cells->arena, n, sizeof *cells->source);
    if (!sorted || !cells->points || !cells->source) return MT_NO_MEMORY;
    for (int i = 0; i < mesh->n_points; i++) {
        mt_vector3 p = mt_times3(1 / cells->unit, mt_minus3(mesh->points[i], cells->origin));
        sorted[i] =
            (mt_numbered_place){{(int32_t)lround(p.x), (int32_t)lround(p.y), (int32_t)lround(p.z)}, i};
    }
    qsort(sorted, n, sizeof *sorted, by_place);
    for (int i = 0; i < mesh->n_points; i++) {
        if (i == 0 || !mt_place_equal(sorted[i].place, sorted[i - 1].place)) {
            cells->source[cells->n_points] = sorted[i].number;
            cells->points[cells->n_points++] = sorted[i].place;
        }
        point_of[sorted[i].number] = cells->n_points - 1;
    }
    cells->n_source = cells->n_points;
    return MT_OK;
}

static mt_status take_walls(mt_cells *cells, const mt_mesh *mesh, const int *point_of) {
    size_t n = (size_t)mesh->n_triangles;
    cells->walls_room = cells->planes_room = mesh->n_triangles;
    cells->walls = mt_arena_new(cells->arena, n, sizeof *cells->walls);
    cells->planes = mt_arena_new(cells->arena, n, sizeof *cells->planes);
    if (!cells->walls || !cells->planes) return MT_NO_MEMORY;
    for (int t = 0; t < mesh->n_triangles; t++) {
        const int *at = mesh->triangles[t].at;
        int a = point_of[at[0]], b = point_of[at[1]], c = point_of[at[2]];
        if (a == b || b == c || c == a) continue;
        const mt_place *p = cells->points;
        cells->planes[cells->n_planes] = mt_plane_through(p[a], p[b], p[c]);
        cells->walls[cells->n_walls++] = (mt_wall){{a, b, c}, 0, MT_OUTSIDE, cells->n_planes++};
    }
    return cells->n_walls > 0 ? MT_OK : MT_BAD_GEOMETRY;
}

mt_status mt_cells_of(mt_arena *arena, const mt_mesh *mesh, mt_cells *cells) {
    mt_cells made = {.arena = arena, .mesh = mesh, .n_cells = 1};
    if (mesh->n_points <= 0 || mesh->n_triangles <= 0) return MT_BAD_GEOMETRY;
    int *point_of = mt_arena_new(arena, (size_t)mesh->n_points, sizeof *point_of);
    mt_status status = point_of ? lay_grid(&made, mesh) : MT_NO_MEMORY;
    if (status == MT_OK) status = take_points(&made, mesh, point_of);
    if (status == MT_OK) status = take_walls(&made, mesh, point_of);
    if (status == MT_OK) status = mt_cells_separate(&made, 0);
    if (status == MT_OK) *cells = made;
    return status;
}

mt_plane mt_wall_plane(const mt_cells *cells, int wall, int cell) {
    mt_plane plane = cells->planes[cells->walls[wall].plane];
    if (cells->walls[wall].behind != cell) plane = (mt_plane){-plane.x, -plane.y, -plane.z, -plane.offset};
    return plane;
}

/* ---- a part: its edges --------------------------------------------------------------------------------- */

/* An edge of a triangle by its two points, the lower first. */
typedef struct mt_rim {
    int low, high, edge;
    bool upward; /* from low to high */
} mt_rim;

static int by_points(const void *p, const void *q) {
    const mt_rim *x = p, *y = q;
    if (x->low != y->low) return x->low < y->low ? -1 : 1;
    if (x->high != y->high) return x->high < y->high ? -1 : 1;
    return (x->edge > y->edge) - (x->edge < y->edge);
}

/* In what part of the turn about the axis u v, which starts at the direction of r, x lies: 0 at its start, 1 before the half, 2 at the
 * half, 3 after it. Exact: 104 bits. */
static int part_of_turn(mt_place u, mt_place v, mt_place r, mt_place x) {
    int side = mt_orient3(u, v, r, x);
    if (side) return side > 0 ? 1 : 3;
    mt_wide dx = (mt_wide)v.x - u.x, dy = (mt_wide)v.y - u.y, dz = (mt_wide)v.z - u.z;
    mt_wide rx = (mt_wide)r.x - u.x, ry = (mt_wide)r.y - u.y, rz = (mt_wide)r.z - u.z;
    mt_wide px = (mt_wide)x.x - u.x, py = (mt_wide)x.y - u.y, pz = (mt_wide)x.z - u.z;
    mt_wide along = (dx * dx + dy * dy + dz * dz) * (rx * px + ry * py + rz * pz) -
                    (dx * px + dy * py + dz * pz) * (dx * rx + dy * ry + dz * rz);
    return along >= 0 ? 0 : 2;
}

/* Three triangles or more at one edge: each goes with the one on the other side of the solid between them. In the order of the turn
 * about u v, what lies before a triangle that runs from u to v is inside. */
static void pair_around(const mt_cells *cells, const mt_part *part, mt_rim *rims, int n) {
    const mt_place *points = cells->points;
    mt_place u = points[rims[0].low], v = points[rims[0].high];
    mt_place r = points[part->triangles[rims[0].edge / 3].at[mt_edge_before(rims[0].edge) % 3]];
    for (int i = 1; i < n; i++) {
        mt_rim rim = rims[i];
        mt_place x = points[part->triangles[rim.edge / 3].at[mt_edge_before(rim.edge) % 3]];
        int where = part_of_turn(u, v, r, x), k = i;
        for (; k > 1; k--) {
            mt_place y =
                points[part->triangles[rims[k - 1].edge / 3].at[mt_edge_before(rims[k - 1].edge) % 3]];
            int there = part_of_turn(u, v, r, y);
            if (there < where || (there == where && mt_orient3(u, v, y, x) >= 0)) break;
            rims[k] = rims[k - 1];
        }
        rims[k] = rim;
    }
    for (int i = 0; i < n; i++) {
        if (!rims[i].upward) continue;
        for (int k = 1; k < n; k++) {
            const mt_rim *other = &rims[(i - k + n) % n];
            if (other->upward || part->twins[other->edge] >= 0) continue;
            part->twins[other->edge] = rims[i].edge;
            part->twins[rims[i].edge] = other->edge;
            break;
        }
    }
}

/* Finds the twins; the triangles' corners are the cells' points still. */
static mt_status find_twins(mt_arena *arena, const mt_cells *cells, mt_part *part) {
    int n = 3 * part->n_triangles;
    mt_rim *rims = mt_arena_new(arena, (size_t)n, sizeof *rims);
    if (!rims) return MT_NO_MEMORY;
    for (int e = 0; e < n; e++) {
        int from = part->triangles[e / 3].at[e % 3], to = part->triangles[e / 3].at[mt_edge_after(e) % 3];
        rims[e] = from < to ? (mt_rim){from, to, e, true} : (mt_rim){to, from, e, false};
        part->twins[e] = -1;
    }
    qsort(rims, (size_t)n, sizeof *rims, by_points);
    for (int i = 0, end; i < n; i = end) {
        int balance = 0;
        for (end = i; end < n && rims[end].low == rims[i].low && rims[end].high == rims[i].high; end++)
            balance += rims[end].upward ? 1 : -1;
        if (balance != 0) return MT_BAD_GEOMETRY;
        if (end - i == 2) {
            part->twins[rims[i].edge] = rims[i + 1].edge;
            part->twins[rims[i + 1].edge] = rims[i].edge;
        } else {
            pair_around(cells, part, rims + i, end - i);
        }
    }
    return MT_OK;
}

/* ---- a part: its points -------------------------------------------------------------------------------- */

static int root_of(int *parent, int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

static void unite(int *parent, int i, int k) {
    i = root_of(parent, i);
    k = root_of(parent, k);
    if (i < k) parent[k] = i;
    if (k < i) parent[i] = k;
}

/* One point for each fan of triangles. */
static mt_status find_points(mt_arena *arena, const mt_cells *cells, mt_part *part) {
    int n = 3 * part->n_triangles;
    int *parent = mt_arena_new(arena, (size_t)n, sizeof *parent);
    part->point = mt_arena_new(arena, (size_t)n, sizeof *part->point);
    part->places = mt_arena_new(arena, (size_t)n, sizeof *part->places);
    if (!parent || !part->point || !part->places) return MT_NO_MEMORY;
    for (int e = 0; e < n; e++) parent[e] = e;
    for (int e = 0; e < n; e++) unite(parent, e, mt_edge_after(part->twins[e]));
    for (int e = 0; e < n; e++) {
        if (root_of(parent, e) != e) continue;
        int point = part->triangles[e / 3].at[e % 3];
        part->point[part->n_points] = point;
        part->places[part->n_points++] = mt_place_vector(cells->points[point]);
    }
    int made = 0; /* roots come before the others of their fan */
    int *number = mt_arena_new(arena, (size_t)n, sizeof *number);
    if (!number) return MT_NO_MEMORY;
    for (int e = 0; e < n; e++) {
        number[e] = root_of(parent, e) == e ? made++ : number[root_of(parent, e)];
        part->triangles[e / 3].at[e % 3] = number[e];
    }
    return MT_OK;
}

/* Whether a wall bounds the cells, and from which side: 1 when they are behind it, -1 when in front, 0 when not. */
static int bounds(const mt_wall *wall, int cell, int other) {
    bool behind = wall->behind == cell || (other >= 0 && wall->behind == other);
    bool in_front = wall->in_front == cell || (other >= 0 && wall->in_front == other);
    return behind - in_front;
}

mt_status mt_part_of(mt_arena *arena, const mt_cells *cells, int cell, int other, mt_part *part) {
    mt_part made = {0};
    int n = 0;
    for (int w = 0; w < cells->n_walls; w++) n += bounds(&cells->walls[w], cell, other) != 0;
    if (n == 0) return MT_BAD_GEOMETRY;
    made.triangles = mt_arena_new(arena, (size_t)n, sizeof *made.triangles);
    made.walls = mt_arena_new(arena, (size_t)n, sizeof *made.walls);
    made.turned = mt_arena_new(arena, (size_t)n, sizeof *made.turned);
    made.twins = mt_arena_new(arena, 3 * (size_t)n, sizeof *made.twins);
    if (!made.triangles || !made.walls || !made.turned || !made.twins) return MT_NO_MEMORY;
    for (int w = 0; w < cells->n_walls; w++) {
        const int *at = cells->walls[w].at;
        int side = bounds(&cells->walls[w], cell, other);
        if (side == 0) continue;
        made.triangles[made.n_triangles] =
            side > 0 ? (mt_triangle){{at[0], at[1], at[2]}} : (mt_triangle){{at[0], at[2], at[1]}};
        made.turned[made.n_triangles] = side < 0;
        made.walls[made.n_triangles++] = w;
    }
    mt_status status = find_twins(arena, cells, &made);
    if (status == MT_OK) status = find_points(arena, cells, &made);
    if (status == MT_OK) *part = made;
    return status;
}

mt_plane mt_part_plane(const mt_cells *cells, const mt_part *part, int triangle) {
    mt_plane plane = cells->planes[cells->walls[part->walls[triangle]].plane];
    return part->turned[triangle] ? (mt_plane){-plane.x, -plane.y, -plane.z, -plane.offset} : plane;
}

void mt_cells_merge(mt_cells *cells, int cell, int other) {
    int kept = 0;
    for (int w = 0; w < cells->n_walls; w++) {
        mt_wall wall = cells->walls[w];
        if (wall.behind == other) wall.behind = cell;
        if (wall.in_front == other) wall.in_front = cell;
        if (wall.behind != wall.in_front) cells->walls[kept++] = wall;
    }
    cells->n_walls = kept;
}

/* ---- shells -------------------------------------------------------------------------------------------- */

/* Numbers each triangle's shell, that is what hangs together over edges. */
static int *find_shells(mt_arena *arena, const mt_part *part, int *n_shells) {
    int n = part->n_triangles;
    int *parent = mt_arena_new(arena, (size_t)n, sizeof *parent);
    int *shell = mt_arena_new(arena, (size_t)n, sizeof *shell);
    *n_shells = 0;
    if (!parent || !shell) return NULL;
    for (int t = 0; t < n; t++) parent[t] = t;
    for (int e = 0; e < 3 * n; e++) unite(parent, e / 3, part->twins[e] / 3);
    for (int t = 0; t < n; t++)
        shell[t] = root_of(parent, t) == t ? (*n_shells)++ : shell[root_of(parent, t)];
    return shell;
}

mt_status mt_part_is_ball(mt_arena *arena, const mt_part *part, bool *ball) {
    int n_shells;
    if (!find_shells(arena, part, &n_shells)) return MT_NO_MEMORY;
    *ball = n_shells == 1 && 2 * part->n_points - part->n_triangles == 4;
    return MT_OK;
}

static double volume6(const mt_part *part, int t, mt_vector3 from) {
    const int *at = part->triangles[t].at;
    mt_vector3 a = mt_minus3(part->places[at[0]], from), b = mt_minus3(part->places[at[1]], from),
               c = mt_minus3(part->places[at[2]], from);
    return mt_dot3(a, mt_cross3(b, c));
}

double mt_part_volume(const mt_part *part) {
    double sum = 0;
    for (int t = 0; t < part->n_triangles; t++) sum += volume6(part, t, part->places[0]);
    return sum / 6;
}

/* The share of the sphere around p that shell k fills, 1 within it (A. van Oosterom, J. Strackee, "The solid angle of a plane
 * triangle", 1983). */
static double share_around(const mt_part *part, const int *shell, int k, mt_vector3 p) {
    double sum = 0;
    for (int t = 0; t < part->n_triangles; t++) {
        if (shell[t] != k) continue;
        const int *at = part->triangles[t].at;
        mt_vector3 a = mt_minus3(part->places[at[0]], p), b = mt_minus3(part->places[at[1]], p),
                   c = mt_minus3(part->places[at[2]], p);
        double la = mt_length3(a), lb = mt_length3(b), lc = mt_length3(c);
        sum += mt_atan2(mt_dot3(a, mt_cross3(b, c)),
                        la * lb * lc + mt_dot3(a, b) * lc + mt_dot3(b, c) * la + mt_dot3(c, a) * lb);
    }
    return sum / (2 * M_PI);
}

/* The smallest shell with a volume around the hollow k, or -1. */
static int shell_around(const mt_part *part, const int *shell, const double *volumes, int n_shells, int k) {
    int found = -1, inside = 0;
    while (shell[inside] != k) inside++;
    mt_vector3 p = part->places[part->triangles[inside].at[0]];
    for (int s = 0; s < n_shells; s++) {
        if (volumes[s] <= 0 || (found >= 0 && volumes[s] >= volumes[found])) continue;
        if (share_around(part, shell, s, p) > 0.5) found = s;
    }
    return found;
}

static void renumber(mt_cells *cells, int wall, int from, int to) {
    if (cells->walls[wall].behind == from)
        cells->walls[wall].behind = to;
    else
        cells->walls[wall].in_front = to;
}

static mt_status separate(mt_cells *cells, int cell, mt_arena *scratch) {
    mt_part part;
    int n_shells;
    mt_status status = mt_part_of(scratch, cells, cell, -1, &part);
    if (status != MT_OK) return status;
    int *shell = find_shells(scratch, &part, &n_shells);
    double *volumes = mt_arena_new(scratch, (size_t)n_shells, sizeof *volumes);
    int *cell_of = mt_arena_new(scratch, (size_t)n_shells, sizeof *cell_of);
    if (!shell || !volumes || !cell_of) return MT_NO_MEMORY;
    for (int t = 0; t < part.n_triangles; t++) volumes[shell[t]] += volume6(&part, t, part.places[0]);
    bool first = true;
    for (int s = 0; s < n_shells; s++) {
        if (volumes[s] <= 0) continue;
        cell_of[s] = first ? cell : cells->n_cells++;
        first = false;
    }
    if (first) return MT_BAD_GEOMETRY;
    for (int s = 0; s < n_shells; s++) {
        if (volumes[s] > 0) continue;
        int around = shell_around(&part, shell, volumes, n_shells, s);
        cell_of[s] = around < 0 ? cell : cell_of[around];
    }
    for (int t = 0; t < part.n_triangles; t++)
        if (cell_of[shell[t]] != cell) renumber(cells, part.walls[t], cell, cell_of[shell[t]]);
    return MT_OK;
}

mt_status mt_cells_separate(mt_cells *cells, int cell) {
    mt_arena scratch = {0};
    mt_status status = separate(cells, cell, &scratch);
    mt_arena_release(&scratch);
    return status;
}
