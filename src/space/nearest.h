/* The nearest place of a surface. */
#pragma once

#include "base/memory.h"
#include "morphotype.h"

typedef struct mt_nearest_node mt_nearest_node;

/* A tree of boxes over the triangles of a surface. */
typedef struct mt_nearest_tree {
    const mt_vector3 *points;
    const mt_triangle *triangles;
    int *order; /* triangles, those of a node next to each other */
    mt_nearest_node *nodes;
    int n_nodes;
} mt_nearest_tree;

/* `points` and `triangles` have to stay. MT_NO_MEMORY. */
mt_status mt_nearest_tree_of(mt_arena *arena, const mt_vector3 *points, const mt_triangle *triangles,
                             int n_triangles, mt_nearest_tree *tree);

/* The distance of p from the surface, and the triangle that is that near. */
double mt_nearest(const mt_nearest_tree *tree, mt_vector3 p, int *triangle);

/* The distance of p from one triangle. */
double mt_triangle_distance(mt_vector3 p, mt_vector3 a, mt_vector3 b, mt_vector3 c);
