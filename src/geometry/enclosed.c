/* Lines at even distances, across the rings and along them, each with the lengths at which the winding number is not 0. Lines may miss
 * what is thin along them, so that of both ways the larger is taken. O(LINES n log n) for n points. */
#include "geometry/enclosed.h"

#include <math.h>
#include <stdlib.h>

enum { LINES = 50 };

/* Where a line across rings meets an edge, and whether the edge goes up or down there. */
typedef struct mt_meeting {
    double at;
    int way;
} mt_meeting;

static int compare_meetings(const void *p, const void *q) {
    const mt_meeting *a = p, *b = q;
    return (a->at > b->at) - (a->at < b->at);
}

static int meet_ring(const mt_ring *ring, bool upright, double line, mt_meeting *meetings) {
    int count = 0;
    for (int i = 0; i < ring->count; i++) {
        mt_point p = ring->points[i], q = ring->points[(i + 1) % ring->count];
        double a = upright ? p.x : p.y, b = upright ? q.x : q.y, u = upright ? p.y : p.x,
               v = upright ? q.y : q.x;
        if ((a <= line) == (b <= line)) continue;
        meetings[count++] = (mt_meeting){u + (v - u) * (line - a) / (b - a), a <= line ? 1 : -1};
    }
    return count;
}

/* How much of a line the rings enclose. */
static double enclosed_on_line(const mt_rings *rings, bool upright, double line, mt_meeting *meetings) {
    int count = 0, winding = 0;
    double length = 0;
    for (int i = 0; i < rings->count; i++)
        count += meet_ring(&rings->rings[i], upright, line, meetings + count);
    qsort(meetings, (size_t)count, sizeof *meetings, compare_meetings);
    for (int i = 0; i + 1 < count; i++) {
        winding += meetings[i].way;
        if (winding != 0) length += meetings[i + 1].at - meetings[i].at;
    }
    return length;
}

static double enclosed(const mt_rings *rings, bool upright, double from, double to, mt_meeting *meetings) {
    double area = 0, apart = (to - from) / LINES;
    for (int i = 0; i < LINES; i++)
        area += enclosed_on_line(rings, upright, from + (i + 0.5) * apart, meetings) * apart;
    return area;
}

mt_status mt_enclosed_area(const mt_rings *rings, mt_arena *arena, double *area) {
    mt_box box = mt_ring_box(&rings->rings[0]);
    for (int i = 1; i < rings->count; i++) box = mt_box_around(box, mt_ring_box(&rings->rings[i]));
    mt_meeting *meetings = mt_arena_new(arena, (size_t)mt_rings_corners(rings), sizeof *meetings);
    if (!meetings) return MT_NO_MEMORY;
    *area = fmax(enclosed(rings, false, box.min.y, box.max.y, meetings),
                 enclosed(rings, true, box.min.x, box.max.x, meetings));
    return MT_OK;
}
