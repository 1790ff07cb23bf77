/* Whether two triangles have more in common than the corners that they share; exact. */
#pragma once

#include "mesh/grid.h"

/* Neither triangle is flat. */
bool mt_triangles_touch(const mt_grid_mesh *grid, mt_triangle a, mt_triangle b);

/* Grid units that one triangle may reach through another for a slip, 1/2048 of the longest side; measured along the longest coordinate
 * of a normal, which is 1 to 1.8 times as much as square to the plane. */
#define MT_SLIP (MT_GRID_CELLS / 2048)

/* Whether two triangles cross, and one would no longer if it were moved by MT_SLIP. Those that only touch do not. */
bool mt_triangles_slip(const mt_grid_mesh *grid, mt_triangle a, mt_triangle b);
