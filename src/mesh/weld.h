/* From a draft to a mesh on the grid. */
#pragma once

#include "base/memory.h"
#include "mesh/draft.h"
#include "mesh/grid.h"

/* Points on one place of the grid become one, the first; polygons become triangles; those without an area, because two corners are
 * one, are left out. All belongs to the arena. MT_NOT_SOLID where nothing is left; MT_TOO_LARGE; MT_NO_MEMORY. */
mt_status mt_grid_weld(const mt_draft *draft, mt_arena *arena, mt_grid_mesh *grid);
