/* The distance of a hull from its part, by branch and bound over the hull's facets in triangles. The distance of a place from one triangle
 * of the part is a convex function of the place: over a triangle of the hull it is at most what it is at its corners. So where the
 * triangle that is nearest to the middle is near to all three corners, nothing in between is far. */
#include "solid/depth.h"

#include "space/nearest.h"
#include "space/vector.h"

/* How often a triangle of the hull is divided in four, and how many are looked at. The distance cannot be bounded where the middle's
 * nearest triangle ends; at this size what is left out is less than 1/128 of the facet. */
enum { DIVISIONS = 7, LOOKS = 200000 };

typedef struct mt_depth_search {
    const mt_part *part;
    mt_nearest_tree tree;
    double limit;
    int looks;
    mt_depth found;
} mt_depth_search;

static double distance_from(const mt_depth_search *s, mt_vector3 p, int triangle) {
    const int *at = s->part->triangles[triangle].at;
    const mt_vector3 *places = s->part->places;
    return mt_triangle_distance(p, places[at[0]], places[at[1]], places[at[2]]);
}

/* Looks at one triangle of the hull; at most DIVISIONS calls deep. */
static void look(mt_depth_search *s, mt_vector3 a, mt_vector3 b, mt_vector3 c, mt_vector3 normal,
                 int divisions) {
    mt_vector3 middle = mt_times3(1.0 / 3, mt_plus3(a, mt_plus3(b, c)));
    int nearest;
    if (s->looks++ >= LOOKS || s->found.distance > s->limit) return;
    double distance = mt_nearest(&s->tree, middle, &nearest);
    if (distance > s->found.distance) s->found = (mt_depth){distance, middle, normal};
    double most =
        fmax(distance_from(s, a, nearest), fmax(distance_from(s, b, nearest), distance_from(s, c, nearest)));
    if (most <= s->limit || divisions == 0) return;
    mt_vector3 ab = mt_between3(a, b, 0.5), bc = mt_between3(b, c, 0.5), ca = mt_between3(c, a, 0.5);
    look(s, ab, bc, ca, normal, divisions - 1);
    look(s, a, ab, ca, normal, divisions - 1);
    look(s, ab, b, bc, normal, divisions - 1);
    look(s, ca, bc, c, normal, divisions - 1);
}

mt_status mt_part_depth(mt_arena *arena, const mt_part *part, const mt_polytope *hull, double limit,
                        mt_depth *depth) {
    mt_depth_search s = {.part = part, .limit = limit};
    mt_status status = mt_nearest_tree_of(arena, part->places, part->triangles, part->n_triangles, &s.tree);
    if (status != MT_OK) return status;
    for (int f = 0; f < hull->n_facets; f++) {
        const mt_hull_facet *facet = &hull->facets[f];
        for (int i = 1; i + 1 < facet->n_corners; i++)
            look(&s, part->places[facet->corners[0]], part->places[facet->corners[i]],
                 part->places[facet->corners[i + 1]], facet->normal, DIVISIONS);
    }
    *depth = s.found;
    return MT_OK;
}

/* ---- reflex edges -------------------------------------------------------------------------------------- */

/* Whether a triangle is so thin that its plane is rounding only: less than four grid units high. */
static bool is_thin(const mt_part *part, int t) {
    const int *at = part->triangles[t].at;
    mt_vector3 a = part->places[at[0]], u = mt_minus3(part->places[at[1]], a),
               v = mt_minus3(part->places[at[2]], a);
    double longest = fmax(mt_length3(mt_minus3(u, v)), fmax(mt_length3(u), mt_length3(v)));
    return mt_length3(mt_cross3(u, v)) < 4 * longest;
}

double mt_part_rise(const mt_cells *cells, const mt_part *part, int e) {
    int twin = part->twins[e];
    if (is_thin(part, e / 3) || is_thin(part, twin / 3)) return 0;
    mt_plane own = mt_part_plane(cells, part, e / 3);
    int apex = part->triangles[twin / 3].at[(twin % 3 + 2) % 3];
    return mt_plane_is_none(&own) ? 0 : mt_plane_distance(&own, cells->points[part->point[apex]]);
}

bool mt_part_is_convex(const mt_cells *cells, const mt_part *part) {
    for (int e = 0; e < 3 * part->n_triangles; e++)
        if (mt_part_rise(cells, part, e) > MT_RISE_ROUNDED) return false;
    return true;
}
