/* The boundary of a sum of polytopes has three kinds of faces: a facet of x at the point of y that lies farthest in its direction, a
 * facet of y at such a point of x, and parallelograms, an edge of x with an edge of y. Here they come from one walk over x:
 *
 *     a triangle of x       at the point of y that is farthest in the direction of its facet of the hull
 *     an edge of x          times the way over y's surface between the points that its two triangles have
 *     a point of x          with the part of y's surface that those ways go around, one for each edge at the point
 *
 *          T1 at y1                     y1 ──── y2
 *       ──────────── edge                │ part │        a point's edges lead around that part of y
 *          T2 at y2                     y4 ──── y3
 *
 * (the cells of the first complex mapped to chains of the second). Each edge of a face is so an edge of another whatever the points and
 * ways are: the mesh is closed by construction, and rounding can at worst make it bulge by what it rounds.
 *
 * Where a facet of x is parallel to an edge or a facet of y, several points are the farthest. x's directions are turned by a tiny angle
 * about a fixed axis, so that one of them is, and neighbours agree which. Positions stay as they are.
 *
 * O(n log n + k m) for n faces of the sum, k corners of x's hull and m triangles of y. */
#include "solid/sum.h"

#include <stdint.h>
#include <stdlib.h>

#include "space/vector.h"

/* By how much the directions are turned: in a solid of 2^24 grid units it moves no point by more than two. */
#define TURN 1e-7

typedef struct mt_way {
    int n_steps;
    int *steps; /* edges of y's surface */
} mt_way;

/* The way from the point of facet f to that of facet g; f < g. */
typedef struct mt_known_way {
    int f, g;
    mt_way way;
    bool known;
} mt_known_way;

/* A parallelogram: an edge of x times an edge of y, so many times; with either edge the other way it is inside out. */
typedef struct mt_side_face {
    int x, y, times; /* edges of both surfaces, of each and its twin the lower */
} mt_side_face;

typedef struct mt_summing {
    const mt_piece *x, *y;
    mt_arena *arena;
    mt_vector3 *directions; /* of x's facets, turned */
    int *farthest;          /* of x's facets: the point of y */
    mt_known_way *ways;     /* a hash table */
    size_t ways_mask;
    int *leaving;               /* of x's points: an edge that starts there */
    int *weights, *net, *stack; /* of y's triangles; of its edges; of its triangles */
    bool *seen;
    int n_sides, sides_room;
    mt_side_face *sides;
    int n_corners, corners_room;
    uint64_t *corners; /* of the triangles made: x's point, then y's in the lower half */
} mt_summing;

/* ---- farthest points, and ways between them ------------------------------------------------------------ */

static int other_end(const mt_ridge *ridge, int point) {
    return ridge->u == point ? ridge->v : ridge->u;
}

/* The corner of y's hull that is the farthest in a direction; the first of equals. */
static int farthest_in(const mt_piece *y, mt_vector3 direction) {
    int found = -1;
    double most = -INFINITY;
    for (int p = 0; p < y->part.n_points; p++) {
        if (y->first_ridge[p] == y->first_ridge[p + 1]) continue;
        double far = mt_dot3(direction, y->part.places[p]);
        if (far <= most) continue;
        most = far;
        found = p;
    }
    return found;
}

static mt_status find_directions(mt_summing *s) {
    const mt_polytope *hull = &s->x->hull;
    const mt_vector3 axis = {0.3179, 0.5483, 0.7735};
    s->directions = mt_arena_new(s->arena, (size_t)hull->n_facets, sizeof *s->directions);
    s->farthest = mt_arena_new(s->arena, (size_t)hull->n_facets, sizeof *s->farthest);
    if (!s->directions || !s->farthest) return MT_NO_MEMORY;
    for (int f = 0; f < hull->n_facets; f++) {
        mt_vector3 normal = hull->facets[f].normal;
        s->directions[f] = mt_plus3(normal, mt_times3(TURN, mt_cross3(axis, normal)));
        s->farthest[f] = farthest_in(s->y, s->directions[f]);
    }
    return MT_OK;
}

