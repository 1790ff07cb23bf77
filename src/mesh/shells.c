#include "mesh/shells.h"

#include "mesh/limits.h"

typedef struct mt_shell {
    int first, count; /* of its triangles, in `order` */
    int32_t low[3], high[3];
    int within;  /* shells that it is inside of */
    bool inward; /* as it was read */
} mt_shell;

typedef struct mt_shells {
    mt_surface *surface;
    int *shell_of; /* each triangle; -1: none so far */
    int *order;    /* triangles, shell by shell */
    int count;
    mt_shell *list;
} mt_shells;

/* ---- parts ---------------------------------------------------------------------------------------------- */

/* Lists the triangles that are connected with `seed`, from `first` on; how many. */
static int flood(mt_shells *shells, int seed, int first) {
    int end = first;
    shells->order[end++] = seed;
    shells->shell_of[seed] = shells->count;
    for (int i = first; i < end; i++)
        for (int k = 0; k < 3; k++) {
            int other = shells->surface->twins[3 * shells->order[i] + k] / 3;
            if (shells->shell_of[other] >= 0) continue;
            shells->shell_of[other] = shells->count;
            shells->order[end++] = other;
        }
    return end - first;
}

static void measure(const mt_shells *shells, mt_shell *shell) {
    const mt_grid_mesh *grid = shells->surface->grid;
    for (int i = 0; i < 3; i++) shell->low[i] = INT32_MAX, shell->high[i] = INT32_MIN;
    for (int i = 0; i < 3 * shell->count; i++) {
        int triangle = shells->order[shell->first + i / 3];
        mt_grid_point p = grid->at[grid->mesh.triangles[triangle].at[i % 3]];
        const int32_t at[3] = {p.x, p.y, p.z};
        for (int k = 0; k < 3; k++) {
            if (at[k] < shell->low[k]) shell->low[k] = at[k];
            if (at[k] > shell->high[k]) shell->high[k] = at[k];
        }
    }
}

static mt_status find_shells(mt_shells *shells, mt_arena *arena, mt_mesh_fault *fault) {
    int n = shells->surface->grid->mesh.n_triangles, first = 0;
    shells->shell_of = mt_arena_new(arena, (size_t)n, sizeof *shells->shell_of);
    shells->order = mt_arena_new(arena, (size_t)n, sizeof *shells->order);
    shells->list = mt_arena_new(arena, MT_MESH_SHELLS_MAX, sizeof *shells->list);
    if (!shells->shell_of || !shells->order || !shells->list) return MT_NO_MEMORY;
    for (int i = 0; i < n; i++) shells->shell_of[i] = -1;
    for (int i = 0; i < n; i++) {
        if (shells->shell_of[i] >= 0) continue;
        if (shells->count == MT_MESH_SHELLS_MAX)
            return mt_mesh_say(fault, MT_TOO_LARGE, "over %d parts", MT_MESH_SHELLS_MAX);
        mt_shell *shell = &shells->list[shells->count];
        *shell = (mt_shell){.first = first, .count = flood(shells, i, first)};
        first += shell->count;
        measure(shells, shell);
        shells->count++;
    }
    return MT_OK;
}

/* ---- which is inside which ------------------------------------------------------------------------------ */

static mt_grid_flat seen_along_x(mt_grid_point p) {
    return (mt_grid_flat){p.y, p.z};
}

/* The turn of a, b and a point a little above p and, far less, to its right, so that it is on no line of the grid; 0 where a and
 * b are one. */
static int turn_beside(mt_grid_flat a, mt_grid_flat b, mt_grid_flat p) {
    int turn = mt_grid_turn(a, b, p);
    if (turn != 0) return turn;
    return a.x != b.x ? (b.x > a.x ? 1 : -1) : (a.y > b.y) - (a.y < b.y);
}

/* Which way a ray from p along x goes through the triangle: 1 out of it, -1 into it, 0 not at all. */
static int passes(mt_grid_point p, mt_grid_point a, mt_grid_point b, mt_grid_point c) {
    mt_grid_flat seen[3] = {seen_along_x(a), seen_along_x(b), seen_along_x(c)}, from = seen_along_x(p);
    int turn = turn_beside(seen[0], seen[1], from);
    if (turn == 0 || turn_beside(seen[1], seen[2], from) != turn ||
        turn_beside(seen[2], seen[0], from) != turn)
        return 0;
    return mt_grid_side(a, b, c, p) == turn ? turn : 0;
}

