/* Candidates. A plane weighs as much as the reflex edges in it: each by its length times the sine of its angle. */
#include "solid/planes.h"

#include <stdlib.h>

#include "arithmetic/angles.h"
#include "space/vector.h"

/* Of the heaviest reflex edges so many make planes, of their planes so many are kept; slots on each axis; planes around the deepest
 * place. */
enum { EDGES = 256, KEPT = 24, SLOTS = 7, TURNS = 8, PER_EDGE = 5 };

typedef struct mt_reflex {
    int u, v; /* the cells' points */
    int edge;
    double weight;
} mt_reflex;

typedef struct mt_weighed {
    mt_plane plane;
    double weight;
    int number;
} mt_weighed;

static int heavier_edge(const void *p, const void *q) {
    const mt_reflex *x = p, *y = q;
    return x->weight != y->weight ? (x->weight < y->weight) - (x->weight > y->weight)
                                  : (x->edge > y->edge) - (x->edge < y->edge);
}

static int heavier_plane(const void *p, const void *q) {
    const mt_weighed *x = p, *y = q;
    return x->weight != y->weight ? (x->weight < y->weight) - (x->weight > y->weight)
                                  : (x->number > y->number) - (x->number < y->number);
}

/* The heaviest reflex edges; their count, or -1 when out of memory. */
static int find_reflex(mt_arena *arena, const mt_cells *cells, const mt_part *part, mt_reflex **found) {
    int n = 0;
    mt_reflex *edges = *found = mt_arena_new(arena, 3 * (size_t)part->n_triangles, sizeof *edges);
    if (!edges) return -1;
    for (int e = 0; e < 3 * part->n_triangles; e++) {
        const int *at = part->triangles[e / 3].at;
        int u = at[e % 3], v = at[(e % 3 + 1) % 3];
        if (e > part->twins[e]) continue;
        double rise = mt_part_rise(cells, part, e), back = mt_part_rise(cells, part, part->twins[e]);
        if (rise <= MT_RISE_ROUNDED || back <= MT_RISE_ROUNDED) continue;
        mt_plane p = mt_part_plane(cells, part, e / 3), q = mt_part_plane(cells, part, part->twins[e] / 3);
        double sine = mt_length3(mt_cross3(mt_plane_normal(&p), mt_plane_normal(&q)));
        double length = mt_length3(mt_minus3(part->places[u], part->places[v]));
        edges[n++] = (mt_reflex){part->point[u], part->point[v], e, length * sine};
    }
    qsort(edges, (size_t)n, sizeof *edges, heavier_edge);
    return n < EDGES ? n : EDGES;
}

static void weigh(const mt_cells *cells, const mt_reflex *edges, int n, mt_weighed *w) {
    for (int i = 0; i < n; i++)
        if (mt_plane_side(&w->plane, cells->points[edges[i].u]) == 0 &&
            mt_plane_side(&w->plane, cells->points[edges[i].v]) == 0)
            w->weight += edges[i].weight;
}

/* A reflex edge that goes on from point p, other than edge i; -1 when none does. */
static int going_on(const mt_reflex *edges, int n, int i, int p) {
    for (int k = 0; k < n; k++)
        if (k != i && (edges[k].u == p || edges[k].v == p)) return edges[k].u == p ? edges[k].v : edges[k].u;
    return -1;
}

static int planes_of_edge(const mt_cells *cells, const mt_part *part, const mt_reflex *edges, int n, int i,
                          mt_plane made[PER_EDGE]) {
    const mt_reflex *edge = &edges[i];
    mt_place u = cells->points[edge->u], v = cells->points[edge->v];
    int count = 0, next = going_on(edges, n, i, edge->v), last = going_on(edges, n, i, edge->u);
    made[count++] = mt_part_plane(cells, part, edge->edge / 3);
    made[count++] = mt_part_plane(cells, part, part->twins[edge->edge] / 3);
    mt_vector3 along = mt_minus3(mt_place_vector(v), mt_place_vector(u));
    mt_vector3 outward = mt_plus3(mt_plane_normal(&made[0]), mt_plane_normal(&made[1]));
    made[count++] = mt_plane_along(mt_cross3(along, outward), u);
    if (next >= 0) made[count++] = mt_plane_through(u, v, cells->points[next]);
    if (last >= 0) made[count++] = mt_plane_through(u, v, cells->points[last]);
    return count;
}

/* Whether two planes are the same but for rounding, or the direction of the normal. */
static bool alike(const mt_plane *p, const mt_plane *q) {
    mt_vector3 m = mt_plane_normal(p), n = mt_plane_normal(q);
    return mt_length3(mt_cross3(m, n)) < 1e-6 &&
           fabs(fabs((double)p->offset / mt_length3((mt_vector3){(double)p->x, (double)p->y, (double)p->z})) -
                fabs((double)q->offset /
                     mt_length3((mt_vector3){(double)q->x, (double)q->y, (double)q->z}))) < 2;
}

