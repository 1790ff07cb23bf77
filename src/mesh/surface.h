/* The surface of a solid: each edge has two triangles, which run through it in opposite directions. */
#pragma once

#include "base/memory.h"
#include "mesh/fault.h"
#include "mesh/grid.h"

/* Half-edge e runs from corner e % 3 of triangle e / 3 to the next; twins[e] is the one that runs back. */
typedef struct mt_surface {
    mt_grid_mesh *grid;
    int *twins; /* 3 × triangles */
} mt_surface;

/* The half-edge after `e` around its triangle. */
static inline int mt_surface_next(int e) {
    return e % 3 == 2 ? e - 2 : e + 1;
}

/* The point at which half-edge `e` starts. */
static inline int mt_surface_start(const mt_surface *surface, int e) {
    return surface->grid->mesh.triangles[e / 3].at[e % 3];
}

/* Finds the twins; belongs to the arena. MT_NOT_SOLID, said with the first edge that is at fault; MT_NO_MEMORY. */
mt_status mt_surface_make(mt_grid_mesh *grid, mt_arena *arena, mt_mesh_fault *fault, mt_surface *surface);

/* Removes triangles without an area: their middle corners become corners of what lies across their longest edges. The surface is then
 * to be made again. How many there were; MT_NOT_SOLID where they cannot be removed. */
mt_status mt_surface_remove_slivers(mt_surface *surface, mt_mesh_fault *fault, int *removed);
