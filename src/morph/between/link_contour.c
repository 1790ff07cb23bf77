/* Formula (4) for one link and all r at once. The corners of rP ⊕ (1 − r)Q are sums of the same vertices p and q for all 0 < r < 1:
 *
 *     P ◣  ⊕  Q ■  =  corners (p0,q0) (p0,q1) (p1,q1) (p1,q2) …     in the order of the edges' directions (minkowski.c);
 *                                                                   one master stays at its vertex while the other advances
 *
 * So the masters are the corners' p and the corners' q, and runs between breaks are fitted to both at once, as in fit/contour_pair.c.
 * Invariant: at r = 1 the contour is P, at r = 0 Q, within the tolerance. O(n + m) for n and m vertices, but for mt_spline. */
#include "morph/between/link_contour.h"

#include <assert.h>

#include "geometry/spline.h"
#include "morph/align/align.h"

typedef struct mt_sum {
    mt_ring_samples samples[2];
    int count; /* of the corners */
    mt_corner *corners;
} mt_sum;

static const mt_ring_sample *sample_at(const mt_sum *sum, int master, int k) {
    const mt_corner *corner = &sum->corners[k % sum->count];
    return &sum->samples[master].samples[master == 0 ? corner->p : corner->q];
}

/* Whether the master stays at its vertex from corner k - 1 to corner k. */
static bool waits(const mt_sum *sum, int master, int k) {
    return sample_at(sum, master, k + sum->count) == sample_at(sum, master, k + sum->count - 1);
}

/* Whether a run ends at corner k: a piece has a corner or a line's end there, and does not stay at it on both sides of k. */
static bool breaks(const mt_sum *sum, int k) {
    for (int master = 0; master < 2; master++)
        if (sample_at(sum, master, k)->breaks && !(waits(sum, master, k) && waits(sum, master, k + 1)))
            return true;
    return false;
}

static void sample_run(const mt_sum *sum, int master, int first, int count, mt_sample *samples) {
    for (int k = 0; k <= count; k++) {
        const mt_ring_sample *sample = sample_at(sum, master, first + k);
        samples[k] = mt_sample_at(sample->x, sample->y, k < count ? sample->out : sample->in, false);
    }
}

static mt_status fit_run(const mt_sum *sum, int first, int count, double tolerance, mt_arena *arena,
                         mt_contour_pair *m) {
    mt_sample *a = mt_arena_new(arena, (size_t)count + 1, sizeof *a);
    mt_sample *b = mt_arena_new(arena, (size_t)count + 1, sizeof *b);
    int *ends = mt_arena_new(arena, (size_t)count + 1, sizeof *ends);
    if (!a || !b || !ends) return MT_NO_MEMORY;
    sample_run(sum, 0, first, count, a);
    sample_run(sum, 1, first, count, b);
    const mt_sample *masters[] = {a, b};
    mt_segment *segments[] = {m->a.segments + m->a.count, m->b.segments + m->b.count};
    int made;
    mt_status status = mt_spline(masters, 2, count + 1, tolerance, arena, segments, ends, &made);
    if (status != MT_OK) return status;
    m->a.count += made;
    m->b.count += made;
    return MT_OK;
}

static mt_status list_corners(const mt_ring *p, const mt_ring *q, double flatness, mt_arena *arena,
                              mt_sum *sum) {
    enum { VERTICES_ONLY = 1 };
    sum->corners = mt_arena_new(arena, (size_t)p->count + (size_t)q->count, sizeof *sum->corners);
    if (!sum->corners) return MT_NO_MEMORY;
    sum->count = mt_minkowski_corners(p, q, sum->corners);
    mt_status status = mt_ring_samples_at_least(p, flatness, VERTICES_ONLY, arena, &sum->samples[0]);
    return status == MT_OK ? mt_ring_samples_at_least(q, flatness, VERTICES_ONLY, arena, &sum->samples[1])
                           : status;
}

mt_status mt_link_contour(const mt_ring *p, const mt_ring *q, double flatness, double tolerance,
                          mt_arena *arena, mt_contour_pair *masters) {
    mt_sum sum;
    mt_status status = list_corners(p, q, flatness, arena, &sum);
    if (status != MT_OK) return status;
    mt_contour_pair made = {{0, mt_arena_new(arena, (size_t)sum.count, sizeof(mt_segment))},
                            {0, mt_arena_new(arena, (size_t)sum.count, sizeof(mt_segment))},
                            {0, 0}};
    if (!made.a.segments || !made.b.segments) return MT_NO_MEMORY;
    int start = 0;
    while (start < sum.count && !breaks(&sum, start)) start++;
    start %= sum.count; /* smooth all around: from the lowest points */
    for (int done = 0; done < sum.count;) {
        int count = 1;
        while (done + count < sum.count && !breaks(&sum, start + done + count)) count++;
        status = fit_run(&sum, (start + done) % sum.count, count, tolerance, arena, &made);
        if (status != MT_OK) return status;
        done += count;
    }
    assert(mt_contour_pair_is_valid(&made));
    *masters = made;
    return MT_OK;
}
