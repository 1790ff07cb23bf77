/* A solid in cells: closed regions that meet in walls. To cut is to put walls in, to merge is to take walls out; whatever two cells have
 * in common, they have with the same triangles, so that no rounding opens a seam between them. */
#pragma once

#include "base/memory.h"
#include "space/place.h"

#define MT_OUTSIDE (-1)

/* A triangle between two cells. */
typedef struct mt_wall {
    int at[3];    /* points, anticlockwise as seen from in front */
    int behind;   /* the cell there */
    int in_front; /* the cell there, or MT_OUTSIDE */
    int plane;
} mt_wall;

typedef struct mt_cells {
    mt_arena *arena;
    int n_points, points_room, n_walls, walls_room, n_planes, planes_room, n_cells;
    mt_place *points;
    mt_wall *walls;
    mt_plane *planes;
    double unit;         /* of the grid, in the mesh's units */
    mt_vector3 origin;   /* the mesh's place at (0, 0, 0) of the grid */
    const mt_mesh *mesh; /* which it was made of */
    int *source;         /* of the first n_source points: the mesh's point */
    int n_source;
    double diagonal; /* of the solid's box, grid units */
} mt_cells;

/* One cell by itself: a closed surface of triangles. Where it touches itself in an edge or at a point, it has points of its own for
 * each of its sheets, so that every edge has two triangles and every point one fan of them. */
typedef struct mt_part {
    int n_points, n_triangles;
    int *point;         /* of each point: the cells' */
    mt_vector3 *places; /* of each point, grid units */
    mt_triangle *triangles;
    int *
        twins; /* of edge 3 t + i, from corner i of triangle t to the next: the edge along it the other way */
    int *walls;   /* of each triangle */
    bool *turned; /* of each triangle: the part is in front of its wall */
} mt_part;

/* The edge after `edge` around its triangle, the one before it, and the points where it starts and ends. */
static inline int mt_edge_after(int edge) {
    return edge % 3 == 2 ? edge - 2 : edge + 1;
}

static inline int mt_edge_before(int edge) {
    return edge % 3 == 0 ? edge + 2 : edge - 1;
}

static inline int mt_edge_start(const mt_part *part, int edge) {
    return part->triangles[edge / 3].at[edge % 3];
}

static inline int mt_edge_end(const mt_part *part, int edge) {
    return mt_edge_start(part, mt_edge_after(edge));
}

/* The cells of a solid: its components, one each. Triangles that rounding to the grid leaves without area are gone. MT_BAD_GEOMETRY
 * when nothing is left, MT_NO_MEMORY. */
mt_status mt_cells_of(mt_arena *arena, const mt_mesh *mesh, mt_cells *cells);

/* A cell, or two as if they were one (`other`, or else -1). MT_BAD_GEOMETRY when the walls around it do not close, MT_NO_MEMORY. */
mt_status mt_part_of(mt_arena *arena, const mt_cells *cells, int cell, int other, mt_part *part);

/* The volume of a part, grid units. */
double mt_part_volume(const mt_part *part);

/* The plane of a triangle of a part: its normal leads out. */
mt_plane mt_part_plane(const mt_cells *cells, const mt_part *part, int triangle);

/* Whether a part is a ball: in one piece, without a tunnel or a hollow. MT_NO_MEMORY. */
mt_status mt_part_is_ball(mt_arena *arena, const mt_part *part, bool *ball);

/* Takes out the walls between two cells; `other` is no more. */
void mt_cells_merge(mt_cells *cells, int cell, int other);

/* Gives the parts of a cell that have become disjoint numbers of their own. Hollows stay with the part around them. MT_BAD_GEOMETRY,
 * MT_NO_MEMORY. */
mt_status mt_cells_separate(mt_cells *cells, int cell);

/* A point in the mesh's units: where the mesh has it, or where the grid has it. */
mt_vector3 mt_cells_place(const mt_cells *cells, int point);

/* The plane of a wall as seen from inside `cell`: its normal leads out. */
mt_plane mt_wall_plane(const mt_cells *cells, int wall, int cell);
