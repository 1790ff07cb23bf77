/* From rings back to contours. The vertices lie on the curves that the drawing had, since flattening puts
 * them there, so that fitting through them gives the curves back rather than their chords.
 *
 *   1. Bridge the dents where two neighbouring sums of a union meet.
 *   2. Tell corners from smooth vertices: by their marks, and by how far they turn.
 *   3. Tell lines from chords: by their marks. Of an edge between two crossings nothing is known; but a chord
 * of length l whose ends turn by θ stands for an arc of height about l·θ/8, which flattening keeps under its
 * tolerance, so that an edge that would bulge by more was never a chord.
 *   4. Fit a quadratic spline (spline.c) to each run of chords between corners and lines.
 */
#include <math.h>

#include "limits.h"
#include "outline.h"
#include "spline.h"

typedef struct mt_tracing {
    mt_ring ring;
    double *length;  /* of edge i, from vertex i to the next */
    double *heading; /* of edge i, radians */
    double *turn;    /* at vertex i, radians, left is positive */
    bool *corner;    /* vertex i */
    bool *line;      /* edge i */
    double chord, tolerance;
} mt_tracing;

static int after(const mt_tracing *t, int i) {
    return i + 1 == t->ring.count ? 0 : i + 1;
}

static int before(const mt_tracing *t, int i) {
    return i == 0 ? t->ring.count - 1 : i - 1;
}

/* ---- 1: dents
 * ------------------------------------------------------------------------------------------------ */

/* A crossing that turns right, to the inside of the ink, no deeper than MT_DENT under the line between its
 * neighbours. */
static bool is_dent(mt_point a, mt_point b, mt_point c, uint8_t mark) {
    int64_t deep = -mt_orient(a, b, c);
    if (!(mark & MT_CROSSING) || deep <= 0 || mt_point_equal(a, c)) return false;
    return (double)deep <= MT_DENT * sqrt((double)mt_distance2(a, c));
}

static mt_status bridge_dents(const mt_ring *ring, mt_arena *arena, mt_ring *clean) {
    mt_status status = mt_ring_new(arena, ring->count, clean);
    if (status != MT_OK) return status;
    clean->count = 0;
    for (int i = 0; i < ring->count; i++) {
        mt_point a = ring->points[(i + ring->count - 1) % ring->count],
                 c = ring->points[(i + 1) % ring->count];
        if (is_dent(a, ring->points[i], c, ring->marks[i])) continue;
        clean->points[clean->count] = ring->points[i];
        clean->marks[clean->count++] = ring->marks[i];
    }
    return MT_OK;
}

/* ---- 2 and 3: corners and lines
 * ------------------------------------------------------------------------------ */

static double degrees(double radians) {
    return fabs(radians) * (180 / M_PI);
}

static void measure(mt_tracing *t) {
    const mt_point *p = t->ring.points;
    for (int i = 0; i < t->ring.count; i++) {
        int j = after(t, i);
        t->length[i] = sqrt((double)mt_distance2(p[i], p[j]));
        t->heading[i] = atan2((double)p[j].y - p[i].y, (double)p[j].x - p[i].x);
    }
    for (int i = 0; i < t->ring.count; i++) {
        int h = before(t, i), j = after(t, i);
        t->turn[i] = atan2((double)mt_cross(p[h], p[i], p[i], p[j]), (double)mt_dot(p[h], p[i], p[i], p[j]));
    }
}

static bool is_corner(const mt_tracing *t, int i) {
    if (t->ring.marks[i] & MT_CORNER) return true;
    return degrees(t->turn[i]) > (t->ring.marks[i] & MT_CROSSING ? MT_CROSSING_TURN : MT_SMOOTH_TURN);
}

static bool is_line(const mt_tracing *t, int i) {
    int j = after(t, i);
    if (t->corner[i] && t->corner[j]) return true;
    if (t->ring.marks[i] & MT_EDGE_MARKS) return t->ring.marks[i] & MT_LINE;
    double at_start = t->corner[i] ? t->turn[j] : t->turn[i];
    double at_end = t->corner[j] ? t->turn[i] : t->turn[j];
    return t->length[i] * (fabs(at_start) + fabs(at_end)) / 16 > 2 * t->chord;
}

static mt_status trace(const mt_ring *ring, double chord, double tolerance, mt_arena *arena, mt_tracing *t) {
    size_t n = (size_t)ring->count;
    *t = (mt_tracing){.ring = *ring, .chord = chord, .tolerance = tolerance};
    t->length = mt_arena_new(arena, n, sizeof(double));
    t->heading = mt_arena_new(arena, n, sizeof(double));
    t->turn = mt_arena_new(arena, n, sizeof(double));
    t->corner = mt_arena_new(arena, n, sizeof(bool));
    t->line = mt_arena_new(arena, n, sizeof(bool));
    if (!t->length || !t->heading || !t->turn || !t->corner || !t->line) return MT_NO_MEMORY;
    measure(t);
    for (int i = 0; i < ring->count; i++) t->corner[i] = is_corner(t, i);
    for (int i = 0; i < ring->count; i++) t->line[i] = is_line(t, i);
    return MT_OK;
}

/* Whether a run of chords ends at vertex i: at a corner, or where a line begins or ends. */
static bool is_break(const mt_tracing *t, int i) {
    return t->corner[i] || t->line[i] || t->line[before(t, i)];
}