/* The ridge at `from` that is crossed first when the direction goes from that of facet f to that of g, or -1 at the end. */
static int next_ridge(const mt_summing *s, int f, int g, int from) {
    const mt_vector3 *places = s->y->part.places;
    double least = INFINITY;
    int found = -1;
    for (int i = s->y->first_ridge[from]; i < s->y->first_ridge[from + 1]; i++) {
        int ridge = s->y->ridges_at[i];
        mt_vector3 along = mt_minus3(places[other_end(&s->y->ridges[ridge], from)], places[from]);
        double at_f = fmin(mt_dot3(s->directions[f], along), 0), at_g = mt_dot3(s->directions[g], along);
        if (at_g <= 0) continue;
        double when = at_f / (at_f - at_g);
        if (when >= least) continue;
        least = when;
        found = ridge;
    }
    return found;
}

static mt_status append_ridge(mt_summing *s, mt_way *way, int *room, int ridge, bool forward) {
    const mt_ridge *r = &s->y->ridges[ridge];
    const int *twins = s->y->part.twins;
    for (int i = 0; i < r->n_steps; i++) {
        int step = forward ? r->steps[i] : twins[r->steps[r->n_steps - 1 - i]];
        if (way->n_steps > 0 && way->steps[way->n_steps - 1] == twins[step]) {
            way->n_steps--; /* there and back is nowhere */
            continue;
        }
        way->steps = mt_arena_grow_list(s->arena, way->steps, way->n_steps, room, sizeof(int));
        if (!way->steps) return MT_NO_MEMORY;
        way->steps[way->n_steps++] = step;
    }
    return MT_OK;
}

/* The rest of the way, over as few ridges as there can be: where facets are parallel but for rounding, the walk may end beside its goal. */
static mt_status append_rest(mt_summing *s, mt_way *way, int *room, int from, int to) {
    const mt_piece *y = s->y;
    int *by = mt_arena_new(s->arena, (size_t)y->part.n_points,
                           sizeof *by); /* the ridge that led to each point, from 1 */
    int *line = mt_arena_new(s->arena, (size_t)y->part.n_points, sizeof *line), n = 0;
    if (!by || !line) return MT_NO_MEMORY;
    line[n++] = to;
    for (int i = 0; i < n && line[i] != from; i++)
        for (int k = y->first_ridge[line[i]]; k < y->first_ridge[line[i] + 1]; k++) {
            int next = other_end(&y->ridges[y->ridges_at[k]], line[i]);
            if (by[next] || next == to) continue;
            by[next] = y->ridges_at[k] + 1;
            line[n++] = next;
        }
    mt_status status = MT_OK;
    for (int p = from; status == MT_OK && p != to; p = other_end(&y->ridges[by[p] - 1], p))
        status = by[p] ? append_ridge(s, way, room, by[p] - 1, y->ridges[by[p] - 1].u == p) : MT_BAD_GEOMETRY;
    return status;
}

/* The way from the point of f to that of g, over the points in between that are the farthest in between. Each step leads farther in the
 * direction of g, so it ends. */
static mt_status find_way(mt_summing *s, int f, int g, mt_way *way) {
    int here = s->farthest[f], room = 0;
    mt_status status = MT_OK;
    for (int ridge; status == MT_OK && here != s->farthest[g] && (ridge = next_ridge(s, f, g, here)) >= 0;) {
        status = append_ridge(s, way, &room, ridge, s->y->ridges[ridge].u == here);
        here = other_end(&s->y->ridges[ridge], here);
    }
    return status == MT_OK && here != s->farthest[g] ? append_rest(s, way, &room, here, s->farthest[g])
                                                     : status;
}

static mt_known_way *slot_of(const mt_summing *s, int f, int g) {
    size_t at = ((uint64_t)f * 0x9E3779B97F4A7C15u + (uint64_t)g * 0xC2B2AE3D27D4EB4Fu) >> 20;
    for (;; at++) {
        mt_known_way *slot = &s->ways[at & s->ways_mask];
        if (!slot->known || (slot->f == f && slot->g == g)) return slot;
    }
}

static bool changes(const mt_summing *s, int edge, int *f, int *g) {
    *f = s->x->facet_of[edge / 3];
    *g = s->x->facet_of[s->x->part.twins[edge] / 3];
    return *f != *g;
}

