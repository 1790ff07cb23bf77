#include "scene/lines.h"

#include <math.h>
#include <string.h>

/* Two faces make a crease from this angle on, as the cosine of it: 30 degrees. */
#define CREASE 0.8660254037844386
/* How far, in samples, a depth may be off those that the slopes of both faces allow for: a pixel. What rounding of corners does to it is
 * less, and a step that is lower is not seen. */
#define DEPTH_SLACK ((double)MT_SAMPLES)

/* How much nearer a face gets from a sample to its neighbour at (dx, dy). */
static double rise(mt_vector3 normal, int dx, int dy) {
    /* y runs downwards. */
    return -(normal.x * dx - normal.y * dy) / normal.z;
}

static bool is_crease(mt_vector3 a, mt_vector3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z < CREASE;
}

/* Whether one of two samples is before the other: they lie (dx, dy) apart, b after a. */
static bool is_jump(const mt_seen_mesh *seen, const mt_samples *samples, size_t a, size_t b, int dx, int dy) {
    double first = rise(seen->normals[samples->triangle[a]], dx, dy),
           second = rise(seen->normals[samples->triangle[b]], dx, dy);
    double change = samples->depth[b] - samples->depth[a];
    return change < fmin(first, second) - DEPTH_SLACK || change > fmax(first, second) + DEPTH_SLACK;
}

/* Neighbouring samples in a row or a column. */
typedef struct mt_neighbours {
    size_t at, step;   /* the first, and from one to the next */
    int dx, dy;        /* likewise */
    int before, after; /* how many there are on both sides of the two */
} mt_neighbours;

/* Whether the surface goes on within a pixel on both sides of a crease as if it were not there: a fold or a groove that is too narrow to
 * be seen. */
static bool goes_on(const mt_seen_mesh *seen, const mt_samples *samples, const mt_neighbours *pair) {
    for (int i = 0; i <= MT_SAMPLES && i <= pair->before; i++)
        for (int k = 0; i + k <= MT_SAMPLES && k <= pair->after; k++) {
            size_t a = pair->at - (size_t)i * pair->step, b = pair->at + (size_t)(k + 1) * pair->step;
            int apart = i + k + 1, of_a = samples->triangle[a], of_b = samples->triangle[b];
            if (of_a < 0 || of_b < 0) continue;
            if (!is_crease(seen->normals[of_a], seen->normals[of_b]) &&
                !is_jump(seen, samples, a, b, apart * pair->dx, apart * pair->dy))
                return true;
        }
    return false;
}

/* Whether a line runs between two neighbours. */
static bool parts(const mt_seen_mesh *seen, const mt_samples *samples, const mt_neighbours *pair) {
    size_t next = pair->at + pair->step;
    int a = samples->triangle[pair->at], b = samples->triangle[next];
    if (a == b) return false;
    if (a < 0 || b < 0) return true;
    if (is_jump(seen, samples, pair->at, next, pair->dx, pair->dy)) return true;
    return is_crease(seen->normals[a], seen->normals[b]) && !goes_on(seen, samples, pair);
}

static void mark(const mt_seen_mesh *seen, const mt_samples *samples, uint8_t *marks) {
    int width = samples->width, rows = samples->rows;
    for (int y = 0; y < rows; y++)
        for (int x = 0; x < width; x++) {
            size_t i = (size_t)y * (size_t)width + (size_t)x;
            mt_neighbours across = {i, 1, 1, 0, x, width - x - 2},
                          down = {i, (size_t)width, 0, 1, y, rows - y - 2};
            marks[i] = (x + 1 < width && parts(seen, samples, &across)) ||
                       (y + 1 < rows && parts(seen, samples, &down));
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
