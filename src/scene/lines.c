#include "scene/lines.h"

#include <math.h>
#include <string.h>

/* Two faces make a crease from this angle on, as the cosine of it: 30 degrees. */
#define CREASE 0.8660254037844386
/* How far, in samples, a depth may be off those that the slopes of both faces allow for: what rounding of corners does to it. */
#define DEPTH_SLACK 1.0

/* How much nearer a face gets from a sample to its neighbour at (dx, dy). */
static double rise(mt_vector3 normal, int dx, int dy) {
    /* y runs downwards. */
    return -(normal.x * dx - normal.y * dy) / normal.z;
}

static bool is_crease(mt_vector3 a, mt_vector3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z < CREASE;
}

/* Whether a line runs between a sample and its neighbour at (dx, dy), `step` samples on. */
static bool parts(const mt_seen_mesh *seen, const mt_samples *samples, size_t i, size_t step, int dx,
                  int dy) {
    int a = samples->triangle[i], b = samples->triangle[i + step];
    if (a == b) return false;
    if (a < 0 || b < 0) return true;
    mt_vector3 from = seen->normals[a], to = seen->normals[b];
    if (is_crease(from, to)) return true;
    double change = samples->depth[i + step] - samples->depth[i], first = rise(from, dx, dy),
           second = rise(to, dx, dy);
    return change < fmin(first, second) - DEPTH_SLACK || change > fmax(first, second) + DEPTH_SLACK;
}

static void mark(const mt_seen_mesh *seen, const mt_samples *samples, uint8_t *marks) {
    size_t width = (size_t)samples->width, rows = (size_t)samples->rows;
    for (size_t y = 0; y < rows; y++)
        for (size_t x = 0; x < width; x++) {
            size_t i = y * width + x;
            marks[i] = (x + 1 < width && parts(seen, samples, i, 1, 1, 0)) ||
                       (y + 1 < rows && parts(seen, samples, i, width, 0, 1));
        }
}

/* Inks the disc around a mark. */
static void spread(const mt_samples *samples, int x, int y, uint8_t *ink) {
    for (int dy = -MT_LINE_REACH; dy <= MT_LINE_REACH; dy++)
        for (int dx = -MT_LINE_REACH; dx <= MT_LINE_REACH; dx++) {
            bool inside = x + dx >= 0 && x + dx < samples->width && y + dy >= 0 && y + dy < samples->rows;
            if (inside && dx * dx + dy * dy <= MT_LINE_REACH * MT_LINE_REACH)
                ink[(size_t)(y + dy) * (size_t)samples->width + (size_t)(x + dx)] = 1;
        }
}

void mt_lines_find(const mt_seen_mesh *seen, const mt_samples *samples, uint8_t *marks, uint8_t *ink) {
    mark(seen, samples, marks);
    memset(ink, 0, (size_t)samples->width * (size_t)samples->rows);
    for (int y = 0; y < samples->rows; y++)
        for (int x = 0; x < samples->width; x++)
            if (marks[(size_t)y * (size_t)samples->width + (size_t)x]) spread(samples, x, y, ink);
}