/* The ways for all edges of x whose triangles go with different facets. */
static mt_status find_ways(mt_summing *s) {
    int n = 0, f, g;
    for (int e = 0; e < 3 * s->x->part.n_triangles; e++) n += changes(s, e, &f, &g) && f < g;
    for (s->ways_mask = 15; s->ways_mask < 2 * (size_t)n; s->ways_mask = 2 * s->ways_mask + 1) continue;
    s->ways = mt_arena_new(s->arena, s->ways_mask + 1, sizeof *s->ways);
    if (!s->ways) return MT_NO_MEMORY;
    for (int e = 0; e < 3 * s->x->part.n_triangles; e++) {
        if (!changes(s, e, &f, &g) || f > g) continue;
        mt_known_way *slot = slot_of(s, f, g);
        if (slot->known) continue;
        *slot = (mt_known_way){.f = f, .g = g, .known = true};
        mt_status status = find_way(s, f, g, &slot->way);
        if (status != MT_OK) return status;
    }
    return MT_OK;
}

/* ---- faces --------------------------------------------------------------------------------------------- */

static mt_status add_triangle(mt_summing *s, const int x[3], const int y[3]) {
    for (int i = 0; i < 3; i++) {
        s->corners =
            mt_arena_grow_list(s->arena, s->corners, s->n_corners, &s->corners_room, sizeof *s->corners);
        if (!s->corners) return MT_NO_MEMORY;
        s->corners[s->n_corners++] = (uint64_t)x[i] << 32 | (uint32_t)y[i];
    }
    return MT_OK;
}

static mt_status add_facets_of_x(mt_summing *s) {
    mt_status status = MT_OK;
    for (int t = 0; status == MT_OK && t < s->x->part.n_triangles; t++) {
        int y = s->farthest[s->x->facet_of[t]];
        status = add_triangle(s, s->x->part.triangles[t].at, (int[]){y, y, y});
    }
    return status;
}

/* The parallelogram of the edge p q of x and the edge y z of y, by its shorter diagonal half-way. */
static mt_status add_parallelogram(mt_summing *s, int p, int q, int y, int z) {
    mt_vector3 u = mt_minus3(s->x->part.places[q], s->x->part.places[p]);
    mt_vector3 v = mt_minus3(s->y->part.places[z], s->y->part.places[y]);
    if (mt_dot3(u, v) <= 0) { /* from p y to q z */
        mt_status status = add_triangle(s, (int[]){q, p, q}, (int[]){y, y, z});
        return status == MT_OK ? add_triangle(s, (int[]){p, p, q}, (int[]){y, z, z}) : status;
    }
    mt_status status = add_triangle(s, (int[]){q, p, p}, (int[]){y, y, z});
    return status == MT_OK ? add_triangle(s, (int[]){q, p, q}, (int[]){y, z, z}) : status;
}

static mt_status add_side(mt_summing *s, int x, int y) {
    int back_x = s->x->part.twins[x], back_y = s->y->part.twins[y];
    s->sides = mt_arena_grow_list(s->arena, s->sides, s->n_sides, &s->sides_room, sizeof *s->sides);
    if (!s->sides) return MT_NO_MEMORY;
    s->sides[s->n_sides++] = (mt_side_face){x < back_x ? x : back_x, y < back_y ? y : back_y,
                                            (x < back_x) == (y < back_y) ? 1 : -1};
    return MT_OK;
}

static mt_status find_sides(mt_summing *s) {
    const mt_part *x = &s->x->part;
    mt_status status = MT_OK;
    int f, g;
    for (int e = 0; e < 3 * x->n_triangles; e++) {
        if (!changes(s, e, &f, &g) || f > g) continue;
        mt_way way = slot_of(s, f, g)->way;
        for (int i = 0; status == MT_OK && i < way.n_steps; i++) status = add_side(s, e, way.steps[i]);
    }
    return status;
}

static int by_edges(const void *p, const void *q) {
    const mt_side_face *x = p, *y = q;
    return x->x != y->x ? (x->x > y->x) - (x->x < y->x) : (x->y > y->y) - (x->y < y->y);
}

