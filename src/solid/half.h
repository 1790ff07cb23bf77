/* One of the two solids: its components, its pieces, and where they are. */
#pragma once

#include "solid/piece.h"

/* The paper's attributes of a component in space: its convex hull's 3-tuple (p, s, t), relative to the solid's box. */
typedef struct mt_bulk {
    double centre[3];       /* p: the barycentre, each axis by the box' own side */
    double volume;          /* s: relative to the cube of the box' longest side */
    double low[3], high[3]; /* of t: the extremes, scaled as the centre */
} mt_bulk;

typedef struct mt_half {
    mt_cells cells;
    double depth; /* that pieces may leave their hulls by, grid units; 0: they are convex */
    int n_components, n_pieces;
    mt_bulk *components;
    int *component_of; /* of each piece */
    mt_part *parts;    /* of each piece: its surface */
    mt_piece *pieces;  /* once they are made */
    mt_vector3 *
        places; /* of each piece: the paper's coordinate vector, its barycentre in the box, 0 … 1 on each axis */
    mt_vector3 *centres; /* of each piece: its barycentre, grid units */
    double *volumes;     /* of each piece, grid units */
    bool *meets;         /* n_pieces × n_pieces: whether two pieces have a wall in common, or are the same */
} mt_half;

/* Cuts a mesh into pieces by the parameters: by MT_METHOD_PAPER each is convex but for rounding. All but `pieces` is then there.
 * MT_BAD_GEOMETRY, MT_TOO_LARGE, MT_NO_MEMORY. */
mt_status mt_half_of(mt_arena *arena, const mt_mesh *mesh, const mt_solid_params *params, mt_half *half);

/* All but `pieces` anew, after cells have been cut. MT_BAD_GEOMETRY, MT_NO_MEMORY. */
mt_status mt_half_measure(mt_arena *arena, mt_half *half);

/* Makes the pieces of the parts. MT_BAD_GEOMETRY, MT_NO_MEMORY. */
mt_status mt_half_make_pieces(mt_arena *arena, mt_half *half);

/* Orders two solids by themselves: < 0, 0, > 0. Of two that are swapped the same comes first: the one with
 * more pieces, so that each of them has its nearest. */
int mt_half_compare(const mt_half *p, const mt_half *q);

/* The similar function m(h1, h2) of section 2.2.1 with a third coordinate, 0 … 1 (docs/paper.md). */
double mt_bulk_similarity(const mt_bulk *h1, const mt_bulk *h2, const double weights[3]);
