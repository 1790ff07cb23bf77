/* The morph: two shapes in, every shape between them out. Sections 2.1 to 2.3 of the paper, in its order.
 * Knows geometry only: no fonts, no files. */
#ifndef MT_MORPH_H
#define MT_MORPH_H

#include "geometry/minkowski.h"
#include "geometry/ring.h"

/* A pair of indices: into A's and into B's components, or pieces. */
typedef struct mt_link {
    int a, b;
} mt_link;

typedef struct mt_links {
    int count;
    mt_link *links; /* ordered by a, then b; no two alike */
} mt_links;

/* One side, decomposed. Pieces are numbered through all components: those of component k are
 * first[k] … first[k + 1] - 1. */
typedef struct mt_side {
    mt_shape shape;
    mt_box box; /* of the shape: the paper's minimum rectangle */
    mt_pieces pieces;
    int *first; /* shape.count + 1 of them */
} mt_side;

typedef struct mt_morph {
    mt_side a, b;     /* b turned by -degrees about its box's middle */
    mt_links matches; /* of components, 2.2.1 */
    mt_links links;   /* of pieces, 2.2.2: the paper's list R */
    double degrees;   /* q of formula (5); 0 without rotation */
} mt_morph;

/* Decomposes and matches. `params` gives weights, rounds, threshold, one_scale and rotation. Everything lives
 * in the arena, and the shapes must stay as long as the morph. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY;
 * MT_NO_COUNTERPART when one shape has ink and the other none. */
mt_status mt_morph_prepare(const mt_shape *a, const mt_shape *b, const mt_params *params, mt_arena *arena,
                           mt_morph *morph);

/* The blend C(r), or C_int(r) with rotation: the ink at these weights. May be called for many weights. */
mt_status mt_morph_blend(const mt_morph *morph, mt_weights weights, mt_arena *arena, mt_shape *blend);

#endif