static mt_status add_parallelograms(mt_summing *s) {
    const mt_part *x = &s->x->part, *y = &s->y->part;
    mt_status status = MT_OK;
    if (s->n_sides > 0) qsort(s->sides, (size_t)s->n_sides, sizeof *s->sides, by_edges);
    for (int i = 0, end; i < s->n_sides; i = end) {
        int times = 0, e = s->sides[i].x, step = s->sides[i].y;
        for (end = i; end < s->n_sides && by_edges(&s->sides[end], &s->sides[i]) == 0; end++)
            times += s->sides[end].times;
        int p = times > 0 ? mt_edge_start(x, e) : mt_edge_end(x, e),
            q = times > 0 ? mt_edge_end(x, e) : mt_edge_start(x, e);
        for (int k = 0; status == MT_OK && k < abs(times); k++)
            status = add_parallelogram(s, p, q, mt_edge_start(y, step), mt_edge_end(y, step));
    }
    return status;
}

/* ---- what a point of x has of y's surface -------------------------------------------------------------- */

/* Adds up the ways around a point of x; whether they go around anything. With `sign` -1 what has been added is taken off again. */
static bool go_around(mt_summing *s, int point, int sign) {
    const int *twins = s->x->part.twins;
    int first = s->leaving[point], e = first, f, g;
    bool any = false;
    do {
        if (changes(s, e, &f, &g)) { /* from the point of g to that of f */
            mt_way way = slot_of(s, f < g ? f : g, f < g ? g : f)->way;
            for (int i = 0; i < way.n_steps; i++) {
                int step = f < g ? s->y->part.twins[way.steps[i]] : way.steps[i];
                s->net[step] += sign;
                s->net[s->y->part.twins[step]] -= sign;
                any = true;
            }
        }
        e = twins[mt_edge_before(e)];
    } while (e != first);
    return any;
}

/* How often each triangle of y is gone around, anticlockwise; the first as often as `at_first`. */
static void count_turns(mt_summing *s, int at_first) {
    const mt_part *y = &s->y->part;
    int depth = 0;
    for (int t = 0; t < y->n_triangles; t++) s->seen[t] = false;
    s->weights[0] = at_first;
    s->seen[0] = true;
    s->stack[depth++] = 0;
    while (depth > 0) {
        int t = s->stack[--depth];
        for (int e = 3 * t; e < 3 * t + 3; e++) {
            int there = y->twins[e] / 3;
            if (s->seen[there]) continue;
            s->weights[there] = s->weights[t] - s->net[e];
            s->seen[there] = true;
            s->stack[depth++] = there;
        }
    }
}

static double area_of(const mt_part *part, int t) {
    const int *at = part->triangles[t].at;
    mt_vector3 a = part->places[at[0]];
    return mt_length3(mt_cross3(mt_minus3(part->places[at[1]], a), mt_minus3(part->places[at[2]], a)));
}

/* A point of x, how often it has the first triangle of y, and how much of y's surface it has once. */
typedef struct mt_share {
    int point, at_first;
    double area;
} mt_share;

/* The ways around a point tell how often it has each triangle up to a constant. It has most of them never or once. */
static mt_share share_of(mt_summing *s, int point) {
    const mt_part *y = &s->y->part;
    int least = 0, most = 0;
    mt_share best = {point, 0, 0};
    double best_area = -1;
    count_turns(s, 0);
    for (int t = 0; t < y->n_triangles; t++) {
        if (s->weights[t] < least) least = s->weights[t];
        if (s->weights[t] > most) most = s->weights[t];
    }
    for (int never = least; never < most || never == least; never++) {
        double area = 0, once = 0;
        for (int t = 0; t < y->n_triangles; t++) {
            if (s->weights[t] == never || s->weights[t] == never + 1) area += area_of(y, t);
            if (s->weights[t] == never + 1) once += area_of(y, t);
        }
        if (area <= best_area) continue;
        best_area = area;
        best = (mt_share){point, -never, once};
    }
    return best;
}

/* All points together have each triangle of y once. Where it does not come out so, a point has all but what it was taken to have: the
 * one that then has least too much, or too little. */
