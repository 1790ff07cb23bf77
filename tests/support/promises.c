#include "support/promises.h"

#include "geometry/decompose.h"
#include "support/oracle.h"

enum { SAMPLES_A_SIDE = 14, WINDOW_POINTS_MAX = 60 };

static int point_count(const mt_rings *rings) {
    int count = 0;
    for (int i = 0; i < rings->count; i++) count += rings->rings[i].count;
    return count;
}

/* A repeated point is no edge of its own. */
static int edge_count(const mt_rings *rings) {
    int count = 0;
    for (int r = 0; r < rings->count; r++) {
        const mt_ring *ring = &rings->rings[r];
        for (int i = 0; i < ring->count; i++)
            count += !mt_point_equal(ring->points[i], ring->points[(i + 1) % ring->count]);
    }
    return count;
}

static bool has_edge(const mt_rings *rings, mt_point from, mt_point to) {
    for (int r = 0; r < rings->count; r++) {
        const mt_ring *ring = &rings->rings[r];
        for (int i = 0; i < ring->count; i++)
            if (mt_point_equal(ring->points[i], from) &&
                mt_point_equal(ring->points[(i + 1) % ring->count], to))
                return true;
    }
    return false;
}

static bool has_point(const mt_rings *rings, mt_point p) {
    for (int r = 0; r < rings->count; r++)
        for (int i = 0; i < rings->rings[r].count; i++)
            if (mt_point_equal(rings->rings[r].points[i], p)) return true;
    return false;
}

static mt_box box_of(const mt_rings *rings) {
    mt_box box = {rings->rings[0].points[0], rings->rings[0].points[0]};
    for (int i = 0; i < rings->rings[0].count; i++) {
        mt_point p = rings->rings[0].points[i];
        box.min.x = p.x < box.min.x ? p.x : box.min.x;
        box.min.y = p.y < box.min.y ? p.y : box.min.y;
        box.max.x = p.x > box.max.x ? p.x : box.max.x;
        box.max.y = p.y > box.max.y ? p.y : box.max.y;
    }
    return box;
}

/* At sample points the parts, together, wind as often as the whole: simple and anticlockwise parts then
 * cover the whole once and nothing else. */
static void check_cover(const mt_rings *whole, const mt_rings *parts, const mt_subject *subject) {
    mt_box box = box_of(whole);
    int64_t width = 2 * ((int64_t)box.max.x - box.min.x), height = 2 * ((int64_t)box.max.y - box.min.y);
    for (int i = 0; i < SAMPLES_A_SIDE; i++)
        for (int k = 0; k < SAMPLES_A_SIDE; k++) {
            mt_spot spot = {(2 * box.min.x + width * i / SAMPLES_A_SIDE) | 1,
                            (2 * box.min.y + height * k / SAMPLES_A_SIDE) | 1};
            mt_require(mt_oracle_winding(whole, 2, spot) == mt_oracle_winding(parts, 2, spot), subject);
        }
}

/* ---- triangles ----------------------------------------------------------------------------------------- */

static int next(int e) {
    return e % 3 == 2 ? e - 2 : e + 1;
}

static mt_point at(const mt_half_edges *mesh, int e) {
    return mesh->points[mesh->start[e]];
}

static void check_half_edges(const mt_half_edges *mesh, const mt_subject *subject) {
    for (int e = 0; e < 3 * mesh->triangle_count; e++) {
        int f = mesh->twin[e];
        mt_require(mesh->start[e] >= 0 && mesh->start[e] < mesh->vertex_count, subject);
        if (f == -1) continue;
        mt_require(f >= 0 && f < 3 * mesh->triangle_count && f / 3 != e / 3 && mesh->twin[f] == e, subject);
        mt_require(mt_point_equal(at(mesh, e), at(mesh, next(f))), subject);
        mt_require(mt_point_equal(at(mesh, f), at(mesh, next(e))), subject);
        mt_point far = at(mesh, next(next(f)));
        mt_require(mt_oracle_in_circle(at(mesh, e), at(mesh, next(e)), at(mesh, next(next(e))), far) <= 0,
                   subject);
    }
}

static mt_rings triangles_of(const mt_half_edges *mesh) {
    mt_rings rings = {mesh->triangle_count, mt_test_new((size_t)mesh->triangle_count, sizeof(mt_ring))};
    mt_point *points = mt_test_new(3 * (size_t)mesh->triangle_count, sizeof *points);
    for (int e = 0; e < 3 * mesh->triangle_count; e++) points[e] = at(mesh, e);
    for (int i = 0; i < rings.count; i++) rings.rings[i] = (mt_ring){3, points + 3 * (size_t)i, NULL};
    return rings;
}

static void check_triangles(const mt_component *component, const mt_half_edges *mesh,
                            const mt_subject *subject) {
    mt_rings triangles = triangles_of(mesh);
    for (int i = 0; i < triangles.count; i++) mt_require(mt_oracle_is_convex(&triangles.rings[i]), subject);
    mt_require(mt_oracle_area2(&triangles) == mt_oracle_area2(component), subject);
    check_cover(component, &triangles, subject);
    if (triangles.count) free(triangles.rings[0].points);
    free(triangles.rings);
}

