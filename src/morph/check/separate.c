/* Separating parts that touch in between though their components are apart at both ends.
 *
 *     A ▐ ▌     T = 0.5  █     B ▐ ▌       clusters: contours that share a component at either end, and keep together
 *                                          two clusters touch where both together have fewer components than one by one
 *
 * The smaller cluster is displaced half-way by the shortest of the displacements (contour_origin.c) with which the two touch nowhere and the
 * morph has less error; where none helps, the larger. Invariants: those of mend.c; a cluster is displaced once. For k clusters O(k²)
 * pairs whose boxes meet, each with up to 48 displacements at 19 places. */
#include "morph/check/separate.h"

#include <math.h>

#include "geometry/limits.h"
#include "morph/check/contour_origin.h"
#include "morph/fit/contour_pair.h"

/* Contours in clusters: those that share a component at either end. */
typedef struct mt_clusters {
    mt_mending *m;
    bool *displaced; /* of each cluster */
    int *of;         /* of each contour, the cluster: the number of its first contour */
    double *area;    /* of each cluster, half-way, grid units squared */
    mt_box *boxes;   /* of each cluster, for all T */
    int *alone;      /* of each cluster, its components at each place; 0: not counted yet */
} mt_clusters;

/* ---- clusters ------------------------------------------------------------------------------------------------ */

static void unite(int *of, int count, int i, int k) {
    int low = of[i] < of[k] ? of[i] : of[k], high = of[i] < of[k] ? of[k] : of[i];
    for (int c = 0; c < count; c++)
        if (of[c] == high) of[c] = low;
}

static bool boxes_meet(mt_box p, mt_box q) {
    return p.min.x <= q.max.x && q.min.x <= p.max.x && p.min.y <= q.max.y && q.min.y <= p.max.y;
}

static void extend_box(mt_box *box, mt_point p) {
    *box = mt_box_around(*box, (mt_box){p, p});
}

/* The box that contains a contour at all T, without displacement. */
static mt_box swept_box(const mt_contour_pair *m) {
    mt_box box = {m->a.segments[0].end, m->a.segments[0].end};
    for (int s = 0; s < 2; s++) {
        const mt_contour *contour = s == 0 ? &m->a : &m->b;
        for (int i = 0; i < contour->count; i++) {
            extend_box(&box, contour->segments[i].end);
            if (contour->segments[i].degree == 2) extend_box(&box, contour->segments[i].control[0]);
        }
    }
    return box;
}

static mt_status gather(mt_mending *mending, mt_clusters *clusters) {
    const mt_morph *m = mending->morph;
    mt_arena *arena = mending->arena;
    size_t count = (size_t)m->contour_count;
    mt_contour_origins origins;
    *clusters = (mt_clusters){.m = mending,
                              .displaced = mt_arena_new(arena, count, sizeof(bool)),
                              .of = mt_arena_new(arena, count, sizeof(int)),
                              .area = mt_arena_new(arena, count, sizeof(double)),
                              .boxes = mt_arena_new(arena, count, sizeof(mt_box)),
                              .alone = mt_arena_new(arena, count, MT_TOPOLOGY_STEPS * sizeof(int))};
    if (!clusters->displaced || !clusters->of || !clusters->area || !clusters->boxes || !clusters->alone)
        return MT_NO_MEMORY;
    mt_status status = mt_contour_origins_of(m, arena, &origins);
    if (status != MT_OK) return status;
    for (int i = 0; i < m->contour_count; i++) {
        clusters->of[i] = i;
        for (int k = 0; k < i; k++)
            if (clusters->of[i] != clusters->of[k] && mt_same_origin(&origins, i, k))
                unite(clusters->of, i + 1, i, k);
    }
    for (int i = 0; i < m->contour_count; i++) clusters->boxes[i] = swept_box(&m->contours[i]);
    for (int i = 0; i < m->contour_count; i++) {
        int head = clusters->of[i];
        clusters->area[head] += mt_contour_pair_area(&m->contours[i]);
        clusters->boxes[head] = mt_box_around(clusters->boxes[head], clusters->boxes[i]);
    }
    return MT_OK;
}

/* ---- touching ------------------------------------------------------------------------------------------------ */

