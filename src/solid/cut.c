/* Cutting, in this order: on which side each point lies; where edges cross the plane; each wall on such an edge divided, also of other
 * cells; the border of what lies below; the cap in it, triangulated in the plane; and only then the change.
 *
 *            b                 An edge that crosses the plane so near to an end that the crossing is rounded to it,
 *           ╱ ╲                has that end in the plane. Sides are decided once, by number of point, so that all
 *      ── m ─── n ── plane     walls agree on them; what lies within a grid unit of the plane lies in it.
 *        ╱ ╲ ___ ╲
 *       a ──────── c           Invariant: cells are closed before and after. */
#include "solid/cut.h"

#include <assert.h>
#include <stdlib.h>

#include "geometry/triangulate.h"

enum { UNKNOWN = 2 }; /* a point that the cell does not have */

/* A crossing of the edge between two points, the lower first. */
typedef struct mt_crossing {
    int low, high, point;
} mt_crossing;

/* A triangle of the cell, outward, or a part of one that is divided. */
typedef struct mt_facet_part {
    int at[3];
    int wall, part; /* of which wall, and which part of it */
    bool below;
} mt_facet_part;

/* How often more an edge is run along from low to high than back. */
typedef struct mt_net {
    int low, high, times;
} mt_net;

typedef struct mt_cutting {
    mt_cells *cells;
    mt_arena *arena; /* for what is needed only here */
    int cell;
    mt_plane plane;
    int8_t *sides;   /* of all points */
    int n_own, *own; /* walls of the cell */
    int n_crossings, crossings_room, n_parts, parts_room, n_border, n_caps, caps_room;
    mt_crossing *crossings;
    mt_facet_part *parts;
    mt_net *border;    /* times is never 0 */
    mt_triangle *caps; /* of the cells' points */
} mt_cutting;

/* ---- sides and crossings ------------------------------------------------------------------------------- */

static mt_status find_sides(mt_cutting *c) {
    const mt_cells *cells = c->cells;
    c->sides = mt_arena_new(c->arena, (size_t)cells->n_points + 3 * (size_t)cells->n_walls, sizeof *c->sides);
    c->own = mt_arena_new(c->arena, (size_t)cells->n_walls, sizeof *c->own);
    if (!c->sides || !c->own) return MT_NO_MEMORY;
    for (int p = 0; p < cells->n_points; p++) c->sides[p] = UNKNOWN;
    for (int w = 0; w < cells->n_walls; w++) {
        if (cells->walls[w].behind != c->cell && cells->walls[w].in_front != c->cell) continue;
        c->own[c->n_own++] = w;
        for (int i = 0; i < 3; i++) {
            int p = cells->walls[w].at[i];
            if (c->sides[p] == UNKNOWN) c->sides[p] = (int8_t)mt_plane_side(&c->plane, cells->points[p]);
        }
    }
    return MT_OK;
}

static bool crosses(const mt_cutting *c, int p, int q) {
    return c->sides[p] + c->sides[q] == 0 && c->sides[p] != 0;
}

/* Ends to which crossings are rounded lie in the plane; whether there was one. */
static bool snap(mt_cutting *c) {
    const mt_cells *cells = c->cells;
    bool any = false;
    for (int i = 0; i < c->n_own; i++)
        for (int k = 0; k < 3; k++) {
            int p = cells->walls[c->own[i]].at[k], q = cells->walls[c->own[i]].at[(k + 1) % 3];
            if (!crosses(c, p, q)) continue;
            mt_place at = mt_plane_crossing(&c->plane, cells->points[p], cells->points[q]);
            int end = mt_place_equal(at, cells->points[p])   ? p
                      : mt_place_equal(at, cells->points[q]) ? q
                                                             : -1;
            if (end < 0) continue;
            c->sides[end] = 0;
            any = true;
        }
    return any;
}

static int by_edge(const void *p, const void *q) {
    const mt_crossing *x = p, *y = q;
    return x->low != y->low ? (x->low > y->low) - (x->low < y->low)
                            : (x->high > y->high) - (x->high < y->high);
}

