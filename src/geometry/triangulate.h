/* Exact constrained Delaunay triangulation of a component over its own vertices. */
#pragma once

#include "geometry/ring.h"

/* Triangles as half-edges. Half-edge e starts at corner start[e]; its triangle is e / 3, the next one around
 * it is e + 1, or e - 2 at e % 3 == 2; twin[e] is the half-edge on the other side of a diagonal, or -1 on the
 * boundary. marks[e] are those of the ring point whose edge runs along e; a diagonal has the corner of the
 * vertex that it starts at, and is a line. Triangles are anticlockwise. A vertex is an index over all rings'
 * points, ring after ring. */
typedef struct mt_half_edges {
    int triangle_count;
    int *start; /* 3 × triangle_count vertices */
    int *twin;  /* 3 × triangle_count half-edges */
    uint8_t *marks;
    int vertex_count;
    mt_point *points; /* the component's points, ring after ring; they belong to the arena */
} mt_half_edges;

/* The half-edge after `e` around its triangle. */
static inline int mt_mesh_after(int e) {
    return e % 3 == 2 ? e - 2 : e + 1;
}

/* Triangulates. The rings may touch at points and along edges, but not cross. MT_NO_MEMORY, MT_TOO_LARGE,
 * MT_BAD_GEOMETRY when rings cross. */
mt_status mt_triangulate(const mt_component *component, mt_arena *arena, mt_half_edges *mesh);

/* Whether triangles are anticlockwise with area, twins are mutual, and both run between the same vertices. Linear. */
bool mt_half_edges_is_valid(const mt_half_edges *mesh);
