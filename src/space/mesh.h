/* Meshes of triangles in space, in the units of the file that they come from. */
#pragma once

/* A place or a direction in space. */
typedef struct mt_vector3 {
    double x, y, z;
} mt_vector3;

typedef struct mt_triangle {
    int at[3]; /* points of the mesh, anticlockwise as seen from outside */
} mt_triangle;

typedef struct mt_mesh {
    int n_points, n_triangles;
    mt_vector3 *points;
    mt_triangle *triangles;
} mt_mesh;
