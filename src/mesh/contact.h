/* Whether two triangles have more in common than the corners that they share; exact. */
#pragma once

#include "mesh/grid.h"

/* Neither triangle is flat. */
bool mt_triangles_touch(const mt_grid_mesh *grid, mt_triangle a, mt_triangle b);
