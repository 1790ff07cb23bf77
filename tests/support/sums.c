#include "support/sums.h"

#include "support/check.h"

#include <math.h>

int mt_sums_hull(const mt_ring *p, const mt_ring *q, mt_weights weights, mt_spot *hull) {
    mt_spot *sums = mt_test_new((size_t)p->count * (size_t)q->count, sizeof *sums);
    int n = 0;
    for (int i = 0; i < p->count; i++)
        for (int j = 0; j < q->count; j++) {
            mt_spot a = mt_spot_of(p->points[i], weights.a), b = mt_spot_of(q->points[j], weights.b);
            sums[n++] = (mt_spot){a.x + b.x, a.y + b.y};
        }
    int count = mt_oracle_hull(sums, n, hull);
    free(sums);
    return count;
}

/* A component as spots, edge by edge. */
typedef struct outline {
    int count;
    mt_spot *from, *to;
} outline;

/* offset + factor × component. A negative factor turns it by half a turn, so that left stays left. */
static outline outline_of(const mt_component *component, int64_t factor, mt_spot offset) {
    int n = 0;
    for (int r = 0; r < component->count; r++) n += component->rings[r].count;
    outline made = {0, mt_test_new((size_t)n, sizeof(mt_spot)), mt_test_new((size_t)n, sizeof(mt_spot))};
    for (int r = 0; r < component->count; r++) {
        const mt_ring *ring = &component->rings[r];
        for (int i = 0; i < ring->count; i++, made.count++) {
            mt_spot a = mt_spot_of(ring->points[i], factor),
                    b = mt_spot_of(ring->points[(i + 1) % ring->count], factor);
            made.from[made.count] = (mt_spot){a.x + offset.x, a.y + offset.y};
            made.to[made.count] = (mt_spot){b.x + offset.x, b.y + offset.y};
        }
    }
    return made;
}

static void give_back(outline *o) {
    free(o->from);
    free(o->to);
}

static bool holds(const outline *o, mt_spot spot) {
    int winding = 0;
    for (int i = 0; i < o->count; i++) {
        mt_spot a = o->from[i], b = o->to[i];
        if (a.y <= spot.y && b.y > spot.y) winding += mt_oracle_orient(a, b, spot) > 0;
        if (a.y > spot.y && b.y <= spot.y) winding -= mt_oracle_orient(a, b, spot) < 0;
    }
    return winding != 0;
}

static double spot_distance(mt_spot p, mt_spot a, mt_spot b) {
    return mt_oracle_segment_distance((double)p.x, (double)p.y, (double)a.x, (double)a.y, (double)b.x,
                                      (double)b.y);
}

/* Between two segments that do not meet, one of the four ends is nearest. */
static double segments_apart(mt_spot a, mt_spot b, mt_spot c, mt_spot d) {
    return fmin(fmin(spot_distance(a, c, d), spot_distance(b, c, d)),
                fmin(spot_distance(c, a, b), spot_distance(d, a, b)));
}

static double apart(const outline *p, const outline *q) {
    if (p->count == 0 || q->count == 0) return INFINITY;
    if (holds(p, q->from[0]) || holds(q, p->from[0])) return 0;
    for (int i = 0; i < p->count; i++)
        for (int k = 0; k < q->count; k++)
            if (mt_oracle_meet(p->from[i], p->to[i], q->from[k], q->to[k])) return 0;
    double best = INFINITY;
    for (int i = 0; i < p->count; i++)
        for (int k = 0; k < q->count; k++)
            best = fmin(best, segments_apart(p->from[i], p->to[i], q->from[k], q->to[k]));
    return best;
}

double mt_sums_distance(const mt_shape *a, const mt_shape *b, mt_weights weights, mt_point x) {
    double best = INFINITY;
    for (int i = 0; i < a->count; i++)
        for (int j = 0; j < b->count && best > 0; j++) {
            outline p = outline_of(&a->components[i], weights.a, (mt_spot){0, 0});
            outline q = outline_of(&b->components[j], -(int64_t)weights.b, mt_spot_of(x, MT_WEIGHT_ONE));
            best = fmin(best, apart(&p, &q) / MT_WEIGHT_ONE);
            give_back(&p);
            give_back(&q);
        }
    return best;
}
