/* A cell cut in two by a plane. */
#pragma once

#include "solid/cells.h"

/* Cuts the cell: what lies below the plane keeps its number, what lies above gets a new one, and each is separated. Between them is a
 * cap, a polygon in the plane with holes. Corners of walls that are cut are rounded to the grid, for all cells that have them.
 * MT_BAD_GEOMETRY when the plane does not cut the cell, or rounding makes the cap's border cross itself; the cells are then as they
 * were. MT_NO_MEMORY. */
mt_status mt_cells_cut(mt_cells *cells, int cell, mt_plane plane);
