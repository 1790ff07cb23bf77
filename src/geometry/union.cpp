/* Clipper behind union.h. No exception leaves it.
 *
 * Clipper gives points without marks. Marks are found again by place: a point that was a vertex of a ring has the marks of all rings'
 * vertices there, any other is a crossing; an edge has the marks of an edge that went in at its start, or end, and runs along it within
 * two grid units. Invariants: the order of rings and points is that of their places, whatever Clipper's; the only rounding is that of
 * crossings. O(n log n) for marks, and Clipper's O((n + k) log n) for k crossings. */
#include <algorithm>
#include <cassert>
#include <cmath>
#include <new>
#include <polyclipping/clipper.hpp>
#include <vector>

extern "C" {
#include "geometry/crossings.h"
#include "geometry/union.h"
}

using namespace ClipperLib;

namespace {

struct Edge {
    mt_point start, end;
    uint8_t marks;
};

bool lower(mt_point p, mt_point q) {
    return p.y != q.y ? p.y < q.y : p.x < q.x;
}

/* Every edge that goes in, both ways around since a union may turn rings about, by its start: so that marks
 * can be found again for what comes out. */
struct Marks {
    std::vector<Edge> edges;

    explicit Marks(const mt_rings *rings) {
        for (int i = 0; i < rings->count; i++) {
            const mt_ring &ring = rings->rings[i];
            for (int k = 0; k < ring.count; k++) {
                mt_point p = ring.points[k], q = ring.points[(k + 1) % ring.count];
                edges.push_back({p, q, ring.marks[k]});
                edges.push_back({q, p, static_cast<uint8_t>(ring.marks[k] & MT_EDGE_MARKS)});
            }
        }
        std::stable_sort(edges.begin(), edges.end(),
                         [](const Edge &a, const Edge &b) { return lower(a.start, b.start); });
    }

    std::vector<Edge>::const_iterator first_at(mt_point p) const {
        return std::lower_bound(edges.begin(), edges.end(), p,
                                [](const Edge &edge, mt_point q) { return lower(edge.start, q); });
    }

    /* Where drawings disagree on a point, it is a corner. */
    uint8_t of_point(mt_point p) const {
        auto e = first_at(p);
        if (e == edges.end() || !mt_point_equal(e->start, p)) return MT_CROSSING;
        uint8_t marks = 0;
        for (; e != edges.end() && mt_point_equal(e->start, p); ++e) marks |= e->marks & MT_POINT_MARKS;
        return marks;
    }

    uint8_t of_edge_from(mt_point p, mt_point q) const {
        for (auto e = first_at(p); e != edges.end() && mt_point_equal(e->start, p); ++e)
            if (along(e->start, e->end, p, q)) return e->marks & MT_EDGE_MARKS;
        return 0;
    }

    /* An edge that comes out lies along one that went in and has its start or, cut short by a crossing, its
     * end. A crossing is rounded to the grid, so that the direction may differ by a grid unit at that end. */
    uint8_t of_edge(mt_point p, mt_point q) const {
        uint8_t marks = of_edge_from(p, q);
        return marks ? marks : of_edge_from(q, p);
    }

