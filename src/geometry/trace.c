/* A ring read as a drawing: corners and lines by marks, headings at smooth vertices from the chords on both sides.
 *
 *          ● ← heading: between the two chords' headings; the turn is shared in proportion to the edges' lengths, which is
 *      ╱      ╲   exact for vertices spaced evenly in a quadratic's parameter, as flattening spaces them
 *     ●        ●  but a heading leaves a chord of length l by at most 5 · chord / l: a curve that bulges more was flattened finer
 *
 * Angles decide only where marks are silent: at crossings, and between two crossings. Invariants: in and out headings agree at smooth
 * vertices, unless the bound forbids it; a line's are its own direction. O(n). */
#include "geometry/trace.h"

#include <assert.h>
#include <math.h>

#include "arithmetic/angles.h"
#include "geometry/limits.h"

int mt_trace_after(const mt_trace *t, int i) {
    return i + 1 == t->ring.count ? 0 : i + 1;
}

int mt_trace_before(const mt_trace *t, int i) {
    return i == 0 ? t->ring.count - 1 : i - 1;
}

/* ---- corners and lines --------------------------------------------------------------------------------- */

static void measure(mt_trace *t) {
    const mt_point *p = t->ring.points;
    for (int i = 0; i < t->ring.count; i++) {
        int j = mt_trace_after(t, i);
        t->length[i] = sqrt((double)mt_distance2(p[i], p[j]));
        t->heading[i] = mt_atan2((double)p[j].y - p[i].y, (double)p[j].x - p[i].x);
    }
    for (int i = 0; i < t->ring.count; i++) {
        int h = mt_trace_before(t, i), j = mt_trace_after(t, i);
        t->turn[i] =
            mt_atan2((double)mt_cross(p[h], p[i], p[i], p[j]), (double)mt_dot(p[h], p[i], p[i], p[j]));
    }
}

static bool is_corner(const mt_trace *t, int i) {
    if (t->ring.marks[i] & MT_CORNER) return true;
    double degrees = fabs(t->turn[i]) * (180 / M_PI);
    return degrees > (t->ring.marks[i] & MT_CROSSING ? MT_CROSSING_TURN : MT_SMOOTH_TURN);
}

static bool is_line(const mt_trace *t, int i) {
    int j = mt_trace_after(t, i);
    if (t->corner[i] && t->corner[j]) return true;
    if (t->ring.marks[i] & MT_EDGE_MARKS) return t->ring.marks[i] & MT_LINE;
    double at_start = t->corner[i] ? t->turn[j] : t->turn[i];
    double at_end = t->corner[j] ? t->turn[i] : t->turn[j];
    return t->length[i] * (fabs(at_start) + fabs(at_end)) / 16 > 2 * t->chord;
}

mt_status mt_trace_ring(const mt_ring *ring, double chord, mt_arena *arena, mt_trace *t) {
    size_t n = (size_t)ring->count;
    mt_trace made = {.ring = *ring,
                     .chord = chord,
                     .length = mt_arena_new(arena, n, sizeof(double)),
                     .heading = mt_arena_new(arena, n, sizeof(double)),
                     .turn = mt_arena_new(arena, n, sizeof(double)),
                     .corner = mt_arena_new(arena, n, sizeof(bool)),
                     .line = mt_arena_new(arena, n, sizeof(bool))};
    if (!made.length || !made.heading || !made.turn || !made.corner || !made.line) return MT_NO_MEMORY;
    measure(&made);
    for (int i = 0; i < ring->count; i++) made.corner[i] = is_corner(&made, i);
    for (int i = 0; i < ring->count; i++) made.line[i] = is_line(&made, i);
    assert(mt_trace_is_valid(&made));
    *t = made;
    return MT_OK;
}

bool mt_trace_breaks(const mt_trace *t, int i) {
    return t->corner[i] || t->line[i] || t->line[mt_trace_before(t, i)];
}

bool mt_trace_extremum(const mt_trace *t, int i) {
    mt_point a = t->ring.points[mt_trace_before(t, i)], b = t->ring.points[i],
             c = t->ring.points[mt_trace_after(t, i)];
    bool in_x = (b.x > a.x && b.x > c.x) || (b.x < a.x && b.x < c.x);
    bool in_y = (b.y > a.y && b.y > c.y) || (b.y < a.y && b.y < c.y);
    return !t->corner[i] && !(t->ring.marks[i] & MT_CROSSING) && in_x != in_y;
}

/* ---- headings ------------------------------------------------------------------------------------------ */

/* The largest angle between a curve's heading and its chord, at either end: a chord of length l with angle δ bulges by l·δ/4, which
 * flattening keeps under its tolerance; a quarter more for uneven curves. 0 for a line. */
static double heading_bound(const mt_trace *t, int edge) {
    return t->line[edge] ? 0 : 5 * t->chord / t->length[edge];
}

/* At a smooth vertex: the heading of the chord between its neighbours, within the bounds of both edges. Where these do not allow it, the
 * drawing has a slight corner here. */
static double smooth_heading(const mt_trace *t, int i) {
    int h = mt_trace_before(t, i);
    double turn = fabs(t->turn[i]), before = heading_bound(t, h), after = heading_bound(t, i), share;
    if (before + after <= turn)
        share = before + after > 0 ? turn * before / (before + after) : 0;
    else
        share = fmin(before, fmax(turn - after, turn * t->length[i] / (t->length[h] + t->length[i])));
    return t->heading[h] + copysign(share, t->turn[i]);
}

/* At a corner, along chord `edge` whose other end is `vertex`: the chord's own heading, turned away by as much as at its
 * other end. */
static double corner_heading(const mt_trace *t, int edge, int vertex) {
    if (t->line[edge] || t->corner[vertex]) return t->heading[edge];
    double there = remainder(smooth_heading(t, vertex) - t->heading[edge], 2 * M_PI);
    return t->heading[edge] - there;
}

/* A heading at an end of an edge, kept within the edge's bound. */
static double along_edge(const mt_trace *t, int edge, double heading) {
    double off = remainder(heading - t->heading[edge], 2 * M_PI), most = heading_bound(t, edge);
    return t->heading[edge] + fmin(most, fmax(-most, off));
}

double mt_trace_out(const mt_trace *t, int i) {
    int j = mt_trace_after(t, i);
    return along_edge(t, i, t->corner[i] ? corner_heading(t, i, j) : smooth_heading(t, i));
}

double mt_trace_in(const mt_trace *t, int i) {
    int h = mt_trace_before(t, i);
    return along_edge(t, h, t->corner[i] ? corner_heading(t, h, h) : smooth_heading(t, i));
}

bool mt_trace_is_valid(const mt_trace *t) {
    bool valid = mt_ring_is_valid(&t->ring) && t->ring.count >= 3;
    for (int i = 0; valid && i < t->ring.count; i++) {
        bool straight = t->corner[i] && t->corner[mt_trace_after(t, i)];
        valid = t->length[i] >= 0 && fabs(t->turn[i]) <= M_PI && (t->line[i] || !straight);
    }
    return valid;
}
