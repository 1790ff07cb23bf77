#include "mesh/contact.h"

#include <stdlib.h>

typedef struct mt_corners {
    mt_grid_point at[3];
} mt_corners;

/* ---- a segment and a triangle --------------------------------------------------------------------------- */

static bool in_order(int64_t a, int64_t b, int64_t c) {
    return (a <= b && b <= c) || (c <= b && b <= a);
}

/* Closed segments in the plane. */
static bool segments_meet(mt_grid_flat p, mt_grid_flat q, mt_grid_flat a, mt_grid_flat b) {
    int pa = mt_grid_turn(p, q, a), pb = mt_grid_turn(p, q, b), ap = mt_grid_turn(a, b, p),
        aq = mt_grid_turn(a, b, q);
    if (pa * pb < 0 && ap * aq < 0) return true;
    if (pa == 0 && in_order(p.x, a.x, q.x) && in_order(p.y, a.y, q.y)) return true;
    if (pb == 0 && in_order(p.x, b.x, q.x) && in_order(p.y, b.y, q.y)) return true;
    if (ap == 0 && in_order(a.x, p.x, b.x) && in_order(a.y, p.y, b.y)) return true;
    return aq == 0 && in_order(a.x, q.x, b.x) && in_order(a.y, q.y, b.y);
}

/* A segment in the triangle's plane. */
static bool meet_in_plane(const mt_corners *t, mt_grid_point p, mt_grid_point q) {
    mt_grid_normal normal = mt_grid_normal_of(t->at[0], t->at[1], t->at[2]);
    mt_grid_flat from = mt_grid_drop(p, normal), to = mt_grid_drop(q, normal), flat[3];
    for (int i = 0; i < 3; i++) flat[i] = mt_grid_drop(t->at[i], normal);
    bool inside = true;
    for (int i = 0; i < 3; i++) {
        inside = inside && mt_grid_turn(flat[i], flat[(i + 1) % 3], from) >= 0;
        if (segments_meet(from, to, flat[i], flat[(i + 1) % 3])) return true;
    }
    return inside;
}

/* Both closed. */
static bool segment_meets(const mt_corners *t, mt_grid_point p, mt_grid_point q) {
    int from = mt_grid_side(t->at[0], t->at[1], t->at[2], p),
        to = mt_grid_side(t->at[0], t->at[1], t->at[2], q);
    if (from * to > 0) return false;
    if (from == 0 && to == 0) return meet_in_plane(t, p, q);
    int lowest = 1, highest = -1;
    for (int i = 0; i < 3; i++) {
        int side = mt_grid_side(p, q, t->at[i], t->at[(i + 1) % 3]);
        lowest = side < lowest ? side : lowest;
        highest = side > highest ? side : highest;
    }
    return lowest >= 0 || highest <= 0;
}

/* ---- two triangles -------------------------------------------------------------------------------------- */

static bool any_edge_meets(const mt_corners *edges, const mt_corners *t) {
    for (int i = 0; i < 3; i++)
        if (segment_meets(t, edges->at[i], edges->at[(i + 1) % 3])) return true;
    return false;
}

/* The corners of `t` in turn from number `first` on. */
static mt_corners corners_from(const mt_grid_mesh *grid, mt_triangle t, int first) {
    mt_corners corners;
    for (int i = 0; i < 3; i++) corners.at[i] = grid->at[t.at[(first + i) % 3]];
    return corners;
}

/* With one corner in common, the first of both: they have more where the edge across from it meets the other one. */
static bool touch_beyond_corner(const mt_corners *a, const mt_corners *b) {
    return segment_meets(b, a->at[1], a->at[2]) || segment_meets(a, b->at[1], b->at[2]);
}

/* With an edge in common, the first two corners of `a`: they have more where they lie on one side of it in one plane. */
static bool touch_beyond_edge(const mt_corners *a, mt_grid_point across) {
    if (mt_grid_side(a->at[0], a->at[1], a->at[2], across) != 0) return false;
    mt_grid_normal normal = mt_grid_normal_of(a->at[0], a->at[1], a->at[2]);
    return mt_grid_turn(mt_grid_drop(a->at[0], normal), mt_grid_drop(a->at[1], normal),
                        mt_grid_drop(across, normal)) > 0;
}

bool mt_triangles_touch(const mt_grid_mesh *grid, mt_triangle a, mt_triangle b) {
    int shared = 0, last_a = 0, last_b = 0, sum_a = 0, sum_b = 0;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            if (a.at[i] != b.at[k]) continue;
            shared++;
            last_a = i, last_b = k;
            sum_a += i, sum_b += k;
        }
    mt_corners from_a = corners_from(grid, a, last_a), from_b = corners_from(grid, b, last_b);
    if (shared == 3) return true;
    if (shared == 1) return touch_beyond_corner(&from_a, &from_b);
    if (shared == 0) return any_edge_meets(&from_a, &from_b) || any_edge_meets(&from_b, &from_a);
    int other_a = 3 - sum_a, other_b = 3 - sum_b; /* those that are not shared */
    from_a = corners_from(grid, a, (other_a + 1) % 3);
    return touch_beyond_edge(&from_a, grid->at[b.at[other_b]]);
}

/* ---- slips ---------------------------------------------------------------------------------------------- */

/* How far `t` reaches through the plane of `through`: on the side where it reaches less far, and in units of the longest coordinate of
 * the plane's normal. */
static bool reaches_far(const mt_corners *through, const mt_corners *t, bool *crosses) {
    mt_grid_normal n = mt_grid_normal_of(through->at[0], through->at[1], through->at[2]);
    mt_int128 above = 0, below = 0;
    for (int i = 0; i < 3; i++) {
        mt_grid_point p = t->at[i], o = through->at[0];
        mt_int128 height =
            (mt_int128)n.x * (p.x - o.x) + (mt_int128)n.y * (p.y - o.y) + (mt_int128)n.z * (p.z - o.z);
        if (height > above) above = height;
        if (-height > below) below = -height;
    }
    int64_t longest = llabs(n.x) > llabs(n.y) ? llabs(n.x) : llabs(n.y);
    if (llabs(n.z) > longest) longest = llabs(n.z);
    *crosses = above > 0 && below > 0;
    return (above < below ? above : below) > (mt_int128)longest * MT_SLIP;
}

bool mt_triangles_slip(const mt_grid_mesh *grid, mt_triangle a, mt_triangle b) {
    mt_corners of_a = corners_from(grid, a, 0), of_b = corners_from(grid, b, 0);
    bool a_crosses, b_crosses, a_far = reaches_far(&of_b, &of_a, &a_crosses),
                               b_far = reaches_far(&of_a, &of_b, &b_crosses);
    return a_crosses && b_crosses && !(a_far && b_far);
}