static mt_status add_point(mt_cells *cells, mt_place place) {
    cells->points = mt_arena_grow_list(cells->arena, cells->points, cells->n_points, &cells->points_room,
                                       sizeof *cells->points);
    if (!cells->points) return MT_NO_MEMORY;
    cells->points[cells->n_points++] = place;
    return MT_OK;
}

static mt_status find_crossings(mt_cutting *c) {
    mt_cells *cells = c->cells;
    while (snap(c)) continue;
    c->crossings = mt_arena_new(c->arena, 3 * (size_t)c->n_own, sizeof *c->crossings);
    if (!c->crossings) return MT_NO_MEMORY;
    for (int i = 0; i < c->n_own; i++)
        for (int k = 0; k < 3; k++) {
            int p = cells->walls[c->own[i]].at[k], q = cells->walls[c->own[i]].at[(k + 1) % 3];
            if (crosses(c, p, q))
                c->crossings[c->n_crossings++] = p < q ? (mt_crossing){p, q, 0} : (mt_crossing){q, p, 0};
        }
    qsort(c->crossings, (size_t)c->n_crossings, sizeof *c->crossings, by_edge);
    int n = 0;
    for (int i = 0; i < c->n_crossings; i++) {
        if (n > 0 && by_edge(&c->crossings[i], &c->crossings[n - 1]) == 0) continue;
        mt_crossing made = c->crossings[i];
        made.point = cells->n_points;
        mt_status status =
            add_point(cells, mt_plane_crossing(&c->plane, cells->points[made.low], cells->points[made.high]));
        if (status != MT_OK) return status;
        c->sides[made.point] = 0;
        c->crossings[n++] = made;
    }
    c->n_crossings = n;
    return MT_OK;
}

/* ---- walls divided ------------------------------------------------------------------------------------- */

static int crossing_of(const mt_cutting *c, int p, int q) {
    if (c->sides[p] == UNKNOWN || c->sides[q] == UNKNOWN || !crosses(c, p, q)) return -1;
    mt_crossing wanted = p < q ? (mt_crossing){p, q, 0} : (mt_crossing){q, p, 0};
    const mt_crossing *found = bsearch(&wanted, c->crossings, (size_t)c->n_crossings, sizeof wanted, by_edge);
    return found ? found->point : -1; /* of no edge of the cell */
}

/* A wall in up to four triangles, at the crossings of its edges; how many. */
static int divide(const mt_cutting *c, const int at[3], int made[4][3]) {
    int m[3], n = 0, first = 0;
    for (int i = 0; i < 3; i++) n += (m[i] = crossing_of(c, at[i], at[(i + 1) % 3])) >= 0;
    if (n == 1)
        while (m[first] < 0) first++; /* the edge that is crossed */
    if (n == 2)
        while (m[(first + 2) % 3] >= 0) first++; /* the corner before the two edges */
    int a = at[first % 3], b = at[(first + 1) % 3], d = at[(first + 2) % 3];
    int ab = m[first % 3], bd = m[(first + 1) % 3], da = m[(first + 2) % 3];
    int whole[1][3] = {{a, b, d}};
    int one[2][3] = {{a, ab, d}, {ab, b, d}};
    int two[3][3] = {{ab, b, bd}, {a, ab, bd}, {a, bd, d}};
    int three[4][3] = {{ab, b, bd}, {bd, d, da}, {da, a, ab}, {ab, bd, da}};
    int(*parts)[3] = n == 0 ? whole : n == 1 ? one : n == 2 ? two : three;
    for (int i = 0; i <= n; i++)
        for (int k = 0; k < 3; k++) made[i][k] = parts[i][k];
    return n + 1;
}

/* Whether a triangle of the cell lies below: by its points, or when it lies in the plane by what is behind it. */
static bool is_below(const mt_cutting *c, const int at[3], int wall) {
    int sum = c->sides[at[0]] + c->sides[at[1]] + c->sides[at[2]];
    if (sum != 0) return sum < 0;
    mt_plane own = mt_wall_plane(c->cells, wall, c->cell);
    return mt_plane_alike(&own, &c->plane) > 0;
}

