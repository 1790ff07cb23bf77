#include "write/iup.h"

#include <math.h>
#include <string.h>

#include "write/extent.h"

/* How many points in a row are inferred at most. */
enum { RUN_MAX = 24 };

/* One contour; its points are counted around from the start. */
typedef struct mt_loop {
    const mt_glyf_point *points;
    const mt_move *moves;
    int count, start;
    double tolerance;
} mt_loop;

static int at(const mt_loop *loop, int k) {
    return (loop->start + k) % loop->count;
}

/* ---- what is inferred ---------------------------------------------------------------------------------- */

/* One coordinate of a point at c between two told ones, at c1 and c2, which move by d1 and d2. */
static double inferred(double c, double c1, double d1, double c2, double d2) {
    if (c1 == c2) return d1 == d2 ? d1 : 0;
    if (c1 > c2) return inferred(c, c2, d2, c1, d1);
    if (c <= c1) return d1;
    if (c >= c2) return d2;
    return d1 + (c - c1) / (c2 - c1) * (d2 - d1);
}

/* By how far point k is inferred beside its own move from points i and j, the larger of x and y. */
static double missed_by(const mt_loop *loop, int i, int j, int k) {
    const mt_glyf_point *p = &loop->points[at(loop, k)], *a = &loop->points[at(loop, i)],
                        *b = &loop->points[at(loop, j)];
    const mt_move *own = &loop->moves[at(loop, k)], *in_a = &loop->moves[at(loop, i)],
                  *in_b = &loop->moves[at(loop, j)];
    double x = inferred(p->x, a->x, in_a->x, b->x, in_b->x) - own->x;
    double y = inferred(p->y, a->y, in_a->y, b->y, in_b->y) - own->y;
    return fmax(fabs(x), fabs(y));
}

static bool suffice(const mt_loop *loop, int i, int j) {
    for (int k = i + 1; k < j; k++)
        if (missed_by(loop, i, j, k) > loop->tolerance) return false;
    return true;
}

/* ---- one contour --------------------------------------------------------------------------------------- */

static bool all_alike(const mt_loop *loop) {
    for (int k = 1; k < loop->count; k++)
        if (loop->moves[k].x != loop->moves[0].x || loop->moves[k].y != loop->moves[0].y) return false;
    return true;
}

/* The point that its neighbours tell least of: it will be told in any case. */
static int hardest(const mt_loop *loop) {
    int worst = 0;
    double most = -1;
    for (int k = 0; k < loop->count; k++) {
        double missed = missed_by(loop, k + loop->count - 1, k + 1, k);
        if (missed > most) most = missed, worst = k;
    }
    return worst;
}

/* The shortest way around from the start to itself, over told points of which each two suffice for what lies between them. */
static mt_status choose_in(mt_loop *loop, mt_arena *arena, bool *told) {
    int n = loop->count;
    int *cost = mt_arena_new(arena, (size_t)n + 1, sizeof *cost);
    int *from = mt_arena_new(arena, (size_t)n + 1, sizeof *from);
    if (!cost || !from) return MT_NO_MEMORY;
    loop->start = hardest(loop);
    for (int j = 1; j <= n; j++) {
        cost[j] = cost[j - 1] + 1;
        from[j] = j - 1;
        for (int i = j - 2; i >= 0 && i >= j - RUN_MAX - 1; i--)
            if (cost[i] + 1 < cost[j] && suffice(loop, i, j)) cost[j] = cost[i] + 1, from[j] = i;
    }
    for (int j = n; j > 0; j = from[j]) told[at(loop, from[j])] = true;
    return MT_OK;
}

static mt_status choose(mt_loop *loop, mt_arena *arena, bool *told) {
    memset(told, 0, (size_t)loop->count * sizeof *told);
    if (!all_alike(loop)) return choose_in(loop, arena, told);
    told[0] = loop->moves[0].x != 0 || loop->moves[0].y != 0; /* one point takes all others along */
    return MT_OK;
}

mt_status mt_iup_choose(const mt_glyf *glyph, const mt_move *moves, double tolerance, mt_arena *arena,
                        bool *told) {
    mt_status status = MT_OK;
    for (int i = 0, first = 0; i < glyph->contour_count && status == MT_OK; i++) {
        mt_loop loop = {glyph->points + first, moves + first, glyph->ends[i] + 1 - first, 0, tolerance};
        status = choose(&loop, arena, told + first);
        first = glyph->ends[i] + 1;
    }
    return status;
}
