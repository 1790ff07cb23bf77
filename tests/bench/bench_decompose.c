/* How the time of a decomposition grows with the number of vertices, 10² to 10⁵ of them, and the slope of the line
 * through (log n, log time). Aim: at most 1.2 on shapes like drawn ones: noisy rounds, combs, spirals. Needles are the
 * worst case: teeth so long and thin that each edge crosses most of a Delaunay triangulation's strips. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/clock.h"
#include "geometry/decompose.h"
#include "geometry/limits.h"
#include "support/random.h"

static const int counts[] = {100, 300, 1000, 3000, 10000, 30000, 100000};
enum { SIZES = sizeof counts / sizeof *counts, RUNS = 3 };

static mt_arena arena;

typedef mt_point (*place)(mt_random *random, int i, int n);

static mt_point polar(double angle, double radius) {
    return (mt_point){(int32_t)lround(radius * cos(angle)), (int32_t)lround(radius * sin(angle))};
}

/* Angles grow from vertex to vertex, so that nothing crosses. */
static mt_point on_round(mt_random *random, int i, int n) {
    return polar(2 * M_PI * i / n, MT_COORD_MAX * (0.7 + 0.3 * mt_random_unit(random)));
}

/* Teeth along the top, up to `reach` high, a straight edge below. */
static mt_point on_teeth(mt_random *random, int i, int n, int reach) {
    int far = MT_COORD_MAX - 1, step = 2 * far / n;
    if (i < 2) return (mt_point){i == 0 ? -far : far, -far};
    int height = i % 2 ? mt_random_between(random, 0, reach < far ? reach : far) : -step;
    return (mt_point){far - (i - 2) * step, height};
}

static mt_point on_comb(mt_random *random, int i, int n) {
    return on_teeth(random, i, n, 20 * (2 * MT_COORD_MAX / n));
}

static mt_point on_needles(mt_random *random, int i, int n) {
    return on_teeth(random, i, n, MT_COORD_MAX);
}

/* A band wound up, ten turns of it, out and back. */
static mt_point on_spiral(mt_random *random, int i, int n) {
    (void)random;
    bool out = i < n / 2;
    double at = (out ? i + 0.5 : n - 0.5 - i) * 2 / n, pitch = MT_COORD_MAX / 12.0;
    return polar(20 * M_PI * at, pitch * (1 + 10 * at) + (out ? pitch / 2 : 0));
}

static double time_of(place where, int count) {
    mt_random random = mt_random_case(count);
    mt_ring ring;
    mt_component component = {1, &ring};
    double best = INFINITY;
    for (int run = 0; run < RUNS; run++) {
        mt_pieces pieces;
        mt_arena_reset(&arena);
        if (mt_ring_new(&arena, count, &ring) != MT_OK) exit(1);
        for (int i = 0; i < count; i++) ring.points[i] = where(&random, i, count);
        double start = mt_clock();
        mt_status status = mt_decompose(&component, &arena, &pieces);
        best = fmin(best, mt_clock() - start);
        if (status != MT_OK) {
            fprintf(stderr, "%d vertices: %s\n", count, mt_status_text(status));
            exit(1);
        }
    }
    return best;
}

/* Least squares of log time over log n. */
static double exponent(const double *times) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int i = 0; i < SIZES; i++) {
        double x = log(counts[i]), y = log(times[i]);
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    return (SIZES * sxy - sx * sy) / (SIZES * sxx - sx * sx);
}

int main(void) {
    static const struct {
        const char *name;
        place where;
    } kinds[] = {{"round", on_round}, {"comb", on_comb}, {"spiral", on_spiral}, {"needles", on_needles}};
    enum { KINDS = sizeof kinds / sizeof *kinds };
    double times[KINDS][SIZES];
    printf("decomposition, microseconds\n%10s", "vertices");
    for (int k = 0; k < KINDS; k++) printf(" %12s", kinds[k].name);
    printf("\n");
    for (int i = 0; i < SIZES; i++) {
        printf("%10d", counts[i]);
        for (int k = 0; k < KINDS; k++) printf(" %12.0f", times[k][i] = time_of(kinds[k].where, counts[i]));
        printf("\n");
    }
    printf("%10s", "exponent");
    for (int k = 0; k < KINDS; k++) printf(" %12.3f", exponent(times[k]));
    printf("\n");
    mt_arena_release(&arena);
    return 0;
}
