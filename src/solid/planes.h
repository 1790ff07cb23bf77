/* Planes that may be worth cutting a part by. */
#pragma once

#include "solid/depth.h"

typedef struct mt_planes {
    int count;
    mt_plane *planes;
    double *resolved; /* of each plane: the share of the reflex edges that lie in it, by length and angle */
} mt_planes;

/* The planes that hold most of the part's reflex edges: those of the triangles beside one, the one that halves the angle, those
 * through two that meet; slots across each axis; and planes through where the part is deepest, unless `depth` is NULL. MT_NO_MEMORY. */
mt_status mt_planes_for(mt_arena *arena, const mt_cells *cells, const mt_part *part, const mt_depth *depth,
                        mt_planes *planes);
