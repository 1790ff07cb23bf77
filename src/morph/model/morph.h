/* The morph: two shapes in, every shape between them out. Sections 2.1 to 2.3 of the paper, in its order.
 * Knows geometry only: no fonts, no files. */
#ifndef MT_MORPH_MODEL_MORPH_H
#define MT_MORPH_MODEL_MORPH_H

#include "geometry/minkowski.h"
#include "geometry/outline.h"
#include "morph/model/hints.h"

/* A pair of indices: into A's and into B's components, or pieces. */
typedef struct mt_link {
    int a, b;
} mt_link;

typedef struct mt_links {
    int count;
    mt_link *links; /* ordered by a, then b; no two alike */
} mt_links;

/* One side, decomposed. Pieces are numbered through all components: those of component k are
 * first[k] … first[k + 1] - 1; an aligned component has none. */
typedef struct mt_side {
    mt_shape whole; /* as it was drawn */
    mt_shape shape; /* its components: with MT_METHOD_JOINT cut where the other side is apart */
    mt_box box;     /* of the shape: the paper's minimum rectangle */
    bool *aligned;  /* of each component: it moves by contours, not by links */
    mt_pieces pieces;
    int *first; /* shape.count + 1 of them */
} mt_side;

/* Compatible masters: two contours with as many segments, of the same degrees, between which every point
 * moves on a straight line, or on one that is bent half-way. */
typedef struct mt_contour_pair {
    mt_contour a, b;
    mt_point
        displacement; /* how far the contour stands aside half-way, to make way for another; in proportion between there and the ends */
} mt_contour_pair;

typedef struct mt_morph {
    mt_side a, b;      /* b turned by -degrees about its box's middle */
    mt_links matches;  /* of components, 2.2.1 */
    int contour_count; /* of the aligned components; none with MT_METHOD_PAPER */
    mt_contour_pair *contours;
    mt_links links; /* of the others' pieces, 2.2.2: the paper's list R */
    double degrees; /* q of formula (5); 0 without rotation */
} mt_morph;

/* Decomposes and matches, as `hints` (unless NULL) say where they say something; with MT_METHOD_JOINT, aligns what can be. Everything lives in the arena, and the
 * shapes must stay as long as the morph. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY; MT_NO_COUNTERPART when
 * one shape has ink and the other none. */
mt_status mt_morph_prepare(const mt_shape *a, const mt_shape *b, const mt_hints *hints,
                           const mt_params *params, mt_arena *arena, mt_morph *morph);

/* The rings that the blend at these weights is the union of: links' sums, and contours flattened within the params' tolerance. */
mt_status mt_morph_rings(const mt_morph *morph, mt_weights weights, const mt_params *params, mt_arena *arena,
                         mt_rings *rings);

/* The blend C(r), or C_int(r) with rotation, as polygons: the ink at these weights. May be called for many
 * weights. */
mt_status mt_morph_blend(const mt_morph *morph, mt_weights weights, const mt_params *params, mt_arena *arena,
                         mt_shape *blend);

/* The same as curves: the contours of aligned components as they are, the others' union fitted; where these
 * overlap, or a contour crosses itself, the union of all, fitted. */
mt_status mt_morph_outline(const mt_morph *morph, mt_weights weights, const mt_params *params,
                           mt_arena *arena, mt_outline *outline);

/* The outline of a shape by itself, curves fitted as in a blend. MT_NO_MEMORY. */
mt_status mt_shape_outline(const mt_shape *shape, const mt_params *params, mt_arena *arena,
                           mt_outline *outline);

#endif
