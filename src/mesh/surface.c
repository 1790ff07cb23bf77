#include "mesh/surface.h"

#include <stdlib.h>

/* ---- twins --------------------------------------------------------------------------------------------- */

typedef struct mt_edge {
    int low, high; /* points */
    int half_edge;
} mt_edge;

static int compare(const void *left, const void *right) {
    const mt_edge *a = left, *b = right;
    if (a->low != b->low) return a->low < b->low ? -1 : 1;
    if (a->high != b->high) return a->high < b->high ? -1 : 1;
    return (a->half_edge > b->half_edge) - (a->half_edge < b->half_edge);
}

static mt_status refuse(const mt_surface *surface, const mt_edge *edge, int count, mt_mesh_fault *fault) {
    char from[MT_PLACE_ROOM], to[MT_PLACE_ROOM];
    mt_place_write(surface->grid->mesh.points[edge->low], from);
    mt_place_write(surface->grid->mesh.points[edge->high], to);
    if (count == 1)
        return mt_mesh_say(fault, MT_NOT_SOLID, "the edge from %s to %s has one triangle; a solid is closed",
                           from, to);
    if (count > 2)
        return mt_mesh_say(fault, MT_NOT_SOLID, "the edge from %s to %s has %d triangles; a solid's has two",
                           from, to, count);
    return mt_mesh_say(fault, MT_NOT_SOLID,
                       "the triangles at the edge from %s to %s face opposite sides; a solid is oriented",
                       from, to);
}

/* The edges that are alike begin at `edges`, `count` of them. */
static mt_status join(mt_surface *surface, const mt_edge *edges, int count, mt_mesh_fault *fault) {
    int a = edges[0].half_edge, b = edges[count - 1].half_edge;
    if (count != 2 || mt_surface_start(surface, a) == mt_surface_start(surface, b))
        return refuse(surface, edges, count, fault);
    surface->twins[a] = b;
    surface->twins[b] = a;
    return MT_OK;
}

static void list_edges(const mt_surface *surface, int count, mt_edge *edges) {
    for (int e = 0; e < count; e++) {
        int from = mt_surface_start(surface, e), to = mt_surface_start(surface, mt_surface_next(e));
        edges[e] = from < to ? (mt_edge){from, to, e} : (mt_edge){to, from, e};
    }
    qsort(edges, (size_t)count, sizeof *edges, compare);
}

mt_status mt_surface_make(mt_grid_mesh *grid, mt_arena *arena, mt_mesh_fault *fault, mt_surface *surface) {
    int count = 3 * grid->mesh.n_triangles;
    mt_edge *edges = mt_new((size_t)count, sizeof *edges);
    *surface = (mt_surface){grid, mt_arena_new(arena, (size_t)count, sizeof *surface->twins)};
    mt_status status = edges && surface->twins ? MT_OK : MT_NO_MEMORY;
    if (status == MT_OK) list_edges(surface, count, edges);
    for (int i = 0, n; i < count && status == MT_OK; i += n) {
        for (n = 1; i + n < count && edges[i].low == edges[i + n].low && edges[i].high == edges[i + n].high;)
            n++;
        status = join(surface, edges + i, n, fault);
    }
    mt_free(edges);
    return status;
}

/* ---- slivers ------------------------------------------------------------------------------------------- */

static bool is_flat(const mt_grid_mesh *grid, int triangle) {
    const int *at = grid->mesh.triangles[triangle].at;
    mt_grid_normal n = mt_grid_normal_of(grid->at[at[0]], grid->at[at[1]], grid->at[at[2]]);
    return n.x == 0 && n.y == 0 && n.z == 0;
}

/* The half-edge of a flat triangle that runs from one end to the other: points are numbered in the order of their places, so that the
 * middle corner has the middle number. */
static int longest_edge(const mt_surface *surface, int triangle) {
    const int *at = surface->grid->mesh.triangles[triangle].at;
    for (int i = 0; i < 3; i++) {
        int a = at[i], b = at[(i + 1) % 3], middle = at[(i + 2) % 3];
        if ((a < middle && middle < b) || (b < middle && middle < a)) return 3 * triangle + i;
    }
    return 3 * triangle;
}