static mt_status find_parts(mt_cutting *c) {
    bool any_below = false, any_above = false;
    c->parts = mt_arena_new(c->arena, 4 * (size_t)c->n_own, sizeof *c->parts);
    if (!c->parts) return MT_NO_MEMORY;
    for (int i = 0; i < c->n_own; i++) {
        int made[4][3], n = divide(c, c->cells->walls[c->own[i]].at, made);
        bool turned = c->cells->walls[c->own[i]].behind != c->cell;
        for (int k = 0; k < n; k++) {
            mt_facet_part *part = &c->parts[c->n_parts++];
            *part = (mt_facet_part){
                {made[k][0], made[k][turned ? 2 : 1], made[k][turned ? 1 : 2]}, c->own[i], k, false};
            part->below = is_below(c, part->at, part->wall);
            any_below |= part->below;
            any_above |= !part->below;
        }
    }
    return any_below && any_above ? MT_OK : MT_BAD_GEOMETRY;
}

/* ---- the cap ------------------------------------------------------------------------------------------- */

static int by_net_edge(const void *p, const void *q) {
    const mt_net *x = p, *y = q;
    return x->low != y->low ? (x->low > y->low) - (x->low < y->low)
                            : (x->high > y->high) - (x->high < y->high);
}

static mt_net net_of(int from, int to) {
    return from < to ? (mt_net){from, to, 1} : (mt_net){to, from, -1};
}

/* Adds up equal edges and drops those without a rest; how many are left. */
static int add_up(mt_net *edges, int n) {
    int kept = 0;
    qsort(edges, (size_t)n, sizeof *edges, by_net_edge);
    for (int i = 0, end; i < n; i = end) {
        mt_net sum = {edges[i].low, edges[i].high, 0};
        for (end = i; end < n && by_net_edge(&edges[end], &sum) == 0; end++) sum.times += edges[end].times;
        if (sum.times != 0) edges[kept++] = sum;
    }
    return kept;
}

/* What the triangles below leave open. */
static mt_status find_border(mt_cutting *c) {
    c->border = mt_arena_new(c->arena, 3 * (size_t)c->n_parts, sizeof *c->border);
    if (!c->border) return MT_NO_MEMORY;
    for (int i = 0; i < c->n_parts; i++)
        for (int k = 0; k < 3; k++)
            if (c->parts[i].below)
                c->border[c->n_border++] = net_of(c->parts[i].at[k], c->parts[i].at[(k + 1) % 3]);
    c->n_border = add_up(c->border, c->n_border);
    return c->n_border > 0 ? MT_OK : MT_BAD_GEOMETRY;
}

/* A place of the plane without the coordinate that its normal is longest in; anticlockwise stays so as seen from above. */
static mt_point flattened(const mt_plane *plane, mt_place p) {
    int64_t x = llabs(plane->x), y = llabs(plane->y), z = llabs(plane->z);
    mt_point made = x >= y && x >= z ? (mt_point){p.y, p.z}
                    : y >= z         ? (mt_point){p.z, p.x}
                                     : (mt_point){p.x, p.y};
    int64_t longest = x >= y && x >= z ? plane->x : y >= z ? plane->y : plane->z;
    return longest > 0 ? made : (mt_point){made.y, made.x};
}

typedef struct mt_directed {
    int from, to;
} mt_directed;

static int by_start(const void *p, const void *q) {
    const mt_directed *x = p, *y = q;
    return x->from != y->from ? (x->from > y->from) - (x->from < y->from) : (x->to > y->to) - (x->to < y->to);
}

/* Edges against their direction, as what closes them has them. */
static mt_status against(const mt_cutting *c, const mt_net *edges, int n, mt_directed **made, int *n_made) {
    int count = 0;
    for (int i = 0; i < n; i++) count += abs(edges[i].times);
    *made = mt_arena_new(c->arena, (size_t)count, sizeof **made);
    if (!*made) return MT_NO_MEMORY;
    *n_made = count;
    count = 0;
    for (int i = 0; i < n; i++)
        for (int k = 0; k < abs(edges[i].times); k++)
            (*made)[count++] = edges[i].times > 0 ? (mt_directed){edges[i].high, edges[i].low}
                                                  : (mt_directed){edges[i].low, edges[i].high};
    qsort(*made, (size_t)count, sizeof **made, by_start);
    return MT_OK;
}

