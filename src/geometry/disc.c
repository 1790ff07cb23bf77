/* A disc that touches the border at p has its middle at p + s n, n a unit vector into the region, and the radius ρ s: ρ = 1 on an edge, and
 * the sine of half the angle at a corner, whose two edges the disc touches both. It stays clear
 *
 *     of a point q:   |q − p − s n|² ≥ (ρ s)²
 *     of a line:      d + s k ≥ ρ s, d the distance of p from it, k the cosine between n and the line's normal towards p
 *
 * and each gives the largest s. The line counts where the disc would touch it within the edge. The largest disc of all touches the
 * border in several places: discs at PLACES places and at corners are looked at, and each is given up once it is no larger than
 * the largest so far. The edge that bounded one disc is tried first for the next, which mostly ends there. */
#include "geometry/disc.h"

#include <math.h>

#include "arithmetic/angles.h"

enum { PLACES = 200, CORNERS = 200, NORMALS = 3 };
#define CORNER_TURN 0.35 /* radians to the right: the border bends into the region there */

#define SHARP (2 * M_PI / 3) /* what turns by more is a tip, up to which the middle line goes */

typedef struct mt_edge_number {
    int ring, point;
} mt_edge_number;

/* A disc in the making: as far from the border as no edge so far forbids. */
typedef struct mt_disc {
    mt_vector at, normal;  /* of unit length */
    double ratio;          /* of the radius to the distance of the middle */
    double distance;       /* of the middle from `at` */
    mt_edge_number own[2]; /* edges that it touches */
} mt_disc;

static mt_point point_of(const mt_ring *ring, int i) {
    return ring->points[i == ring->count ? 0 : i < 0 ? ring->count - 1 : i];
}

static mt_vector way(mt_vector from, mt_point to) {
    return (mt_vector){to.x - from.x, to.y - from.y};
}

static double dot(mt_vector u, mt_vector v) {
    return u.x * v.x + u.y * v.y;
}

/* By a point, `to` from where the disc touches: the lesser root of the quadratic in s. */
static void bound_by_point(mt_disc *disc, mt_vector to) {
    double forward = dot(to, disc->normal), far2 = dot(to, to);
    double root = forward * forward - (1 - disc->ratio * disc->ratio) * far2;
    if (forward > 0 && root >= 0) disc->distance = fmin(disc->distance, far2 / (forward + sqrt(root)));
}

static void bound_by_edge(mt_disc *disc, mt_point a, mt_point b) {
    mt_vector to = way(disc->at, a), along = {(double)b.x - a.x, (double)b.y - a.y};
    double length = mt_hypot(along.x, along.y);
    bound_by_point(disc, to);
    if (length == 0) return;
    mt_vector across = {-along.y / length, along.x / length};
    double apart = -dot(to, across), k = dot(disc->normal, across);
    if (apart < 0) {
        apart = -apart;
        k = -k;
    }
    if (k >= disc->ratio) return;
    double distance = apart / (disc->ratio - k);
    if (distance >= disc->distance) return;
    mt_vector middle = {distance * disc->normal.x - to.x, distance * disc->normal.y - to.y};
    double share = dot(middle, along) / (length * length);
    if (share > 0 && share < 1) disc->distance = distance;
}

static bool is_own(const mt_disc *disc, int ring, int point) {
    for (int i = 0; i < 2; i++)
        if (disc->own[i].ring == ring && disc->own[i].point == point) return true;
    return false;
}

static void bound_by(mt_disc *disc, const mt_rings *region, int ring, int point) {
    const mt_ring *r = &region->rings[ring];
    if (is_own(disc, ring, point)) return;
    bound_by_edge(disc, r->points[point], point_of(r, point + 1));
}

/* Bounds the disc by all edges, or until it is no further than `least`. *last: the edge that bounded it; it is tried first. */
static void bound_by_all(const mt_rings *region, double least, mt_edge_number *last, mt_disc *disc) {
    bound_by(disc, region, last->ring, last->point);
    for (int i = 0; i < region->count; i++)
        for (int k = 0; k < region->rings[i].count; k++) {
            if (disc->distance <= least) return;
            double before = disc->distance;
            bound_by(disc, region, i, k);
            if (disc->distance < before) *last = (mt_edge_number){i, k};
        }
}

/* The nearest point before, or after, point i that lies elsewhere. */
static mt_point neighbour(const mt_ring *ring, int i, int step) {
    mt_point here = ring->points[i];
    for (int k = 1; k < ring->count; k++) {
        mt_point there = ring->points[(i + (step > 0 ? k : ring->count - k)) % ring->count];
        if (!mt_point_equal(here, there)) return there;
    }
    return here;
}