/* The share of the weight of all reflex edges that lies in each plane. */
static void share(const mt_cells *cells, const mt_reflex *edges, int n, mt_planes *planes) {
    double all = 0;
    for (int i = 0; i < n; i++) all += edges[i].weight;
    for (int i = 0; i < planes->count; i++) {
        mt_weighed plane = {planes->planes[i], 0, i};
        weigh(cells, edges, n, &plane);
        planes->resolved[i] = all > 0 ? plane.weight / all : 0;
    }
}

static mt_status add_edge_planes(mt_arena *arena, const mt_cells *cells, const mt_part *part,
                                 const mt_reflex *edges, int n, mt_planes *planes) {
    int count = 0, kept = 0;
    mt_weighed *all = mt_arena_new(arena, PER_EDGE * (size_t)n, sizeof *all);
    if (!all) return MT_NO_MEMORY;
    for (int i = 0; i < n; i++) {
        mt_plane made[PER_EDGE];
        int some = planes_of_edge(cells, part, edges, n, i, made);
        for (int k = 0; k < some; k++) {
            if (mt_plane_is_none(&made[k])) continue;
            all[count] = (mt_weighed){made[k], 0, count};
            weigh(cells, edges, n, &all[count++]);
        }
    }
    qsort(all, (size_t)count, sizeof *all, heavier_plane);
    for (int i = 0; i < count && kept < KEPT; i++) {
        bool known = false;
        for (int k = 0; k < planes->count; k++) known |= alike(&planes->planes[k], &all[i].plane);
        if (known) continue;
        planes->planes[planes->count++] = all[i].plane;
        kept++;
    }
    return MT_OK;
}

static void add_slots(const mt_part *part, mt_planes *planes) {
    mt_vector3 low = part->places[0], high = low;
    for (int i = 0; i < part->n_points; i++) {
        mt_vector3 p = part->places[i];
        low = (mt_vector3){fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z)};
        high = (mt_vector3){fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z)};
    }
    for (int i = 1; i <= SLOTS; i++) {
        mt_vector3 p = mt_between3(low, high, (double)i / (SLOTS + 1));
        mt_place at = {(int32_t)lround(p.x), (int32_t)lround(p.y), (int32_t)lround(p.z)};
        planes->planes[planes->count++] = mt_plane_at(1, 0, 0, at);
        planes->planes[planes->count++] = mt_plane_at(0, 1, 0, at);
        planes->planes[planes->count++] = mt_plane_at(0, 0, 1, at);
    }
}

/* The point of the part that is nearest to the deepest place, and planes through it that stand on the hull there. */
static void add_deep(const mt_cells *cells, const mt_part *part, const mt_depth *depth, mt_planes *planes) {
    int nearest = 0;
    double least = INFINITY;
    for (int i = 0; i < part->n_points; i++) {
        double distance = mt_length3(mt_minus3(part->places[i], depth->place));
        if (distance >= least) continue;
        least = distance;
        nearest = i;
    }
    mt_vector3 n = depth->normal, across = fabs(n.x) < 0.6 ? (mt_vector3){1, 0, 0} : (mt_vector3){0, 1, 0};
    mt_vector3 u = mt_cross3(n, across), v = mt_cross3(n, u);
    u = mt_times3(1 / mt_length3(u), u);
    v = mt_times3(1 / mt_length3(v), v);
    for (int i = 0; i < TURNS; i++) {
        double angle = M_PI * i / TURNS;
        mt_vector3 normal = mt_plus3(mt_times3(mt_cos(angle), u), mt_times3(mt_sin(angle), v));
        planes->planes[planes->count++] = mt_plane_along(normal, cells->points[part->point[nearest]]);
    }
}

mt_status mt_planes_for(mt_arena *arena, const mt_cells *cells, const mt_part *part, const mt_depth *depth,
                        mt_planes *planes) {
    size_t room = KEPT + 3 * SLOTS + TURNS;
    mt_planes made = {0, mt_arena_new(arena, room, sizeof(mt_plane)),
                      mt_arena_new(arena, room, sizeof(double))};
    mt_reflex *edges;
    int n = find_reflex(arena, cells, part, &edges);
    if (n < 0 || !made.planes || !made.resolved) return MT_NO_MEMORY;
    mt_status status = add_edge_planes(arena, cells, part, edges, n, &made);
    if (status != MT_OK) return status;
    add_slots(part, &made);
    if (depth) add_deep(cells, part, depth, &made);
    share(cells, edges, n, &made);
    *planes = made;
    return MT_OK;
}
