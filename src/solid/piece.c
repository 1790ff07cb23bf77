/* The shortest ways are E. W. Dijkstra's ("A note on two problems in connexion with graphs", 1959), each until its end is reached. Two
 * shortest ways seldom cross; where they do, a region has two facets to choose from, and takes the one with the longer border. */
#include "solid/piece.h"

#include <math.h>
#include <stdlib.h>

#include "solid/depth.h"
#include "solid/queue.h"
#include "space/vector.h"

/* A way keeps near the ridge: what its points lie deep counts so many times. */
#define DEPTH_COST 8.0

/* ---- ridges -------------------------------------------------------------------------------------------- */

static int by_ends(const void *p, const void *q) {
    const mt_ridge *x = p, *y = q;
    return x->u != y->u ? (x->u > y->u) - (x->u < y->u) : (x->v > y->v) - (x->v < y->v);
}

/* Whether all corners of a facet are within rounding of a plane. */
static bool is_in_plane(const mt_piece *piece, const mt_hull_facet *facet, const mt_hull_facet *plane) {
    for (int i = 0; i < facet->n_corners; i++)
        if (fabs(mt_dot3(plane->normal, piece->part.places[facet->corners[i]]) - plane->offset) >
            MT_RISE_ROUNDED)
            return false;
    return true;
}