static void check_boundary(const mt_component *component, const mt_half_edges *mesh,
                           const mt_subject *subject) {
    int boundary = 0, edges = edge_count(component);
    for (int e = 0; e < 3 * mesh->triangle_count; e++) {
        if (mesh->twin[e] >= 0) continue;
        mt_require(has_edge(component, at(mesh, e), at(mesh, next(e))), subject);
        boundary++;
    }
    mt_require(boundary == edges, subject);
    mt_require(mesh->triangle_count == edges + 2 * (component->count - 1) - 2, subject);
}

static bool in_window(const mt_component *component, mt_spot from, mt_spot to, int64_t scale) {
    for (int r = 0; r < component->count; r++) {
        const mt_ring *ring = &component->rings[r];
        for (int i = 0; i < ring->count; i++) {
            mt_spot a = mt_spot_of(ring->points[i], scale),
                    b = mt_spot_of(ring->points[(i + 1) % ring->count], scale);
            bool ends_there = (a.x == to.x && a.y == to.y) || (b.x == to.x && b.y == to.y);
            if (!ends_there && mt_oracle_meet(from, to, a, b)) return false;
        }
    }
    return true;
}

/* The empty circle: in thirds of grid units, barycentres are exact. */
static void check_window(const mt_component *component, const mt_half_edges *mesh,
                         const mt_subject *subject) {
    for (int t = 0; t < mesh->triangle_count; t++) {
        mt_point a = at(mesh, 3 * t), b = at(mesh, 3 * t + 1), c = at(mesh, 3 * t + 2);
        mt_spot middle = {(int64_t)a.x + b.x + c.x, (int64_t)a.y + b.y + c.y};
        for (int v = 0; v < mesh->vertex_count; v++) {
            if (mt_oracle_in_circle(a, b, c, mesh->points[v]) <= 0) continue;
            mt_require(!in_window(component, middle, mt_spot_of(mesh->points[v], 3), 3), subject);
        }
    }
}

void mt_check_mesh(const mt_component *component, const mt_half_edges *mesh, const mt_subject *subject) {
    mt_require(mesh->vertex_count == point_count(component), subject);
    check_half_edges(mesh, subject);
    check_triangles(component, mesh, subject);
    if (!mt_oracle_is_clean(component)) return;
    check_boundary(component, mesh, subject);
    if (mesh->vertex_count <= WINDOW_POINTS_MAX) check_window(component, mesh, subject);
}

/* ---- pieces -------------------------------------------------------------------------------------------- */

static mt_point around(const mt_ring *ring, int i) {
    return ring->points[(i + ring->count) % ring->count];
}

/* Whether p's edge after i is q's edge after k the other way, and both corners of the union would be
 * convex. */
static bool could_merge(const mt_ring *p, int i, const mt_ring *q, int k) {
    if (!mt_point_equal(around(p, i), around(q, k + 1)) || !mt_point_equal(around(p, i + 1), around(q, k)))
        return false;
    mt_spot u = mt_spot_of(around(p, i), 1), v = mt_spot_of(around(p, i + 1), 1);
    mt_spot a = mt_spot_of(around(p, i - 1), 1), b = mt_spot_of(around(p, i + 2), 1);
    mt_spot c = mt_spot_of(around(q, k - 1), 1), d = mt_spot_of(around(q, k + 2), 1);
    return mt_oracle_orient(a, u, d) >= 0 && mt_oracle_orient(c, v, b) >= 0;
}

static void check_merged(const mt_pieces *pieces, const mt_subject *subject) {
    for (int m = 0; m < pieces->count; m++)
        for (int n = 0; n < m; n++) {
            const mt_ring *p = &pieces->rings[m], *q = &pieces->rings[n];
            for (int i = 0; i < p->count; i++)
                for (int k = 0; k < q->count; k++) mt_require(!could_merge(p, i, q, k), subject);
        }
}

static void check_count(const mt_component *component, int count, const mt_subject *subject) {
    int reflex = mt_oracle_reflex_count(component), holes = component->count - 1;
    mt_require(mt_reflex_count(component) == reflex, subject);
    mt_require(count <= 2 * reflex + 1 - holes, subject);
    mt_require(count >= (reflex + 1) / 2 + 1 - holes, subject);
}

void mt_check_pieces(const mt_component *component, const mt_pieces *pieces, const mt_subject *subject) {
    for (int i = 0; i < pieces->count; i++) {
        mt_require(mt_oracle_is_convex(&pieces->rings[i]), subject);
        for (int k = 0; k < pieces->rings[i].count; k++)
            mt_require(has_point(component, pieces->rings[i].points[k]), subject);
    }
    mt_require(mt_oracle_area2(pieces) == mt_oracle_area2(component), subject);
    check_cover(component, pieces, subject);
    if (!mt_oracle_is_clean(component)) return;
    for (int r = 0; r < component->count; r++)
        for (int i = 0; i < component->rings[r].count; i++)
            mt_require(has_point(pieces, component->rings[r].points[i]), subject);
    check_count(component, pieces->count, subject);
    check_merged(pieces, subject);
}
