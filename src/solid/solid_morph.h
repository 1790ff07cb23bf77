/* The paper's method in space: two solids, each cut into pieces, and the links between the pieces. Each link is a mesh
 * whose points move on straight lines from the second solid (r = 0) to the first (r = 1); the solid at r is the union
 * of all links' meshes at r. */
#pragma once

#include "morphotype.h"
#include "space/mesh.h"

typedef struct mt_arena mt_arena;

typedef struct mt_solid_side {
    int n_components, n_pieces;
    mt_mesh *pieces;   /* closed, each in one part */
    int *component_of; /* of each piece */
} mt_solid_side;

/* The sum r·(piece of A) ⊕ (1 − r)·(piece of B). */
typedef struct mt_solid_link {
    int piece_a, piece_b;
    int n_points, n_triangles;
    mt_vector3 *at_a, *at_b; /* a point is at r·at_a + (1 − r)·at_b */
    mt_triangle *triangles;
} mt_solid_link;

typedef struct mt_solid_morph {
    mt_solid_side a, b;
    int n_links;
    mt_solid_link *links;
    mt_vector3 middle_a,
        middle_b;    /* of both boxes: the solid at r is turned about r·middle_a + (1 − r)·middle_b, */
    mt_vector3 axis; /* about this axis of length 1, */
    double degrees;  /* by (1 − r) times this: B has been turned back by it */
} mt_solid_morph;

/* `a` and `b` are closed and oriented (mt_mesh_check). All of `morph` belongs to the arena. MT_BAD_GEOMETRY, MT_NO_MEMORY. */
mt_status mt_solid_prepare(mt_arena *arena, const mt_mesh *a, const mt_mesh *b, const mt_solid_params *params,
                           mt_solid_morph *morph);

/* All links at r (0 … 1), turned, as one mesh of meshes that overlap. MT_NO_MEMORY. */
mt_status mt_solid_at(mt_arena *arena, const mt_solid_morph *morph, double r, mt_mesh *mesh);
