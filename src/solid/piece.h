/* A piece ready for sums: its surface, its hull, and which of the hull's facets each of its triangles goes with.
 *
 * The hull's edges are drawn on the surface of the piece, each along the shortest way between its ends. They divide the surface as they
 * divide the hull: what lies under a facet, be it a part of it or a dent that it spans, goes with that facet. */
#pragma once

#include "solid/cells.h"
#include "space/hull.h"

/* An edge of the hull. `left` and `right` are the facets on both sides of the way from u to v, as seen from outside. */
typedef struct mt_ridge {
    int u, v, left, right;
    int n_steps;
    int *steps; /* edges of the surface (3 t + i) from u to v */
} mt_ridge;

typedef struct mt_piece {
    mt_part part;
    mt_polytope hull; /* of the part's points */
    int *facet_of;    /* of each triangle */
    int n_ridges;
    mt_ridge *ridges;
    int *ridges_at, *first_ridge; /* those at point p: ridges_at[first_ridge[p]] … [first_ridge[p + 1] - 1] */
} mt_piece;

/* `part` is a ball. MT_BAD_GEOMETRY, MT_NO_MEMORY. */
mt_status mt_piece_of(mt_arena *arena, const mt_part *part, mt_piece *piece);
