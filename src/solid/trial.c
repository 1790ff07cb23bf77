/* Points hang together over edges that the plane does not cross. The volume on a side is that of the cones over its triangles from a
 * point in the plane: the cap has none. The hull of a side is that of its points and the crossings of its edges.
 *
 * Handles come from Euler's characteristic: that of the surface on both sides is that of the points, edges and triangles that lie there
 * wholly; a cap with holes has 2 less the number of its rings, so all caps together have twice as many as rings that run
 * around them, less all rings. */
#include "solid/trial.h"

#include <stdlib.h>

#include "space/hull.h"
#include "space/vector.h"

/* So many points of a part are enough to compare its hull by. */
enum { POINTS = 1200 };

typedef struct mt_trying {
    const mt_part *part;
    double *heights; /* of the points over the plane, grid units */
    int *parent;     /* of the points: a forest */
    mt_vector3 origin;
    mt_arena *arena;
} mt_trying;

static int root_of(int *parent, int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

static int side(const mt_trying *t, int p) {
    return (t->heights[p] > 1) - (t->heights[p] < -1);
}

static void join(mt_trying *t) {
    const mt_part *part = t->part;
    for (int p = 0; p < part->n_points; p++) t->parent[p] = p;
    for (int e = 0; e < 3 * part->n_triangles; e++) {
        const int *at = part->triangles[e / 3].at;
        int p = at[e % 3], q = at[(e % 3 + 1) % 3];
        if (side(t, p) == 0 || side(t, p) != side(t, q)) continue;
        int a = root_of(t->parent, p), b = root_of(t->parent, q);
        t->parent[a > b ? a : b] = a > b ? b : a;
    }
}

static mt_vector3 crossing(const mt_trying *t, int p, int q) {
    double s = t->heights[p] / (t->heights[p] - t->heights[q]);
    return mt_between3(t->part->places[p], t->part->places[q], s);
}

/* Six times the volume between the plane's point and the part of a triangle on a side. */
static double cone(const mt_trying *t, const int at[3], int wanted) {
    mt_vector3 corners[4];
    int n = 0;
    for (int i = 0; i < 3; i++) {
        int p = at[i], q = at[(i + 1) % 3];
        if (side(t, p) == wanted || side(t, p) == 0) corners[n++] = mt_minus3(t->part->places[p], t->origin);
        if (side(t, p) * side(t, q) < 0) corners[n++] = mt_minus3(crossing(t, p, q), t->origin);
    }
    double sum = 0;
    for (int i = 1; i + 1 < n; i++) sum += mt_dot3(corners[0], mt_cross3(corners[i], corners[i + 1]));
    return sum;
}

/* The points of one part: its own, and those on its edges where they end in the plane. */
static mt_status gather(mt_trying *t, int root, mt_vector3 **points, int *n) {
    const mt_part *part = t->part;
    int room = 0, own = 0;
    *points = NULL;
    *n = 0;
    for (int p = 0; p < part->n_points; p++) own += side(t, p) != 0 && root_of(t->parent, p) == root;
    int every = own / POINTS + 1;
    for (int p = 0, k = 0; p < part->n_points; p++) {
        if (side(t, p) == 0 || root_of(t->parent, p) != root || k++ % every) continue;
        *points = mt_arena_grow_list(t->arena, *points, *n, &room, sizeof **points);
        if (!*points) return MT_NO_MEMORY;
        (*points)[(*n)++] = part->places[p];
    }
    for (int e = 0; e < 3 * part->n_triangles; e++) {
        const int *at = part->triangles[e / 3].at;
        int p = at[e % 3], q = at[(e % 3 + 1) % 3];
        if (side(t, p) == 0 || side(t, q) == side(t, p) || root_of(t->parent, p) != root) continue;
        *points = mt_arena_grow_list(t->arena, *points, *n, &room, sizeof **points);
        if (!*points) return MT_NO_MEMORY;
        (*points)[(*n)++] = side(t, q) == 0 ? part->places[q] : crossing(t, p, q);
    }
    return MT_OK;
}

/* ---- handles ------------------------------------------------------------------------------------------- */

/* Where a ring of the section passes: a crossed edge, or a point in the plane. */
static int passage(const mt_trying *t, int e, bool at_start) {
    int n_edges = 3 * t->part->n_triangles, twin = t->part->twins[e];
    const int *at = t->part->triangles[e / 3].at;
    return at_start ? n_edges + at[e % 3] : e < twin ? e : twin;
}

/* The section of a triangle that has something below: from where its border comes up to where it goes down again. Whether there is one. */
static bool section(const mt_trying *t, int triangle, int passages[2], mt_vector3 ends[2]) {
    const int *at = t->part->triangles[triangle].at;
    int n = 0, below = 0;
    for (int i = 0; i < 3; i++) below += side(t, at[i]) < 0;
    for (int i = 0; i < 3 && below > 0; i++) {
        int p = at[i], q = at[(i + 1) % 3], last = at[(i + 2) % 3], e = 3 * triangle + i;
        bool up = side(t, p) < 0 && side(t, q) > 0, down = side(t, p) > 0 && side(t, q) < 0;
        bool leaves = side(t, p) == 0 && side(t, last) < 0, enters = side(t, p) == 0 && side(t, q) < 0;
        if (leaves == enters && !up && !down) continue;
        int end = up || leaves ? 0 : 1;
        passages[end] = passage(t, e, !up && !down);
        ends[end] = up || down ? crossing(t, p, q) : t->part->places[p];
        n++;
    }
    return n == 2;
}

/* Points less edges plus triangles of what lies wholly below. */
static int count_below(const mt_trying *t) {
    const mt_part *part = t->part;
    int count = 0;
    for (int p = 0; p < part->n_points; p++) count += side(t, p) < 0;
    for (int e = 0; e < 3 * part->n_triangles; e++) {
        const int *at = part->triangles[e / 3].at;
        count -= e < part->twins[e] && side(t, at[e % 3]) < 0 && side(t, at[(e % 3 + 1) % 3]) < 0;
    }
    for (int i = 0; i < part->n_triangles; i++) {
        const int *at = part->triangles[i].at;
        count += side(t, at[0]) < 0 && side(t, at[1]) < 0 && side(t, at[2]) < 0;
    }
    return count;
}

/* Euler's characteristic of the surface that what lies below has with its caps. */
static mt_status characteristic(mt_trying *t, mt_vector3 normal, int *found) {
    int n = 3 * t->part->n_triangles + t->part->n_points;
    int *parent = mt_arena_new(t->arena, (size_t)n, sizeof *parent);
    double *areas = mt_arena_new(t->arena, (size_t)n, sizeof *areas);
    int passages[2];
    mt_vector3 ends[2];
    if (!parent || !areas) return MT_NO_MEMORY;
    for (int i = 0; i < n; i++) parent[i] = i;
    for (int i = 0; i < t->part->n_triangles; i++)
        if (section(t, i, passages, ends))
            parent[root_of(parent, passages[0])] = root_of(parent, passages[1]);
    for (int i = 0; i < t->part->n_triangles; i++)
        if (section(t, i, passages, ends))
            areas[root_of(parent, passages[0])] +=
                mt_dot3(normal, mt_cross3(mt_minus3(ends[1], t->origin), mt_minus3(ends[0], t->origin)));
    *found = count_below(t);
    for (int i = 0; i < n; i++) *found += (areas[i] > 0) - (areas[i] < 0);
    return MT_OK;
}

static mt_status count_handles(mt_trying *t, mt_vector3 normal, mt_trial *trial) {
    int below, above;
    mt_status status = characteristic(t, normal, &below);
    for (int p = 0; p < t->part->n_points; p++) t->heights[p] = -t->heights[p];
    if (status == MT_OK) status = characteristic(t, mt_times3(-1, normal), &above);
    if (status == MT_OK) trial->n_handles = trial->n_parts - (below + above) / 2;
    return status;
}

/* ---- all of it ----------------------------------------------------------------------------------------- */

static mt_status try_plane(mt_trying *t, mt_trial *trial) {
    const mt_part *part = t->part;
    double *volumes = mt_arena_new(t->arena, (size_t)part->n_points, sizeof *volumes);
    mt_status status = MT_OK;
    if (!volumes) return MT_NO_MEMORY;
    join(t);
    for (int i = 0; i < part->n_triangles; i++)
        for (int k = 0; k < 3; k++) {
            const int *at = part->triangles[i].at;
            int s = side(t, at[k]);
            bool counted = s == 0; /* each side of a triangle once, for the first of its corners there */
            for (int m = 0; m < k; m++) counted |= side(t, at[m]) == s;
            if (!counted) volumes[root_of(t->parent, at[k])] += cone(t, at, s) / 6;
        }
    for (int p = 0; status == MT_OK && p < part->n_points; p++) {
        mt_vector3 *points;
        double hull = 0;
        int n;
        if (side(t, p) == 0 || root_of(t->parent, p) != p) continue;
        mt_arena_place before = mt_arena_mark(t->arena);
        status = gather(t, p, &points, &n);
        if (status == MT_OK) status = mt_hull_volume(points, n, &hull);
        mt_arena_rewind(t->arena, before);
        trial->n_parts++;
        if (side(t, p) < 0) trial->behind += volumes[p];
        trial->excess += fmax(hull - fmax(volumes[p], 0), 0);
    }
    return status;
}

mt_status mt_trial_of(const mt_part *part, const mt_plane *plane, mt_trial *trial) {
    mt_arena scratch = {0};
    mt_trial made = {0};
    mt_trying t = {.part = part,
                   .heights = mt_arena_new(&scratch, (size_t)part->n_points, sizeof(double)),
                   .parent = mt_arena_new(&scratch, (size_t)part->n_points, sizeof(int)),
                   .arena = &scratch};
    mt_status status = t.heights && t.parent ? MT_OK : MT_NO_MEMORY;
    if (status == MT_OK) {
        mt_vector3 n = mt_plane_normal(plane);
        double offset = (double)plane->offset /
                        mt_length3((mt_vector3){(double)plane->x, (double)plane->y, (double)plane->z});
        t.origin = mt_times3(offset, n);
        for (int p = 0; p < part->n_points; p++) t.heights[p] = mt_dot3(n, part->places[p]) - offset;
        status = try_plane(&t, &made);
        if (status == MT_OK) status = count_handles(&t, n, &made);
    }
    mt_arena_release(&scratch);
    if (status == MT_OK) *trial = made;
    return status;
}
