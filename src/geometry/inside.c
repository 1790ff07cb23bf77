/* Places and ink. A ray from the place to the right crosses the border an odd number of times inside the ink (exact, by mt_orient):
 *
 *     ──┐  ┌──┐     half-open edges, a.y ≤ p.y < b.y, count a vertex on the ray once
 *     p─┼──┼──┼─▶   3 crossings: in the ink
 *     ──┘  └──┘
 *
 * Distances to the border are found in the same pass. O(n) for n vertices of the shape. */
#include "geometry/inside.h"

#include <math.h>

/* Whether an edge is crossed by the ray from p to the right. */
static bool crosses(mt_point p, mt_point a, mt_point b) {
    if ((a.y <= p.y) == (b.y <= p.y)) return false;
    return (mt_orient(a, b, p) > 0) == (b.y > a.y);
}

/* The distance from a place to a component's border, grid units, and whether it is in its ink. */
static double to_border(const mt_component *component, mt_point p, bool *in_ink) {
    double least = INFINITY;
    bool inside = false;
    for (int r = 0; r < component->count; r++)
        for (int i = 0; i < component->rings[r].count; i++) {
            mt_point a = component->rings[r].points[i];
            mt_point b = component->rings[r].points[(i + 1) % component->rings[r].count];
            double way[2], distance = mt_way_to_edge(p, a, b, way);
            if (distance < least) least = distance;
            inside ^= crosses(p, a, b);
        }
    *in_ink = inside;
    return least;
}

/* The distance to its ink: 0 inside. */
static double to_ink(const mt_component *component, mt_point p) {
    bool inside;
    double distance = to_border(component, p, &inside);
    return inside ? 0 : distance;
}

int mt_component_at(const mt_shape *shape, mt_point place) {
    int nearest = 0;
    double least = INFINITY;
    for (int k = 0; k < shape->count; k++) {
        double distance = to_ink(&shape->components[k], place);
        if (distance >= least) continue;
        least = distance;
        nearest = k;
    }
    return nearest;
}

bool mt_is_in_ink(const mt_shape *shape, mt_point place) {
    for (int k = 0; k < shape->count; k++)
        if (to_ink(&shape->components[k], place) <= 0) return true;
    return false;
}

bool mt_is_deep_in_ink(const mt_shape *shape, mt_point place, double depth) {
    for (int k = 0; k < shape->count; k++) {
        bool inside;
        double distance = to_border(&shape->components[k], place, &inside);
        if (inside) return distance >= depth;
    }
    return false;
}

mt_vector mt_nearest_on_border(const mt_shape *shape, mt_point place) {
    double least = INFINITY;
    mt_vector nearest = {place.x, place.y};
    for (int k = 0; k < shape->count; k++)
        for (int r = 0; r < shape->components[k].count; r++) {
            const mt_ring *ring = &shape->components[k].rings[r];
            for (int i = 0; i < ring->count; i++) {
                double way[2],
                    apart = mt_way_to_edge(place, ring->points[i], ring->points[(i + 1) % ring->count], way);
                if (apart >= least) continue;
                least = apart;
                nearest = (mt_vector){place.x + way[0], place.y + way[1]};
            }
        }
    return nearest;
}