static void balance(mt_share *shares, int n) {
    int total = 0;
    for (int i = 0; i < n; i++) total += shares[i].at_first;
    for (; total != 1 && n > 0; total += total > 1 ? -1 : 1) {
        int found = 0;
        for (int i = 1; i < n; i++)
            if (total > 1 ? shares[i].area > shares[found].area : shares[i].area < shares[found].area)
                found = i;
        shares[found].at_first += total > 1 ? -1 : 1;
        shares[found].area = total > 1 ? 0 : INFINITY;
    }
}

/* That a point of x has a triangle of y so many times. */
typedef struct mt_holding {
    int triangle, point, times;
} mt_holding;

static int by_triangle(const void *p, const void *q) {
    const mt_holding *x = p, *y = q;
    return x->triangle != y->triangle ? (x->triangle > y->triangle) - (x->triangle < y->triangle)
                                      : (x->point > y->point) - (x->point < y->point);
}

/* All holdings, by triangles. */
static mt_status find_holdings(mt_summing *s, mt_holding **holdings, int *n) {
    mt_share *shares = mt_arena_new(s->arena, (size_t)s->x->part.n_points, sizeof *shares);
    int n_shares = 0, room = 0;
    *n = 0;
    *holdings = NULL;
    if (!shares) return MT_NO_MEMORY;
    for (int p = 0; p < s->x->part.n_points; p++) {
        if (go_around(s, p, 1)) shares[n_shares++] = share_of(s, p);
        go_around(s, p, -1);
    }
    balance(shares, n_shares);
    for (int i = 0; i < n_shares; i++) {
        go_around(s, shares[i].point, 1);
        count_turns(s, shares[i].at_first);
        go_around(s, shares[i].point, -1);
        for (int t = 0; t < s->y->part.n_triangles; t++) {
            if (s->weights[t] == 0) continue;
            *holdings = mt_arena_grow_list(s->arena, *holdings, *n, &room, sizeof **holdings);
            if (!*holdings) return MT_NO_MEMORY;
            (*holdings)[(*n)++] = (mt_holding){t, shares[i].point, s->weights[t]};
        }
    }
    if (*n > 0) qsort(*holdings, (size_t)*n, sizeof **holdings, by_triangle);
    return MT_OK;
}

/* A triangle of y that one point gives to another: its sides times the way between them, `times` times. */
static mt_status hand_over(mt_summing *s, int triangle, int from, int to, int times) {
    const mt_part *x = &s->x->part;
    int *by =
        mt_arena_new(s->arena, (size_t)x->n_points, sizeof *by); /* the edge that led to each point, from 1 */
    int *line = mt_arena_new(s->arena, (size_t)x->n_points, sizeof *line);
    int n = 0;
    if (!by || !line) return MT_NO_MEMORY;
    line[n++] = to;
    for (int i = 0; i < n && line[i] != from; i++) {
        int first = s->leaving[line[i]], e = first;
        do {
            if (!by[mt_edge_end(x, e)] && mt_edge_end(x, e) != to) {
                by[mt_edge_end(x, e)] = e + 1;
                line[n++] = mt_edge_end(x, e);
            }
            e = x->twins[mt_edge_before(e)];
        } while (e != first);
    }
    mt_status status = MT_OK;
    for (int p = from; p != to && status == MT_OK; p = mt_edge_start(x, by[p] - 1)) {
        int step = x->twins[by[p] - 1]; /* from p on towards `to` */
        for (int k = 0; status == MT_OK && k < 3 * abs(times); k++) {
            int e = 3 * triangle + k % 3;
            status = add_side(s, step, times > 0 ? e : s->y->part.twins[e]);
        }
    }
    return status;
}

/* The one point that is to have a triangle: of those that have it, the farthest in the direction of its facet. */
static int owner_of(const mt_summing *s, const mt_holding *holdings, int n) {
    mt_vector3 direction = s->y->hull.facets[s->y->facet_of[holdings[0].triangle]].normal;
    int found = -1;
    for (int i = 0; i < n; i++) {
        const mt_vector3 *places = s->x->part.places;
        bool farther = found < 0 || mt_dot3(direction, places[holdings[i].point]) >
                                        mt_dot3(direction, places[holdings[found].point]);
        if (holdings[i].times > 0 && farther) found = i;
    }
    return holdings[found].point;
}