static void pair(mt_surface *surface, int a, int b) {
    surface->twins[a] = b;
    surface->twins[b] = a;
}

/* Makes a triangle one that mt_surface_make does not see: with one corner alone. */
static void drop(mt_surface *surface, int triangle) {
    int *at = surface->grid->mesh.triangles[triangle].at;
    at[1] = at[2] = at[0];
}

static bool is_dropped(const mt_surface *surface, int triangle) {
    const int *at = surface->grid->mesh.triangles[triangle].at;
    return at[0] == at[1];
}

/* Two triangles of the same three corners close on each other, and go. */
static void drop_both(mt_surface *surface, int h, int g) {
    int h1 = mt_surface_next(h), h2 = mt_surface_next(h1), g1 = mt_surface_next(g), g2 = mt_surface_next(g1);
    int h1_twin = surface->twins[h1], h2_twin = surface->twins[h2], g1_twin = surface->twins[g1],
        g2_twin = surface->twins[g2];
    if (h1_twin != g2) pair(surface, h1_twin, g2_twin);
    if (h2_twin != g1) pair(surface, h2_twin, g1_twin);
    drop(surface, h / 3);
    drop(surface, g / 3);
}

/* The edge that two triangles share becomes the one between their other corners. */
static void flip(mt_surface *surface, int h, int g) {
    int h1 = mt_surface_next(h), h2 = mt_surface_next(h1), g1 = mt_surface_next(g), g2 = mt_surface_next(g1);
    int p = mt_surface_start(surface, h), q = mt_surface_start(surface, h1),
        b = mt_surface_start(surface, h2), d = mt_surface_start(surface, g2);
    int outer[4] = {surface->twins[h2], surface->twins[g1], surface->twins[g2], surface->twins[h1]};
    int t = h / 3, u = g / 3;
    mt_triangle *triangles = surface->grid->mesh.triangles;
    int inner[4] = {3 * t, 3 * t + 1, 3 * u, 3 * u + 1};
    triangles[t] = (mt_triangle){{b, p, d}};
    triangles[u] = (mt_triangle){{d, q, b}};
    for (int i = 0; i < 4; i++) pair(surface, inner[i], outer[i]);
    pair(surface, 3 * t + 2, 3 * u + 2);
}

static void remove_sliver(mt_surface *surface, int triangle) {
    int h = longest_edge(surface, triangle), g = surface->twins[h];
    int middle = mt_surface_start(surface, mt_surface_next(mt_surface_next(h)));
    int across = mt_surface_start(surface, mt_surface_next(mt_surface_next(g)));
    if (middle == across)
        drop_both(surface, h, g);
    else
        flip(surface, h, g);
}

/* Closes the gaps that dropped triangles have left. */
static void gather(mt_surface *surface) {
    mt_mesh *mesh = &surface->grid->mesh;
    int n = 0;
    for (int t = 0; t < mesh->n_triangles; t++)
        if (!is_dropped(surface, t)) mesh->triangles[n++] = mesh->triangles[t];
    mesh->n_triangles = n;
}

mt_status mt_surface_remove_slivers(mt_surface *surface, mt_mesh_fault *fault, int *removed) {
    enum { ROUNDS_MAX = 64 };
    mt_grid_mesh *grid = surface->grid;
    char place[MT_PLACE_ROOM];
    *removed = 0;
    for (int round = 0, found = 1; found > 0; round++) {
        found = 0;
        for (int t = 0; t < grid->mesh.n_triangles; t++) {
            if (is_dropped(surface, t) || !is_flat(grid, t)) continue;
            if (round == ROUNDS_MAX) {
                mt_place_write(grid->mesh.points[grid->mesh.triangles[t].at[0]], place);
                return mt_mesh_say(fault, MT_NOT_SOLID, "a triangle at %s has no area", place);
            }
            remove_sliver(surface, t);
            found++;
        }
        *removed += found;
    }
    gather(surface);
    if (grid->mesh.n_triangles > 0) return MT_OK;
    return mt_mesh_say(fault, MT_NOT_SOLID, "none of its triangles has an area");
}