/* The turn at a point of a ring, radians: > 0 to the left. */
static double turn_at(const mt_ring *ring, int i) {
    mt_point p = neighbour(ring, i, -1), q = ring->points[i], r = neighbour(ring, i, 1);
    return mt_atan2((double)mt_cross(p, q, q, r), (double)mt_dot(p, q, q, r));
}

/* A unit vector to the left of the edge that comes to point i, turned by `turn`. */
static mt_vector normal_at(const mt_ring *ring, int i, double turn) {
    mt_point p = neighbour(ring, i, -1), q = ring->points[i];
    double angle = mt_atan2((double)q.y - p.y, (double)q.x - p.x) + M_PI / 2 + turn;
    return (mt_vector){mt_cos(angle), mt_sin(angle)};
}

static mt_edge_number edge_before(const mt_ring *ring, int number, int i) {
    return (mt_edge_number){number, i == 0 ? ring->count - 1 : i - 1};
}

mt_vector mt_way_to_middle(const mt_rings *region, int ring, int i, bool left) {
    const mt_ring *r = &region->rings[ring];
    double turn = turn_at(r, i), out = left ? turn : -turn;
    if (out > SHARP) return (mt_vector){0, 0};
    mt_vector normal = normal_at(r, i, turn / 2);
    if (!left) normal = (mt_vector){-normal.x, -normal.y};
    mt_disc disc = {{r->points[i].x, r->points[i].y},
                    normal,
                    out > 0 ? mt_cos(out / 2) : 1,
                    INFINITY,
                    {{ring, i}, edge_before(r, ring, i)}};
    bound_by_all(region, 0, &(mt_edge_number){ring, i}, &disc);
    double distance = isfinite(disc.distance) ? disc.distance : 0;
    return (mt_vector){distance * normal.x, distance * normal.y};
}

/* ---- the largest of all --------------------------------------------------------------------------------- */

typedef struct mt_disc_search {
    const mt_rings *region;
    mt_edge_number last;
    double largest;
} mt_disc_search;

static void look_at_place(mt_disc_search *s, mt_vector at, mt_vector normal, mt_edge_number own,
                          mt_edge_number before) {
    mt_disc disc = {at, normal, 1, INFINITY, {own, before}};
    bound_by_all(s->region, s->largest, &s->last, &disc);
    if (disc.distance > s->largest && disc.distance < INFINITY) s->largest = disc.distance;
}

/* Places along an edge, `apart` from each other around the whole border; *rest: how far the first one is from its start. */
static void look_along(mt_disc_search *s, mt_edge_number edge, double apart, double *rest) {
    const mt_ring *ring = &s->region->rings[edge.ring];
    mt_point a = ring->points[edge.point], b = point_of(ring, edge.point + 1);
    double x = (double)b.x - a.x, y = (double)b.y - a.y, length = mt_hypot(x, y);
    for (; *rest < length; *rest += apart)
        look_at_place(s, (mt_vector){a.x + x * *rest / length, a.y + y * *rest / length},
                      (mt_vector){-y / length, x / length}, edge, edge);
    *rest -= length;
}

/* Discs whose middles lie between the normals of both edges at a corner. */
static void look_at_corner(mt_disc_search *s, mt_edge_number edge, double turn) {
    const mt_ring *ring = &s->region->rings[edge.ring];
    mt_point q = ring->points[edge.point];
    for (int n = 1; n <= NORMALS; n++)
        look_at_place(s, (mt_vector){q.x, q.y}, normal_at(ring, edge.point, turn * n / (NORMALS + 1)), edge,
                      edge_before(ring, edge.ring, edge.point));
}

static void look_at_corners(mt_disc_search *s) {
    int left = CORNERS;
    for (int i = 0; i < s->region->count; i++)
        for (int k = 0; left > 0 && k < s->region->rings[i].count; k++) {
            double turn = turn_at(&s->region->rings[i], k);
            if (turn > -CORNER_TURN) continue;
            look_at_corner(s, (mt_edge_number){i, k}, turn);
            left--;
        }
}

double mt_largest_disc(const mt_rings *region, double least) {
    mt_disc_search search = {region, {0}, least};
    if (region->count == 0) return least;
    double apart = mt_rings_length(region) / PLACES, rest = apart / 2;
    for (int i = 0; i < region->count; i++)
        for (int k = 0; k < region->rings[i].count; k++)
            look_along(&search, (mt_edge_number){i, k}, apart, &rest);
    look_at_corners(&search);
    return search.largest;
}