/* ---- 4: runs
 * -------------------------------------------------------------------------------------------------- */

/* The heading at smooth vertex i: that of the chord between its neighbours, which is exact where the vertices
 * are evenly spaced in a quadratic's parameter, as flattening spaces them; so the turn is shared out against
 * the lengths of the two edges. A line's end heads along the line. */
static double heading_at(const mt_tracing *t, int i) {
    int h = before(t, i);
    if (t->line[h]) return t->heading[h];
    if (t->line[i]) return t->heading[i];
    return t->heading[h] + t->turn[i] * t->length[i] / (t->length[h] + t->length[i]);
}

/* The heading of a run at a corner: that of its first or last chord, turned away by as much as at the chord's
 * other end. */
static double heading_from_corner(const mt_tracing *t, int edge, int vertex, int next_edge, double sign) {
    if (t->corner[vertex]) return t->heading[edge];
    if (t->line[next_edge]) return t->heading[edge] - sign * t->turn[vertex];
    return t->heading[edge] -
           sign * t->turn[vertex] * t->length[next_edge] / (t->length[edge] + t->length[next_edge]);
}

static bool is_extremum(const mt_tracing *t, int i) {
    mt_point a = t->ring.points[before(t, i)], b = t->ring.points[i], c = t->ring.points[after(t, i)];
    bool in_x = (b.x > a.x && b.x > c.x) || (b.x < a.x && b.x < c.x);
    bool in_y = (b.y > a.y && b.y > c.y) || (b.y < a.y && b.y < c.y);
    return !(t->ring.marks[i] & MT_POINT_MARKS) && in_x != in_y;
}

/* At an extremum a smooth curve runs along the other axis. */
static double along_axis(double heading) {
    return round(heading / (M_PI / 2)) * (M_PI / 2);
}

static mt_sample sample_at(const mt_tracing *t, int i, double heading, bool node) {
    if (node) heading = along_axis(heading);
    return (mt_sample){t->ring.points[i].x, t->ring.points[i].y, cos(heading), sin(heading), node};
}

/* The run of `count` chords from vertex `first` on, as count + 1 samples. */
static void sample_run(const mt_tracing *t, int first, int count, mt_sample *samples) {
    int i = first;
    for (int k = 0; k <= count; k++, i = after(t, i)) {
        bool inside = k > 0 && k < count;
        double heading;
        if (!t->corner[i])
            heading = heading_at(t, i);
        else if (k == 0)
            heading = heading_from_corner(t, i, after(t, i), after(t, i), 1);
        else
            heading = heading_from_corner(t, before(t, i), before(t, i), before(t, before(t, i)), -1);
        samples[k] = sample_at(t, i, heading, (inside || !is_break(t, i)) && is_extremum(t, i));
    }
}

static int run_length(const mt_tracing *t, int first) {
    int count = 1, i = after(t, first);
    while (!is_break(t, i) && i != first) {
        count++;
        i = after(t, i);
    }
    return count;
}

static mt_status fit_run(const mt_tracing *t, int first, int count, mt_arena *arena, mt_contour *contour) {
    mt_sample *samples = mt_arena_new(arena, (size_t)count + 1, sizeof *samples);
    if (!samples) return MT_NO_MEMORY;
    sample_run(t, first, count, samples);
    int made;
    mt_status status =
        mt_spline(samples, count + 1, t->tolerance, arena, contour->segments + contour->count, &made);
    if (status == MT_OK) contour->count += made;
    return status;
}

static mt_status fit_ring(const mt_tracing *t, mt_arena *arena, mt_contour *contour) {
    int start = 0;
    while (start < t->ring.count && !is_break(t, start)) start++;
    if (start == t->ring.count) start = 0; /* smooth all around: from the lowest point, an extremum */
    *contour = (mt_contour){0, mt_arena_new(arena, (size_t)t->ring.count, sizeof(mt_segment))};
    if (!contour->segments) return MT_NO_MEMORY;
    for (int done = 0, i = start; done < t->ring.count;) {
        int count = t->line[i] ? 1 : run_length(t, i);
        int end = (i + count) % t->ring.count;
        if (t->line[i]) {
            contour->segments[contour->count++] = (mt_segment){.degree = 1, .end = t->ring.points[end]};
        } else {
            mt_status status = fit_run(t, i, count, arena, contour);
            if (status != MT_OK) return status;
        }
        done += count;
        i = end;
    }
    return MT_OK;
}

mt_status mt_fit(const mt_rings *rings, double chord, double tolerance, mt_arena *arena,
                 mt_outline *outline) {
    mt_outline made = {0, mt_arena_new(arena, (size_t)rings->count, sizeof(mt_contour))};
    if (!made.contours) return MT_NO_MEMORY;
    for (int i = 0; i < rings->count; i++) {
        const mt_ring *ring = &rings->rings[i];
        if (fabs((double)mt_ring_area2(ring)) < MT_SEAM_WIDTH * mt_ring_length(ring)) continue;
        mt_ring clean;
        mt_tracing tracing;
        mt_status status = bridge_dents(ring, arena, &clean);
        if (status == MT_OK && clean.count < 3) continue;
        if (status == MT_OK) status = trace(&clean, chord, tolerance, arena, &tracing);
        if (status == MT_OK) status = fit_ring(&tracing, arena, &made.contours[made.count]);
        if (status != MT_OK) return status;
        made.count++;
    }
    *outline = made;
    return MT_OK;
}
