/* What all of the morph knows: two sides in convex pieces, what goes with what, and the contours that move (sections 2.1 to 2.3
 * of the paper, in its order). Knows geometry only: no fonts, no files. */
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

/* A morph as moving contours: compatible masters for all of it (between/variable_outline.h). */
typedef struct mt_variable_outline {
    int count;
    mt_contour_pair *contours; /* of B turned by -degrees, as in the morph */
} mt_variable_outline;

#endif