    /* Whether p→q runs the way of a→b and leaves it by at most two grid units over the length of a→b. */
    static bool along(mt_point a, mt_point b, mt_point p, mt_point q) {
        double off = std::abs(static_cast<double>(mt_cross(a, b, p, q)));
        double length = std::sqrt(static_cast<double>(mt_distance2(a, b)));
        return mt_dot(a, b, p, q) > 0 && off <= 2 * length;
    }
};

Paths paths_of(const mt_rings *rings) {
    Paths paths;
    for (int i = 0; i < rings->count; i++) {
        Path path;
        for (int k = 0; k < rings->rings[i].count; k++)
            path.push_back(IntPoint(rings->rings[i].points[k].x, rings->rings[i].points[k].y));
        paths.push_back(path);
    }
    return paths;
}

mt_point point_of(const IntPoint &p) {
    return {static_cast<int32_t>(p.X), static_cast<int32_t>(p.Y)};
}

mt_status ring_of(const Path &path, mt_arena *arena, mt_ring *ring) {
    mt_status status = mt_ring_new(arena, static_cast<int>(path.size()), ring);
    if (status != MT_OK) return status;
    auto first = std::min_element(path.begin(), path.end(), [](const IntPoint &p, const IntPoint &q) {
        return lower(point_of(p), point_of(q));
    });
    size_t offset = static_cast<size_t>(first - path.begin());
    for (size_t k = 0; k < path.size(); k++) ring->points[k] = point_of(path[(offset + k) % path.size()]);
    return MT_OK;
}

/* One outer polygon of the tree with its holes. Where edges lie on one another, as in a ring that is folded to a line, Clipper gives
 * polygons that enclose nothing, or lie the wrong way around: these are no ink, and no holes. */
mt_status component_of(const PolyNode &outer, mt_arena *arena, mt_component *component) {
    size_t count = outer.Childs.size() + 1;
    *component = {static_cast<int>(count),
                  static_cast<mt_ring *>(mt_arena_new(arena, count, sizeof(mt_ring)))};
    if (!component->rings) return MT_NO_MEMORY;
    mt_status status = ring_of(outer.Contour, arena, &component->rings[0]);
    component->count = 1;
    for (const PolyNode *hole : outer.Childs) {
        if (status != MT_OK) return status;
        if (Area(hole->Contour) < 0)
            status = ring_of(hole->Contour, arena, &component->rings[component->count++]);
    }
    if (status != MT_OK) return status;
    std::sort(component->rings + 1, component->rings + component->count,
              [](const mt_ring &a, const mt_ring &b) { return lower(a.points[0], b.points[0]); });
    return MT_OK;
}

mt_status shape_of(const PolyTree &tree, mt_arena *arena, mt_shape *shape) {
    std::vector<const PolyNode *> outers;
    for (const PolyNode *node = tree.GetFirst(); node; node = node->GetNext())
        if (!node->IsHole() && Area(node->Contour) > 0) outers.push_back(node);
    shape->count = static_cast<int>(outers.size());
    shape->components = static_cast<mt_component *>(mt_arena_new(arena, outers.size(), sizeof(mt_component)));
    if (!shape->components) return MT_NO_MEMORY;
    for (size_t i = 0; i < outers.size(); i++) {
        mt_status status = component_of(*outers[i], arena, &shape->components[i]);
        if (status != MT_OK) return status;
    }
    std::sort(shape->components, shape->components + shape->count,
              [](const mt_component &a, const mt_component &b) {
                  return lower(a.rings[0].points[0], b.rings[0].points[0]);
              });
    return MT_OK;
}

void mark(const Marks &marks, mt_ring *ring) {
    for (int k = 0; k < ring->count; k++) {
        mt_point p = ring->points[k], q = ring->points[(k + 1) % ring->count];
        ring->marks[k] = marks.of_point(p) | marks.of_edge(p, q);
    }
}

/* Clipper catches what its own allocations throw, and says no more than that it failed. A drawing that it cannot unite, it cannot a second
 * time. */
bool unite(const Paths &paths, PolyFillType filled, PolyTree *tree) {
    for (int tries = 0; tries < 2; tries++) {
        Clipper clipper;
        if (!clipper.AddPaths(paths, ptSubject, true)) return true; /* nothing encloses an area */
        if (clipper.Execute(ctUnion, *tree, filled, filled)) return true;
        tree->Clear();
    }
    return false;
}

} // namespace

extern "C" mt_status mt_union_unmarked(const mt_rings *rings, mt_rule rule, mt_arena *arena,
                                       mt_shape *shape) try {
    mt_status status = mt_pay_for_union(rings, arena);
    if (status != MT_OK) return status;
    PolyTree tree;
    PolyFillType filled = rule == MT_POSITIVE ? pftPositive : rule == MT_EVEN_ODD ? pftEvenOdd : pftNonZero;
    if (!unite(paths_of(rings), filled, &tree)) return MT_BAD_GEOMETRY;
    mt_shape made;
    status = shape_of(tree, arena, &made);
    assert(status != MT_OK || mt_shape_is_valid(&made));
    if (status == MT_OK) *shape = made;
    return status;
} catch (const clipperException &) {
    return MT_TOO_LARGE;
} catch (const std::bad_alloc &) {
    return MT_NO_MEMORY;
}

extern "C" mt_status mt_union(const mt_rings *rings, mt_rule rule, mt_arena *arena, mt_shape *shape) try {
    const Marks marks(rings);
    mt_shape made;
    mt_status status = mt_union_unmarked(rings, rule, arena, &made);
    if (status != MT_OK) return status;
    for (int k = 0; k < made.count; k++)
        for (int i = 0; i < made.components[k].count; i++) mark(marks, &made.components[k].rings[i]);
    *shape = made;
    return MT_OK;
} catch (const std::bad_alloc &) {
    return MT_NO_MEMORY;
}