/* The contours of one cluster, or of two, at one place. */
static mt_status rings_of(const mt_clusters *c, int one, int other, double t, mt_rings *rings) {
    const mt_mending *m = c->m;
    mt_outline outline = {0, mt_arena_new(m->arena, (size_t)m->morph->contour_count, sizeof(mt_contour))};
    mt_status status = outline.contours ? MT_OK : MT_NO_MEMORY;
    for (int i = 0; status == MT_OK && i < m->morph->contour_count; i++)
        if (c->of[i] == one || c->of[i] == other)
            status = mt_contour_pair_mix(&m->morph->contours[i], mt_weights_at(t), m->arena,
                                         &outline.contours[outline.count++]);
    return status == MT_OK ? mt_flatten(&outline, mt_grid_units(m->params->tolerance), m->arena, rings)
                           : status;
}

/* The number of their components. */
static mt_status components_of(const mt_clusters *c, int one, int other, int place, int *count) {
    mt_arena_place before = mt_arena_mark(c->m->arena);
    mt_rings rings;
    mt_shape shape;
    mt_status status = rings_of(c, one, other, mt_topology_position(c->m->morph, place), &rings);
    if (status == MT_OK) status = mt_mend_union(c->m, &rings, MT_POSITIVE, &shape);
    if (status == MT_OK) *count = mt_topology_of(&shape).components;
    mt_arena_rewind(c->m->arena, before);
    return status;
}

/* Those of a cluster by itself; a displacement does not change them. */
static mt_status count_alone(const mt_clusters *c, int cluster, int place, int *count) {
    int *counted = &c->alone[cluster * MT_TOPOLOGY_STEPS + place];
    mt_status status = *counted == 0 ? components_of(c, cluster, cluster, place, counted) : MT_OK;
    *count = *counted;
    return status;
}

static mt_status touch_at(const mt_clusters *c, int p, int q, int place, bool *touch) {
    int alone = 0, beside = 0, together = 0;
    mt_status status = count_alone(c, p, place, &alone);
    if (status == MT_OK) status = count_alone(c, q, place, &beside);
    if (status == MT_OK) status = components_of(c, p, q, place, &together);
    *touch = together < alone + beside;
    return status;
}

/* Whether two clusters touch at any place between the ends. */
static mt_status do_touch(const mt_clusters *c, int p, int q, bool *touch) {
    mt_status status = MT_OK;
    *touch = false;
    if (!boxes_meet(c->boxes[p], c->boxes[q])) return MT_OK;
    for (int i = 0; status == MT_OK && !*touch && i < MT_TOPOLOGY_STEPS; i++)
        status = touch_at(c, p, q, i, touch);
    return status;
}

/* ---- displacing ---------------------------------------------------------------------------------------------- */

/* Displaces a cluster that touches another by as little as keeps the two apart and leaves less error, unless it is displaced already. */
static mt_status displace(const mt_clusters *c, int cluster, int other) {
    for (int i = 0; i < MT_DISPLACEMENTS && !c->displaced[cluster] && mt_mend_goes_on(c->m); i++) {
        bool touch, better = false;
        mt_point to = mt_displacement(i);
        mt_shift(c->m->morph, c->of, cluster, to);
        mt_status status = do_touch(c, cluster, other, &touch);
        if (status == MT_OK && !touch) status = mt_mend_compare(c->m, &better);
        c->displaced[cluster] = better;
        if (!better) mt_shift(c->m->morph, c->of, cluster, (mt_point){-to.x, -to.y});
        if (status != MT_OK) return status;
    }
    return MT_OK;
}

/* Separates two clusters where they touch: displaces the smaller or, where that does not help, the larger. */
static mt_status separate(const mt_clusters *c, int p, int q) {
    bool touch;
    mt_status status = do_touch(c, p, q, &touch);
    if (status != MT_OK || !touch) return status;
    int small = fabs(c->area[p]) <= fabs(c->area[q]) ? p : q, large = p + q - small,
        before = c->m->error.parts;
    status = displace(c, small, large);
    return status == MT_OK && c->m->error.parts == before ? displace(c, large, small) : status;
}

mt_status mt_separate_parts(mt_mending *m) {
    mt_clusters clusters;
    mt_status status = gather(m, &clusters);
    for (int q = 1; status == MT_OK && q < m->morph->contour_count; q++)
        for (int p = 0; status == MT_OK && p < q && mt_mend_goes_on(m); p++)
            if (clusters.of[p] == p && clusters.of[q] == q) status = separate(&clusters, p, q);
    return status;
}
