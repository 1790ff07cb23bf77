/* Polygons in space cut into triangles, by ears: exact, in the plane that their normal stands on. */
#pragma once

#include "mesh/grid.h"

/* How many comparisons all polygons of a mesh may take. */
#define MT_POLYGON_WORK_MAX ((int64_t)1 << 31)

/* Cuts a polygon of `count` corners, at most MT_MESH_CORNERS_MAX, no two neighbours alike, into at most count - 2 triangles of distinct
 * corners; how many. One that cannot be cut by ears, because it crosses itself, is cut from one corner. `work` counts comparisons,
 * and over MT_POLYGON_WORK_MAX nothing is done. */
int mt_polygon_triangles(const mt_grid_point *at, const int *corners, int count, mt_triangle *triangles,
                         int64_t *work);
