/* Along a direction u the ink has, up to a place, the area that the border encloses there: by Green's theorem the sum over all edges of
 * −∫ v du, v across u. Each edge adds the trapezoid under its part in each bin that it crosses, so that no drawing is rasterized.
 *
 *     v │   ╱│‾‾│╲           bins of u; an edge from left to right takes its trapezoid away,
 *       │  ╱ │  │ ╲          one from right to left adds it
 *       └─┴──┴──┴──┴── u
 */
#include "morph/check/projection.h"

#include <math.h>

#include "arithmetic/angles.h"

/* The least and greatest share of the ink whose place is kept. */
#define SHARE_LEAST 0.005
#define SHARE_MOST 0.995

typedef struct mt_place {
    double u, v;
} mt_place;

static int bin_of(double u) {
    return u < 1 ? 0 : u >= MT_BINS ? MT_BINS - 1 : (int)u;
}

/* Adds an edge to the bins; u in bins. */
static void add_edge(double bins[MT_BINS], mt_place p, mt_place q) {
    double sign = -1;
    if (p.u > q.u) {
        mt_place swap = p;
        p = q;
        q = swap;
        sign = 1;
    }
    double slope = q.u > p.u ? (q.v - p.v) / (q.u - p.u) : 0;
    int last = bin_of(q.u);
    for (int i = bin_of(p.u); i < last; i++) {
        mt_place end = {i + 1, p.v + slope * (i + 1 - p.u)};
        bins[i] += sign * (p.v + end.v) / 2 * (end.u - p.u);
        p = end;
    }
    bins[last] += sign * (p.v + q.v) / 2 * (q.u - p.u);
}

static void add_ring(double bins[MT_BINS], const mt_ring *ring, const mt_projection_frame *f, double x,
                     double y) {
    double scale = MT_BINS / (2 * f->reach);
    mt_place before = {0};
    for (int k = -1; k < ring->count; k++) {
        mt_point p = ring->points[k < 0 ? ring->count - 1 : k];
        double px = p.x - f->middle, py = p.y - f->base;
        mt_place here = {(px * x + py * y) * scale + MT_BINS / 2.0, (py * x - px * y) * scale};
        if (k >= 0) add_edge(bins, before, here);
        before = here;
    }
}

void mt_quantiles_of(const double share[MT_BINS], double reach, double place[MT_QUANTILES]) {
    int bin = 0;
    for (int i = 0; i < MT_QUANTILES; i++) {
        double wanted = SHARE_LEAST + (SHARE_MOST - SHARE_LEAST) * i / (MT_QUANTILES - 1);
        while (bin < MT_BINS - 1 && share[bin] < wanted) bin++;
        double before = bin > 0 ? share[bin - 1] : 0, within = share[bin] - before;
        double part = within > 0 ? fmin(1, fmax(0, (wanted - before) / within)) : 0;
        place[i] = (bin + part) * 2 * reach / MT_BINS - reach;
    }
}

void mt_project(const mt_rings *rings, const mt_projection_frame *frame, mt_projection *projection) {
    projection->area = (double)mt_component_area2(rings) / 2;
    for (int d = 0; d < MT_DIRECTIONS; d++) {
        double *bins = projection->share[d], angle = M_PI * d / MT_DIRECTIONS, sum = 0;
        for (int i = 0; i < MT_BINS; i++) bins[i] = 0;
        for (int i = 0; i < rings->count; i++)
            add_ring(bins, &rings->rings[i], frame, mt_cos(angle), mt_sin(angle));
        for (int i = 0; i < MT_BINS; i++) sum += bins[i];
        double so_far = 0;
        for (int i = 0; i < MT_BINS; i++) {
            so_far += bins[i];
            bins[i] = sum > 0 ? so_far / sum : 0;
        }
        mt_quantiles_of(bins, frame->reach, projection->place[d]);
    }
}