static int root_of(int *parent, int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

/* Facets that are one but for rounding to the grid count as the first of them, and have no ridge between them. */
static mt_status join_facets(mt_arena *arena, mt_piece *piece) {
    const mt_polytope *hull = &piece->hull;
    int kept = 0, *parent = mt_arena_new(arena, (size_t)hull->n_facets, sizeof *parent);
    if (!parent) return MT_NO_MEMORY;
    for (int f = 0; f < hull->n_facets; f++) parent[f] = f;
    for (int i = 0; i < piece->n_ridges; i++) {
        const mt_hull_facet *left = &hull->facets[piece->ridges[i].left],
                            *right = &hull->facets[piece->ridges[i].right];
        if (!is_in_plane(piece, left, right) || !is_in_plane(piece, right, left)) continue;
        int p = root_of(parent, piece->ridges[i].left), q = root_of(parent, piece->ridges[i].right);
        parent[p > q ? p : q] = p > q ? q : p;
    }
    for (int i = 0; i < piece->n_ridges; i++) {
        mt_ridge ridge = piece->ridges[i];
        ridge.left = root_of(parent, ridge.left);
        ridge.right = root_of(parent, ridge.right);
        if (ridge.left != ridge.right) piece->ridges[kept++] = ridge;
    }
    piece->n_ridges = kept;
    return MT_OK;
}

static mt_status find_ridges(mt_arena *arena, mt_piece *piece) {
    const mt_polytope *hull = &piece->hull;
    mt_ridge *all = mt_arena_new(arena, (size_t)hull->n_corners, sizeof *all);
    piece->ridges = mt_arena_new(arena, (size_t)hull->n_corners, sizeof *all);
    piece->first_ridge = mt_arena_new(arena, (size_t)piece->part.n_points + 2, sizeof(int));
    piece->ridges_at = mt_arena_new(arena, (size_t)hull->n_corners, sizeof(int));
    if (!all || !piece->ridges || !piece->first_ridge || !piece->ridges_at) return MT_NO_MEMORY;
    int n = 0;
    for (int f = 0; f < hull->n_facets; f++)
        for (int i = 0; i < hull->facets[f].n_corners; i++) {
            const mt_hull_facet *facet = &hull->facets[f];
            all[n++] = (mt_ridge){
                .u = facet->corners[i], .v = facet->corners[(i + 1) % facet->n_corners], .left = f};
        }
    qsort(all, (size_t)n, sizeof *all, by_ends);
    for (int i = 0; i < n; i++) {
        mt_ridge back = {.u = all[i].v, .v = all[i].u};
        if (back.u < back.v) continue;
        const mt_ridge *other = bsearch(&back, all, (size_t)n, sizeof *all, by_ends);
        if (!other) return MT_BAD_GEOMETRY;
        piece->ridges[piece->n_ridges] = all[i];
        piece->ridges[piece->n_ridges++].right = other->left;
    }
    mt_status status = join_facets(arena, piece);
    if (status != MT_OK) return status;
    int *next = piece->first_ridge + 1; /* where the next ridge of a point goes */
    for (int i = 0; i < piece->n_ridges; i++) {
        next[piece->ridges[i].u + 1]++;
        next[piece->ridges[i].v + 1]++;
    }
    for (int p = 0; p < piece->part.n_points; p++) next[p + 1] += next[p];
    for (int i = 0; i < piece->n_ridges; i++) {
        piece->ridges_at[next[piece->ridges[i].u]++] = i;
        piece->ridges_at[next[piece->ridges[i].v]++] = i;
    }
    return MT_OK;
}

/* ---- shortest ways ------------------------------------------------------------------------------------- */

typedef struct mt_search {
    const mt_part *part;
    const mt_hull_facet *left, *right; /* of the ridge at hand */
    int *leaving;                      /* of each point: an edge that starts there */
    double *length;
    int *by, *round; /* of each point: the edge that led there; the search that reached it */
    int rounds;
    mt_queue queue; /* of points */
    mt_arena *arena;
} mt_search;

static mt_status reach(mt_search *s, int point, double length, int by) {
    if (s->round[point] == s->rounds && s->length[point] <= length) return MT_OK;
    s->round[point] = s->rounds;
    s->length[point] = length;
    s->by[point] = by;
    return mt_queue_push(&s->queue, s->arena, length, point);
}

/* How deep a point lies under the facets on both sides of the ridge. */
static double depth_of(const mt_search *s, int point) {
    mt_vector3 p = s->part->places[point];
    return fmin(fabs(s->left->offset - mt_dot3(s->left->normal, p)),
                fabs(s->right->offset - mt_dot3(s->right->normal, p)));
}

static mt_status find_way(mt_search *s, mt_ridge *ridge, mt_arena *arena) {
    const mt_part *part = s->part;
    s->rounds++;
    s->queue.count = 0;
    mt_status status = reach(s, ridge->u, 0, -1);
    while (status == MT_OK && s->queue.count > 0) {
        mt_queued here = mt_queue_pop(&s->queue);
        if (here.cost > s->length[here.number]) continue;
        if (here.number == ridge->v) break;
        int e = s->leaving[here.number];
        do {
            int to = mt_edge_end(part, e);
            double step = mt_length3(mt_minus3(part->places[to], part->places[here.number]));
            if (status == MT_OK) status = reach(s, to, here.cost + step + DEPTH_COST * depth_of(s, to), e);
            e = part->twins[mt_edge_before(e)];
        } while (e != s->leaving[here.number]);
    }
    if (status != MT_OK) return status;
    if (s->round[ridge->v] != s->rounds) return MT_BAD_GEOMETRY; /* not in one piece */
    for (int p = ridge->v; p != ridge->u; p = mt_edge_start(part, s->by[p])) ridge->n_steps++;
    ridge->steps = mt_arena_new(arena, (size_t)ridge->n_steps, sizeof(int));
    if (!ridge->steps) return MT_NO_MEMORY;
    int i = ridge->n_steps;
    for (int p = ridge->v; p != ridge->u; p = mt_edge_start(part, s->by[p])) ridge->steps[--i] = s->by[p];
    return MT_OK;
}

static mt_status find_ways(mt_arena *arena, mt_piece *piece) {
    const mt_part *part = &piece->part;
    size_t n = (size_t)part->n_points;
    mt_search s = {.part = part,
                   .arena = arena,
                   .leaving = mt_arena_new(arena, n, sizeof(int)),
                   .length = mt_arena_new(arena, n, sizeof(double)),
                   .by = mt_arena_new(arena, n, sizeof(int)),
                   .round = mt_arena_new(arena, n, sizeof(int))};
    if (!s.leaving || !s.length || !s.by || !s.round) return MT_NO_MEMORY;
    for (int e = 0; e < 3 * part->n_triangles; e++) s.leaving[mt_edge_start(part, e)] = e;
    mt_status status = MT_OK;
    for (int i = 0; status == MT_OK && i < piece->n_ridges; i++) {
        s.left = &piece->hull.facets[piece->ridges[i].left];
        s.right = &piece->hull.facets[piece->ridges[i].right];
        status = find_way(&s, &piece->ridges[i], arena);
    }
    return status;
}

/* ---- regions ------------------------------------------------------------------------------------------- */

/* A vote of a region's border for a facet. */
typedef struct mt_vote {
    int region, facet;
    double length;
} mt_vote;

static int by_region_then_facet(const void *p, const void *q) {
    const mt_vote *x = p, *y = q;
    return x->region != y->region ? (x->region > y->region) - (x->region < y->region)
                                  : (x->facet > y->facet) - (x->facet < y->facet);
}

/* Numbers the regions between the ways, from 0; their count, or -1 when out of memory. */
static int find_regions(mt_arena *arena, const mt_part *part, const bool *is_border, int *region) {
    int *stack = mt_arena_new(arena, (size_t)part->n_triangles, sizeof *stack);
    int n = 0;
    if (!stack) return -1;
    for (int t = 0; t < part->n_triangles; t++) region[t] = -1;
    for (int t = 0; t < part->n_triangles; t++) {
        if (region[t] >= 0) continue;
        int depth = 0;
        region[t] = n;
        stack[depth++] = t;
        while (depth > 0) {
            int here = stack[--depth];
            for (int e = 3 * here; e < 3 * here + 3; e++) {
                int there = part->twins[e] / 3;
                if (is_border[e] || region[there] >= 0) continue;
                region[there] = n;
                stack[depth++] = there;
            }
        }
        n++;
    }
    return n;
}

static mt_vote *cast_votes(mt_arena *arena, const mt_piece *piece, const int *region, int *n_votes) {
    const mt_part *part = &piece->part;
    int n = 0;
    for (int i = 0; i < piece->n_ridges; i++) n += 2 * piece->ridges[i].n_steps;
    mt_vote *votes = mt_arena_new(arena, (size_t)n, sizeof *votes);
    if (!votes) return NULL;
    n = 0;
    for (int i = 0; i < piece->n_ridges; i++)
        for (int k = 0; k < piece->ridges[i].n_steps; k++) {
            int e = piece->ridges[i].steps[k];
            double length = mt_length3(
                mt_minus3(part->places[mt_edge_end(part, e)], part->places[mt_edge_start(part, e)]));
            votes[n++] = (mt_vote){region[e / 3], piece->ridges[i].left, length};
            votes[n++] = (mt_vote){region[part->twins[e] / 3], piece->ridges[i].right, length};
        }
    qsort(votes, (size_t)n, sizeof *votes, by_region_then_facet);
    *n_votes = n;
    return votes;
}

static mt_status assign_facets(mt_arena *arena, mt_piece *piece) {
    const mt_part *part = &piece->part;
    int n = part->n_triangles, n_votes = 0;
    bool *is_border = mt_arena_new(arena, 3 * (size_t)n, sizeof *is_border);
    int *region = mt_arena_new(arena, (size_t)n, sizeof *region);
    piece->facet_of = mt_arena_new(arena, (size_t)n, sizeof *piece->facet_of);
    if (!is_border || !region || !piece->facet_of) return MT_NO_MEMORY;
    for (int i = 0; i < piece->n_ridges; i++)
        for (int k = 0; k < piece->ridges[i].n_steps; k++) {
            int e = piece->ridges[i].steps[k];
            is_border[e] = is_border[part->twins[e]] = true;
        }
    int n_regions = find_regions(arena, part, is_border, region);
    if (n_regions < 0) return MT_NO_MEMORY;
    int *facet = mt_arena_new(arena, (size_t)n_regions, sizeof *facet);
    double *most = mt_arena_new(arena, (size_t)n_regions, sizeof *most);
    mt_vote *votes = cast_votes(arena, piece, region, &n_votes);
    if (!facet || !most || !votes) return MT_NO_MEMORY;
    for (int i = 0, end; i < n_votes; i = end) {
        double sum = 0;
        for (end = i; end < n_votes && by_region_then_facet(&votes[end], &votes[i]) == 0; end++)
            sum += votes[end].length;
        if (sum <= most[votes[i].region]) continue;
        most[votes[i].region] = sum;
        facet[votes[i].region] = votes[i].facet;
    }
    for (int t = 0; t < n; t++) piece->facet_of[t] = facet[region[t]];
    return MT_OK;
}

mt_status mt_piece_of(mt_arena *arena, const mt_part *part, mt_piece *piece) {
    mt_piece made = {.part = *part};
    mt_status status = mt_polytope_around(arena, part->places, part->n_points, &made.hull);
    if (status == MT_OK) status = find_ridges(arena, &made);
    if (status == MT_OK) status = find_ways(arena, &made);
    if (status == MT_OK) status = assign_facets(arena, &made);
    if (status == MT_OK) *piece = made;
    return status;
}
