#include "mesh/polygon.h"

#include "mesh/limits.h"

typedef struct mt_cutting {
    int count;
    int corners[MT_MESH_CORNERS_MAX]; /* that are left */
    mt_grid_flat flat[MT_MESH_CORNERS_MAX];
    int n_triangles;
    mt_triangle *triangles;
    int64_t *work;
} mt_cutting;

/* Newell's: twice the area vector of the polygon, halved until it fits. Each sum is under 2^58. */
static mt_grid_normal normal_of(const mt_grid_point *at, const int *corners, int count) {
    mt_grid_normal sum = {0};
    for (int i = 1; i + 1 < count; i++) {
        mt_grid_normal n = mt_grid_normal_of(at[corners[0]], at[corners[i]], at[corners[i + 1]]);
        sum = (mt_grid_normal){sum.x + n.x, sum.y + n.y, sum.z + n.z};
    }
    return sum;
}

static void add(mt_cutting *cutting, int a, int b, int c) {
    if (a == b || b == c || c == a) return;
    cutting->triangles[cutting->n_triangles++] = (mt_triangle){{a, b, c}};
}

static bool same(mt_grid_flat a, mt_grid_flat b) {
    return a.x == b.x && a.y == b.y;
}

/* In the closed triangle, but at none of its corners: a bridge to a hole passes a corner twice. */
static bool blocks(mt_grid_flat p, mt_grid_flat a, mt_grid_flat b, mt_grid_flat c) {
    if (same(p, a) || same(p, b) || same(p, c)) return false;
    return mt_grid_turn(a, b, p) >= 0 && mt_grid_turn(b, c, p) >= 0 && mt_grid_turn(c, a, p) >= 0;
}

static bool is_ear(mt_cutting *cutting, int i) {
    int n = cutting->count, before = (i + n - 1) % n, after = (i + 1) % n;
    mt_grid_flat a = cutting->flat[before], b = cutting->flat[i], c = cutting->flat[after];
    ++*cutting->work;
    if (mt_grid_turn(a, b, c) <= 0) return false;
    *cutting->work += n;
    for (int k = 0; k < n; k++)
        if (k != before && k != i && k != after && blocks(cutting->flat[k], a, b, c)) return false;
    return true;
}

static void cut_off(mt_cutting *cutting, int i) {
    int n = cutting->count;
    add(cutting, cutting->corners[(i + n - 1) % n], cutting->corners[i], cutting->corners[(i + 1) % n]);
    cutting->count--;
    for (int k = i; k < cutting->count; k++) {
        cutting->corners[k] = cutting->corners[k + 1];
        cutting->flat[k] = cutting->flat[k + 1];
    }
}

/* The next ear from `first` on; -1 for none. */
static int find_ear(mt_cutting *cutting, int first) {
    for (int k = 0; k < cutting->count; k++) {
        int i = (first + k) % cutting->count;
        if (is_ear(cutting, i)) return i;
    }
    return -1;
}

static void cut(mt_cutting *cutting) {
    int ear = 1;
    while (cutting->count > 3 && *cutting->work <= MT_POLYGON_WORK_MAX) {
        ear = find_ear(cutting, ear % cutting->count);
        if (ear < 0) break;
        cut_off(cutting, ear);
    }
    for (int i = 1; i + 1 < cutting->count; i++)
        add(cutting, cutting->corners[0], cutting->corners[i], cutting->corners[i + 1]);
}

int mt_polygon_triangles(const mt_grid_point *at, const int *corners, int count, mt_triangle *triangles,
                         int64_t *work) {
    mt_cutting cutting;
    if (count < 3 || *work > MT_POLYGON_WORK_MAX) return 0;
    cutting.count = count;
    cutting.n_triangles = 0;
    cutting.triangles = triangles;
    cutting.work = work;
    mt_grid_normal normal = normal_of(at, corners, count);
    for (int i = 0; i < count; i++) {
        cutting.corners[i] = corners[i];
        cutting.flat[i] = mt_grid_drop(at[corners[i]], normal);
    }
    cut(&cutting);
    return cutting.n_triangles;
}