static int first_from(const mt_directed *edges, int n, int from) {
    int low = 0, high = n;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (edges[middle].from < from)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Closed walks along all edges, which are sorted: walks[first[i]] … [first[i + 1] - 1] are the points of walk i. */
typedef struct mt_walks {
    int count, *first, *points;
} mt_walks;

static mt_status walk(mt_cutting *c, const mt_directed *edges, int n, mt_walks *walks) {
    bool *walked = mt_arena_new(c->arena, (size_t)n, sizeof *walked);
    walks->points = mt_arena_new(c->arena, (size_t)n, sizeof *walks->points);
    walks->first = mt_arena_new(c->arena, (size_t)n + 1, sizeof *walks->first);
    walks->count = 0;
    if (!walked || !walks->points || !walks->first) return MT_NO_MEMORY;
    int made = 0;
    for (int start = 0; start < n; start++) {
        if (walked[start]) continue;
        for (int e = start; e >= 0;) {
            int next = edges[e].to;
            walked[e] = true;
            walks->points[made++] = edges[e].from;
            for (e = first_from(edges, n, next); e < n && edges[e].from == next && walked[e]; e++) continue;
            if (e == n || edges[e].from != next) e = -1;
        }
        walks->first[++walks->count] = made;
    }
    return MT_OK;
}

static mt_status rings_of(mt_cutting *c, const mt_walks *walks, mt_component *rings) {
    rings->rings = mt_arena_new(c->arena, (size_t)walks->count, sizeof *rings->rings);
    if (!rings->rings) return MT_NO_MEMORY;
    for (int i = 0; i < walks->count; i++) {
        mt_ring *ring = &rings->rings[rings->count++];
        mt_status status = mt_ring_new(c->arena, walks->first[i + 1] - walks->first[i], ring);
        if (status != MT_OK) return status;
        for (int k = 0; k < ring->count; k++)
            ring->points[k] = flattened(&c->plane, c->cells->points[walks->points[walks->first[i] + k]]);
    }
    return MT_OK;
}

static mt_status add_cap(mt_cutting *c, int p, int q, int r) {
    c->caps = mt_arena_grow_list(c->arena, c->caps, c->n_caps, &c->caps_room, sizeof *c->caps);
    if (!c->caps) return MT_NO_MEMORY;
    c->caps[c->n_caps++] = (mt_triangle){{p, q, r}};
    return MT_OK;
}

/* What is between the cap and the border: the triangulation divides an edge where another point lies on it, and takes points for one
 * that are one as seen along the axis. These gaps have no area; they are filled with triangles that have none. */
static mt_status fill_gaps(mt_cutting *c) {
    int n = 0;
    mt_walks walks;
    mt_component rings = {0};
    mt_net *gaps = mt_arena_new(c->arena, 3 * (size_t)c->n_caps + (size_t)c->n_border, sizeof *gaps);
    if (!gaps) return MT_NO_MEMORY;
    for (int e = 0; e < 3 * c->n_caps; e++)
        gaps[n++] = net_of(c->caps[e / 3].at[e % 3], c->caps[e / 3].at[(e + 1) % 3]);
    for (int i = 0; i < c->n_border; i++) gaps[n++] = c->border[i];
    n = add_up(gaps, n);
    mt_directed *edges;
    mt_status status = against(c, gaps, n, &edges, &n);
    if (status == MT_OK) status = walk(c, edges, n, &walks);
    if (status == MT_OK) status = rings_of(c, &walks, &rings);
    for (int i = 0; status == MT_OK && i < walks.count; i++) {
        const int *points = walks.points + walks.first[i];
        if (mt_ring_area2(&rings.rings[i]) != 0) return MT_BAD_GEOMETRY;
        for (int k = 1; status == MT_OK && k + 1 < rings.rings[i].count; k++)
            status = add_cap(c, points[0], points[k], points[k + 1]);
    }
    return status;
}

static mt_status find_cap(mt_cutting *c) {
    mt_directed *edges;
    mt_walks walks;
    mt_component rings = {0};
    mt_half_edges cap;
    int n;
    mt_status status = against(c, c->border, c->n_border, &edges, &n);
    if (status == MT_OK) status = walk(c, edges, n, &walks);
    if (status == MT_OK) status = rings_of(c, &walks, &rings);
    if (status == MT_OK) status = mt_triangulate(&rings, c->arena, &cap);
    for (int t = 0; status == MT_OK && t < cap.triangle_count; t++) {
        const int *at = cap.start + 3 * t; /* corners of rings, which are those of the walks */
        status = add_cap(c, walks.points[at[0]], walks.points[at[1]], walks.points[at[2]]);
    }
    return status == MT_OK ? fill_gaps(c) : status;
}

/* ---- the change ---------------------------------------------------------------------------------------- */

static mt_status add_wall(mt_cells *cells, mt_wall wall) {
    cells->walls = mt_arena_grow_list(cells->arena, cells->walls, cells->n_walls, &cells->walls_room,
                                      sizeof *cells->walls);
    if (!cells->walls) return MT_NO_MEMORY;
    cells->walls[cells->n_walls++] = wall;
    return MT_OK;
}

static void move_up(const mt_cutting *c, mt_wall *wall, int above) {
    if (wall->behind == c->cell)
        wall->behind = above;
    else
        wall->in_front = above;
}

/* Divides the walls; the first part of each stays in its place. */
static mt_status divide_walls(mt_cutting *c, int above) {
    mt_cells *cells = c->cells;
    int n = cells->n_walls, next = 0; /* of the cell's parts, which are in the order of the walls */
    mt_status status = MT_OK;
    for (int w = 0; status == MT_OK && w < n; w++) {
        int made[4][3], count = divide(c, cells->walls[w].at, made);
        bool own = next < c->n_parts && c->parts[next].wall == w;
        mt_wall wall = cells->walls[w];
        for (int k = 0; status == MT_OK && k < count; k++) {
            mt_wall part = wall;
            for (int i = 0; i < 3; i++) part.at[i] = made[k][i];
            if (own && !c->parts[next++].below) move_up(c, &part, above);
            if (k == 0)
                cells->walls[w] = part;
            else
                status = add_wall(cells, part);
        }
    }
    return status;
}

static mt_status add_caps(mt_cutting *c, int above) {
    mt_cells *cells = c->cells;
    cells->planes = mt_arena_grow_list(cells->arena, cells->planes, cells->n_planes, &cells->planes_room,
                                       sizeof *cells->planes);
    if (!cells->planes) return MT_NO_MEMORY;
    cells->planes[cells->n_planes++] = c->plane;
    mt_status status = MT_OK;
    for (int t = 0; status == MT_OK && t < c->n_caps; t++) {
        const int *at = c->caps[t].at;
        status = add_wall(cells, (mt_wall){{at[0], at[1], at[2]}, c->cell, above, cells->n_planes - 1});
    }
    return status;
}

static mt_status cut(mt_cells *cells, int cell, mt_plane plane, mt_arena *scratch) {
    mt_cutting c = {.cells = cells, .arena = scratch, .cell = cell, .plane = plane};
    int n_points = cells->n_points;
    mt_status status = find_sides(&c);
    if (status == MT_OK) status = find_crossings(&c);
    if (status == MT_OK) status = find_parts(&c);
    if (status == MT_OK) status = find_border(&c);
    if (status == MT_OK) status = find_cap(&c);
    if (status != MT_OK) {
        cells->n_points = n_points;
        return status == MT_TOO_LARGE ? MT_BAD_GEOMETRY : status;
    }
    int above = cells->n_cells++;
    status = divide_walls(&c, above);
    if (status == MT_OK) status = add_caps(&c, above);
    if (status == MT_OK) status = mt_cells_separate(cells, cell);
    return status == MT_OK ? mt_cells_separate(cells, above) : status;
}

mt_status mt_cells_cut(mt_cells *cells, int cell, mt_plane plane) {
    mt_arena scratch = {0};
    mt_status status = cut(cells, cell, plane, &scratch);
    mt_arena_release(&scratch);
    return status;
}
