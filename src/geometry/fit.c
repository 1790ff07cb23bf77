/* From rings back to contours. The vertices lie on the curves that the drawing had, since flattening puts
 * them there, so that fitting through them gives the curves back rather than their chords.
 *
 *   1. Bridge the dents where two neighbouring sums of a union meet.
 *   2. Tell corners from smooth vertices and lines from chords (trace.h).
 *   3. Fit a quadratic spline (spline.h) to each run of chords between corners and lines.
 *
 *     ●───────●╮ × ╭╮     ● corners and ends of lines: runs end here     × a crossing, MT_DENT deep at most: a dent
 *      line   run ╰╯ run
 *
 * Invariant: a contour passes through the ends of all runs. O(n) for n vertices, but for mt_spline. */
#include <assert.h>
#include <math.h>

#include "geometry/limits.h"
#include "geometry/outline.h"
#include "geometry/spline.h"
#include "geometry/trace.h"

/* ---- 1: dents ------------------------------------------------------------------------------------------ */

/* A crossing that turns right, into the ink, between its neighbours and no deeper than MT_DENT under the line that joins them. */
static bool is_dent(mt_point a, mt_point b, mt_point c, uint8_t mark) {
    int64_t deep = -mt_orient(a, b, c);
    bool between = mt_dot(a, b, a, c) > 0 && mt_dot(c, b, c, a) > 0;
    if (!(mark & MT_CROSSING) || deep <= 0 || !between) return false;
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

/* ---- 3: runs ------------------------------------------------------------------------------------------- */

/* The run of `count` chords from vertex `first` on, as count + 1 samples. */
static void sample_run(const mt_trace *t, int first, int count, mt_sample *samples) {
    int i = first;
    for (int k = 0; k <= count; k++, i = mt_trace_after(t, i)) {
        double heading = k < count ? mt_trace_out(t, i) : mt_trace_in(t, i);
        bool node = !mt_trace_breaks(t, i) && mt_trace_extremum(t, i);
        samples[k] = mt_sample_at(t->ring.points[i].x, t->ring.points[i].y, heading, node);
    }
}

static int run_length(const mt_trace *t, int first) {
    int count = 1, i = mt_trace_after(t, first);
    while (!mt_trace_breaks(t, i) && i != first) {
        count++;
        i = mt_trace_after(t, i);
    }
    return count;
}

static mt_status fit_run(const mt_trace *t, int first, int count, double tolerance, mt_arena *arena,
                         mt_contour *contour) {
    mt_sample *samples = mt_arena_new(arena, (size_t)count + 1, sizeof *samples);
    int *ends = mt_arena_new(arena, (size_t)count, sizeof *ends);
    if (!samples || !ends) return MT_NO_MEMORY;
    sample_run(t, first, count, samples);
    const mt_sample *masters[] = {samples};
    mt_segment *segments[] = {contour->segments + contour->count};
    int made;
    mt_status status = mt_spline(masters, 1, count + 1, tolerance, arena, segments, ends, &made);
    if (status == MT_OK) contour->count += made;
    return status;
}

static mt_status fit_ring(const mt_trace *t, double tolerance, mt_arena *arena, mt_contour *contour) {
    int start = 0;
    while (start < t->ring.count && !mt_trace_breaks(t, start)) start++;
    if (start == t->ring.count) start = 0; /* smooth all around: from the lowest point, an extremum */
    *contour = (mt_contour){0, mt_arena_new(arena, (size_t)t->ring.count, sizeof(mt_segment))};
    if (!contour->segments) return MT_NO_MEMORY;
    for (int done = 0, i = start; done < t->ring.count;) {
        int count = t->line[i] ? 1 : run_length(t, i);
        int end = (i + count) % t->ring.count;
        if (t->line[i]) {
            contour->segments[contour->count++] = (mt_segment){.degree = 1, .end = t->ring.points[end]};
        } else {
            mt_status status = fit_run(t, i, count, tolerance, arena, contour);
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
        mt_trace trace;
        mt_status status = bridge_dents(ring, arena, &clean);
        if (status == MT_OK && clean.count < 3) continue;
        if (status == MT_OK) status = mt_trace_ring(&clean, chord, arena, &trace);
        if (status == MT_OK) status = fit_ring(&trace, tolerance, arena, &made.contours[made.count]);
        if (status != MT_OK) return status;
        made.count++;
    }
    assert(mt_outline_is_valid(&made));
    *outline = made;
    return MT_OK;
}

bool mt_contour_is_valid(const mt_contour *contour) {
    bool valid = contour->count >= 1;
    for (int i = 0; valid && i < contour->count; i++)
        valid = contour->segments[i].degree >= 1 && contour->segments[i].degree <= 3;
    return valid;
}

bool mt_outline_is_valid(const mt_outline *outline) {
    bool valid = outline->count >= 0;
    for (int i = 0; valid && i < outline->count; i++) valid = mt_contour_is_valid(&outline->contours[i]);
    return valid;
}