/* Each triangle of y once. Where ways have crossed, several points have one, and another less than none of it: they give it to one. */
static mt_status add_facets_of_y(mt_summing *s) {
    mt_holding *holdings;
    int n;
    mt_status status = find_holdings(s, &holdings, &n);
    for (int i = 0, end; status == MT_OK && i < n; i = end) {
        int t = holdings[i].triangle;
        for (end = i; end < n && holdings[end].triangle == t; end++) continue;
        int owner = owner_of(s, holdings + i, end - i);
        for (int k = i; status == MT_OK && k < end; k++)
            if (holdings[k].point != owner) {
                status = hand_over(s, t, holdings[k].point, owner, holdings[k].times);
            }
        if (status == MT_OK)
            status = add_triangle(s, (int[]){owner, owner, owner}, s->y->part.triangles[t].at);
    }
    return status;
}

/* ---- all of it ----------------------------------------------------------------------------------------- */

static int by_value(const void *p, const void *q) {
    uint64_t x = *(const uint64_t *)p, y = *(const uint64_t *)q;
    return (x > y) - (x < y);
}

/* Numbers the pairs of points that are corners. */
static mt_status number_corners(mt_summing *s, mt_sum *sum) {
    size_t n = (size_t)s->n_corners;
    uint64_t *sorted = mt_arena_new(s->arena, n, sizeof *sorted);
    sum->triangles = mt_arena_new(s->arena, n / 3, sizeof *sum->triangles);
    sum->of_x = mt_arena_new(s->arena, n, sizeof *sum->of_x);
    sum->of_y = mt_arena_new(s->arena, n, sizeof *sum->of_y);
    if (!sorted || !sum->triangles || !sum->of_x || !sum->of_y) return MT_NO_MEMORY;
    for (size_t i = 0; i < n; i++) sorted[i] = s->corners[i];
    qsort(sorted, n, sizeof *sorted, by_value);
    for (size_t i = 0; i < n; i++) {
        if (i > 0 && sorted[i] == sorted[i - 1]) continue;
        sum->of_x[sum->n_points] = (int)(sorted[i] >> 32);
        sum->of_y[sum->n_points] = (int)(sorted[i] & UINT32_MAX);
        sorted[sum->n_points++] = sorted[i];
    }
    for (int i = 0; i < s->n_corners; i++) {
        const uint64_t *found =
            bsearch(&s->corners[i], sorted, (size_t)sum->n_points, sizeof *sorted, by_value);
        sum->triangles[i / 3].at[i % 3] = (int)(found - sorted);
    }
    sum->n_triangles = s->n_corners / 3;
    return MT_OK;
}

mt_status mt_sum_of(mt_arena *arena, const mt_piece *x, const mt_piece *y, mt_sum *sum) {
    size_t n = (size_t)y->part.n_triangles;
    mt_sum made = {0};
    mt_summing s = {.x = x,
                    .y = y,
                    .arena = arena,
                    .leaving = mt_arena_new(arena, (size_t)x->part.n_points, sizeof(int)),
                    .weights = mt_arena_new(arena, n, sizeof(int)),
                    .net = mt_arena_new(arena, 3 * n, sizeof(int)),
                    .stack = mt_arena_new(arena, n, sizeof(int)),
                    .seen = mt_arena_new(arena, n, sizeof(bool))};
    if (!s.leaving || !s.weights || !s.net || !s.stack || !s.seen) return MT_NO_MEMORY;
    for (int e = 0; e < 3 * x->part.n_triangles; e++) s.leaving[mt_edge_start(&x->part, e)] = e;
    mt_status status = find_directions(&s);
    if (status == MT_OK) status = find_ways(&s);
    if (status == MT_OK) status = add_facets_of_x(&s);
    if (status == MT_OK) status = find_sides(&s);
    if (status == MT_OK) status = add_facets_of_y(&s);
    if (status == MT_OK) status = add_parallelograms(&s);
    if (status == MT_OK) status = number_corners(&s, &made);
    if (status == MT_OK) *sum = made;
    return status;
}
