/* A mesh whose points stand on a grid of whole numbers, so that what is asked of it is decided exactly. */
#pragma once

#include "morphotype.h"

/* Cells along the longest side of the mesh's box: products of three differences fit 128 bits. */
#define MT_GRID_CELLS (1 << 22)

__extension__ typedef __int128 mt_int128;

typedef struct mt_grid_point {
    int32_t x, y, z; /* 0 … MT_GRID_CELLS */
} mt_grid_point;

typedef struct mt_grid_mesh {
    mt_grid_point *at; /* no two alike */
    mt_mesh mesh;      /* of the same points, in the units of the file */
} mt_grid_mesh;

/* Where d is of the plane through a, b and c: > 0 on the side from which they are clockwise, 0 on it. */
int mt_grid_side(mt_grid_point a, mt_grid_point b, mt_grid_point c, mt_grid_point d);

/* Twice the area vector of the triangle; each number is under 2^46. */
typedef struct mt_grid_normal {
    int64_t x, y, z;
} mt_grid_normal;
mt_grid_normal mt_grid_normal_of(mt_grid_point a, mt_grid_point b, mt_grid_point c);

/* A point of the plane that is left when the axis along which `normal` is longest is dropped, so that it keeps its turning. */
typedef struct mt_grid_flat {
    int64_t x, y;
} mt_grid_flat;
mt_grid_flat mt_grid_drop(mt_grid_point point, mt_grid_normal normal);

/* > 0 where a, b and c turn left. */
int mt_grid_turn(mt_grid_flat a, mt_grid_flat b, mt_grid_flat c);