/* How often the shell goes around the point: 1 or -1 inside. */
static int winding(const mt_shells *shells, const mt_shell *shell, mt_grid_point p) {
    const mt_grid_mesh *grid = shells->surface->grid;
    int sum = 0;
    for (int i = 0; i < shell->count; i++) {
        const int *at = grid->mesh.triangles[shells->order[shell->first + i]].at;
        sum += passes(p, grid->at[at[0]], grid->at[at[1]], grid->at[at[2]]);
    }
    return sum;
}

static bool box_holds(const mt_shell *outer, const mt_shell *inner) {
    for (int i = 0; i < 3; i++)
        if (inner->low[i] <= outer->low[i] || inner->high[i] >= outer->high[i]) return false;
    return true;
}

/* The shell's volume, with a sign, tells which way it faces; exact, since six times it fits 128 bits. */
static bool faces_inward(const mt_shells *shells, const mt_shell *shell) {
    const mt_grid_mesh *grid = shells->surface->grid;
    mt_int128 sum = 0;
    for (int i = 0; i < shell->count; i++) {
        const int *at = grid->mesh.triangles[shells->order[shell->first + i]].at;
        mt_grid_point a = grid->at[at[0]];
        mt_grid_normal n = mt_grid_normal_of((mt_grid_point){0}, grid->at[at[1]], grid->at[at[2]]);
        sum += (mt_int128)a.x * n.x + (mt_int128)a.y * n.y + (mt_int128)a.z * n.z;
    }
    return sum < 0;
}

static void nest(mt_shells *shells) {
    const mt_grid_mesh *grid = shells->surface->grid;
    for (int i = 0; i < shells->count; i++) {
        mt_shell *shell = &shells->list[i];
        mt_grid_point p = grid->at[grid->mesh.triangles[shells->order[shell->first]].at[0]];
        shell->inward = faces_inward(shells, shell);
        for (int k = 0; k < shells->count; k++)
            if (k != i && box_holds(&shells->list[k], shell))
                shell->within += winding(shells, &shells->list[k], p) != 0;
    }
}

/* ---- turning -------------------------------------------------------------------------------------------- */

static void turn_over(mt_shells *shells, const mt_shell *shell) {
    for (int i = 0; i < shell->count; i++) {
        int *at = shells->surface->grid->mesh.triangles[shells->order[shell->first + i]].at;
        int second = at[1];
        at[1] = at[2];
        at[2] = second;
    }
}

/* Whether all shells that this one is inside of face the wrong way, too. */
static bool outer_are_wrong(const mt_shells *shells, const mt_shell *shell) {
    const mt_grid_mesh *grid = shells->surface->grid;
    mt_grid_point p = grid->at[grid->mesh.triangles[shells->order[shell->first]].at[0]];
    for (int k = 0; k < shells->count; k++) {
        const mt_shell *outer = &shells->list[k];
        bool right = outer->inward == (outer->within % 2 == 1);
        if (outer != shell && right && box_holds(outer, shell) && winding(shells, outer, p) != 0)
            return false;
    }
    return true;
}

static mt_status check_shell(const mt_shells *shells, const mt_shell *shell, mt_mesh_fault *fault) {
    char place[MT_PLACE_ROOM];
    bool right = shell->inward == (shell->within % 2 == 1);
    if (right || outer_are_wrong(shells, shell)) return MT_OK;
    const mt_mesh *mesh = &shells->surface->grid->mesh;
    mt_place_write(mesh->points[mesh->triangles[shells->order[shell->first]].at[0]], place);
    return mt_mesh_say(fault, MT_NOT_SOLID, "the part at %s stands inside another and faces as that does",
                       place);
}

mt_status mt_surface_turn_shells(mt_surface *surface, mt_arena *arena, mt_mesh_fault *fault) {
    mt_shells shells = {.surface = surface};
    mt_status status = find_shells(&shells, arena, fault);
    if (status != MT_OK) return status;
    nest(&shells);
    for (int i = 0; i < shells.count && status == MT_OK; i++)
        status = check_shell(&shells, &shells.list[i], fault);
    for (int i = 0; i < shells.count && status == MT_OK; i++) {
        const mt_shell *shell = &shells.list[i];
        if (shell->inward != (shell->within % 2 == 1)) turn_over(&shells, shell);
    }
    return status;
}
