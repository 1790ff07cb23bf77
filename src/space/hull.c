/* Hulls by libqhull_r (C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull algorithm for convex hulls", 1996). Each hull has a
 * context of its own. qh_new_qhull catches Qhull's longjmp and returns its exit code; what is called after it does not fail but for
 * want of memory. Invariant: each edge of a facet is the edge of one other facet, in the other direction. */
#include "space/hull.h"

#include <libqhull_r/qhull_ra.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct mt_qhull {
    qhT context;
    FILE *messages; /* nobody reads them */
} mt_qhull;

static mt_status status_of(int exit_code) {
    return exit_code == qh_ERRnone ? MT_OK : exit_code == qh_ERRmem ? MT_NO_MEMORY : MT_BAD_GEOMETRY;
}

/* Makes the hull; `end` is due in any case. */
static mt_status begin(mt_qhull *q, const mt_vector3 *points, int n) {
    q->messages = fopen("/dev/null", "w");
    if (!q->messages) return MT_NO_MEMORY;
    qh_zero(&q->context, q->messages);
    char command[] = "qhull Pp"; /* Pp: no reports on precision */
    return n < 4 ? MT_BAD_GEOMETRY
                 : status_of(
                       qh_new_qhull(&q->context, 3, n, (coordT *)points, False, command, NULL, q->messages));
}

static void end(mt_qhull *q) {
    int long_left, blocks;
    if (!q->messages) return;
    q->context.NOerrexit = True; /* an error in freeing does not come back here */
    qh_freeqhull(&q->context, !qh_ALL);
    qh_memfreeshort(&q->context, &long_left, &blocks);
    fclose(q->messages);
}

/* ---- facets -------------------------------------------------------------------------------------------- */

typedef struct mt_directed {
    int from, to;
} mt_directed;

static int by_ends(const void *p, const void *q) {
    const mt_directed *x = p, *y = q;
    return x->from != y->from ? (x->from > y->from) - (x->from < y->from) : (x->to > y->to) - (x->to < y->to);
}

static bool is_closed(mt_arena *arena, const mt_polytope *hull, mt_status *status) {
    mt_directed *edges = mt_arena_new(arena, (size_t)hull->n_corners, sizeof *edges);
    *status = edges ? MT_OK : MT_NO_MEMORY;
    if (!edges) return false;
    int n = 0;
    for (int f = 0; f < hull->n_facets; f++) {
        const mt_hull_facet *facet = &hull->facets[f];
        for (int i = 0; i < facet->n_corners; i++)
            edges[n++] = (mt_directed){facet->corners[i], facet->corners[(i + 1) % facet->n_corners]};
    }
    qsort(edges, (size_t)n, sizeof *edges, by_ends);
    for (int i = 0; i < n; i++) {
        mt_directed back = {edges[i].to, edges[i].from};
        bool twice = i > 0 && by_ends(&edges[i - 1], &edges[i]) == 0;
        if (twice || !bsearch(&back, edges, (size_t)n, sizeof *edges, by_ends)) return false;
    }
    return true;
}

/* The corners of one facet; Qhull has them clockwise (qh_ORIENTclock). It allocates for that, and jumps to qh->errexit when it cannot. */
static mt_status read_facet(mt_qhull *q, mt_arena *arena, facetT *facet, mt_hull_facet *made) {
    qhT *qh = &q->context;
    setT *vertices = qh_facet3vertex(qh, facet);
    int n = qh_setsize(qh, vertices);
    *made = (mt_hull_facet){n,
                            mt_arena_new(arena, (size_t)n, sizeof(int)),
                            {facet->normal[0], facet->normal[1], facet->normal[2]},
                            -facet->offset};
    for (int i = 0; made->corners && i < n; i++)
        made->corners[n - 1 - i] = qh_pointid(qh, ((vertexT *)SETelem_(vertices, i))->point);
    qh_settempfree(qh, &vertices);
    return made->corners ? MT_OK : MT_NO_MEMORY;
}

static mt_status read_facets(mt_qhull *q, mt_arena *arena, mt_polytope *hull) {
    qhT *qh = &q->context;
    facetT *facet;
    qh_getarea(qh, qh->facet_list);
    *hull = (mt_polytope){.facets = mt_arena_new(arena, (size_t)qh->num_facets, sizeof(mt_hull_facet)),
                          .volume = qh->totvol};
    if (!hull->facets) return MT_NO_MEMORY;
    FORALLfacets {
        mt_hull_facet *made = &hull->facets[hull->n_facets];
        if (read_facet(q, arena, facet, made) != MT_OK) return MT_NO_MEMORY;
        hull->n_facets++;
        hull->n_corners += made->n_corners;
    }
    return MT_OK;
}

/* The same, where Qhull's jumps come back to. */
static mt_status read_guarded(mt_qhull *q, mt_arena *arena, mt_polytope *hull) {
    int exit_code = setjmp(q->context.errexit);
    if (exit_code) return status_of(exit_code);
    q->context.NOerrexit = False;
    mt_status status = read_facets(q, arena, hull);
    q->context.NOerrexit = True;
    return status;
}

mt_status mt_polytope_around(mt_arena *arena, const mt_vector3 *points, int n, mt_polytope *hull) {
    mt_qhull *q = mt_arena_new(arena, 1, sizeof *q);
    mt_polytope made = {0};
    if (!q) return MT_NO_MEMORY;
    mt_status status = begin(q, points, n);
    if (status == MT_OK) status = read_guarded(q, arena, &made);
    end(q);
    if (status == MT_OK && !is_closed(arena, &made, &status) && status == MT_OK) status = MT_BAD_GEOMETRY;
    if (status == MT_OK) *hull = made;
    return status;
}

static mt_status read_volume(mt_qhull *q, double *volume) {
    int exit_code = setjmp(q->context.errexit);
    if (exit_code) return status_of(exit_code);
    q->context.NOerrexit = False;
    qh_getarea(&q->context, q->context.facet_list);
    *volume = q->context.totvol;
    q->context.NOerrexit = True;
    return MT_OK;
}

mt_status mt_hull_volume(const mt_vector3 *points, int n, double *volume) {
    mt_qhull *q = mt_new(1, sizeof *q);
    if (!q) return MT_NO_MEMORY;
    mt_status status = begin(q, points, n);
    if (status == MT_OK) status = read_volume(q, volume);
    end(q);
    mt_free(q);
    if (status != MT_BAD_GEOMETRY) return status;
    *volume = 0;
    return MT_OK;
}
