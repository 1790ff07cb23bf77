#include "scene/samples.h"

#include <math.h>

/* Corners are rounded to so small a part of a sample, so that two triangles leave no gap at an edge that they share. */
#define PARTS 256

typedef struct mt_spot2 {
    int64_t x, y;
} mt_spot2;

static mt_vector3 normal_of(mt_vector3 a, mt_vector3 b, mt_vector3 c) {
    mt_vector3 u = {b.x - a.x, b.y - a.y, b.z - a.z}, v = {c.x - a.x, c.y - a.y, c.z - a.z};
    mt_vector3 n = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    double length = sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    return length > 0 ? (mt_vector3){n.x / length, n.y / length, n.z / length} : (mt_vector3){0};
}

mt_status mt_seen_mesh_make(const mt_mesh *mesh, const mt_eye *eye, mt_vector3 middle, double scale,
                            int width, int height, mt_arena *arena, mt_seen_mesh *seen) {
    mt_vector3 centre = mt_eye_sees(eye, middle);
    double unit = scale * MT_SAMPLES;
    *seen = (mt_seen_mesh){.n_triangles = mesh->n_triangles, .triangles = mesh->triangles};
    seen->points = mt_arena_new(arena, (size_t)mesh->n_points, sizeof *seen->points);
    seen->normals = mt_arena_new(arena, (size_t)mesh->n_triangles, sizeof *seen->normals);
    if (!seen->points || !seen->normals) return MT_NO_MEMORY;
    for (int i = 0; i < mesh->n_points; i++) {
        mt_vector3 p = mt_eye_sees(eye, mesh->points[i]);
        seen->points[i] =
            (mt_vector3){(p.x - centre.x) * unit + width * MT_SAMPLES / 2.0,
                         (centre.y - p.y) * unit + height * MT_SAMPLES / 2.0, (p.z - centre.z) * unit};
    }
    for (int i = 0; i < mesh->n_triangles; i++) {
        const int *at = mesh->triangles[i].at;
        /* y of the points runs downwards: they turn the other way around. */
        seen->normals[i] = normal_of(seen->points[at[0]], seen->points[at[2]], seen->points[at[1]]);
        seen->normals[i].y = -seen->normals[i].y;
    }
    return MT_OK;
}

mt_status mt_samples_new(int width, int rows, mt_arena *arena, mt_samples *samples) {
    size_t count = (size_t)width * (size_t)rows;
    *samples = (mt_samples){.width = width, .rows = rows};
    samples->triangle = mt_arena_new(arena, count, sizeof *samples->triangle);
    samples->depth = mt_arena_new(arena, count, sizeof *samples->depth);
    return samples->triangle && samples->depth ? MT_OK : MT_NO_MEMORY;
}

/* Twice the area of a, b and c; > 0 where they are clockwise on the picture. */
static int64_t area(mt_spot2 a, mt_spot2 b, mt_spot2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static int clamp(double value, int low, int high) {
    return value < low ? low : value > high ? high : (int)value;
}

static double least(double a, double b, double c) {
    return fmin(a, fmin(b, c));
}

static double most(double a, double b, double c) {
    return fmax(a, fmax(b, c));
}

static void take_triangle(const mt_seen_mesh *seen, int triangle, mt_samples *samples) {
    const int *at = seen->triangles[triangle].at;
    mt_vector3 p = seen->points[at[0]], q = seen->points[at[1]], r = seen->points[at[2]];
    double y0 = least(p.y, q.y, r.y) - samples->top, y1 = most(p.y, q.y, r.y) - samples->top;
    if (y1 < 0 || y0 > samples->rows) return;
    mt_spot2 a = {llround(p.x * PARTS), llround(p.y * PARTS)},
             b = {llround(q.x * PARTS), llround(q.y * PARTS)},
             c = {llround(r.x * PARTS), llround(r.y * PARTS)};
    int64_t whole = -area(a, b, c);
    if (whole <= 0) return;
    int left = clamp(least(p.x, q.x, r.x) - 1, 0, samples->width),
        right = clamp(most(p.x, q.x, r.x) + 1, 0, samples->width), upper = clamp(y0 - 1, 0, samples->rows),
        lower = clamp(y1 + 1, 0, samples->rows);
    for (int y = upper; y < lower; y++)
        for (int x = left; x < right; x++) {
            mt_spot2 spot = {(int64_t)x * PARTS + PARTS / 2, (int64_t)(y + samples->top) * PARTS + PARTS / 2};
            int64_t of_a = -area(b, c, spot), of_b = -area(c, a, spot), of_c = -area(a, b, spot);
            if (of_a < 0 || of_b < 0 || of_c < 0) continue;
            double z = ((double)of_a * p.z + (double)of_b * q.z + (double)of_c * r.z) / (double)whole;
            size_t place = (size_t)y * (size_t)samples->width + (size_t)x;
            if (samples->triangle[place] >= 0 && samples->depth[place] >= z) continue;
            samples->triangle[place] = triangle;
            samples->depth[place] = z;
        }
}

void mt_samples_take(const mt_seen_mesh *seen, int top, mt_samples *samples) {
    size_t count = (size_t)samples->width * (size_t)samples->rows;
    samples->top = top;
    for (size_t i = 0; i < count; i++) samples->triangle[i] = -1;
    for (int i = 0; i < seen->n_triangles; i++) take_triangle(seen, i, samples);
}
