/* The structs that all of the morph shares, in the order of the paper's sections 2.1 to 2.3: two sides in convex pieces, the links
 * between them, and contours that vary from A's to B's. They know geometry only: no fonts, no files. */
#pragma once

#include "geometry/minkowski.h"
#include "geometry/outline.h"
#include "morph/model/frame.h"
#include "morph/model/hints.h"

/* A pair of indices: into A's and into B's components, or pieces. */
typedef struct mt_link {
    int a, b;
} mt_link;

/* By a, then b: for qsort and bsearch of mt_link. */
int mt_link_compare(const void *p, const void *q);

typedef struct mt_links {
    int count;
    mt_link *links; /* ordered by a, then b; no two alike */
} mt_links;

/* One side, decomposed. Pieces are numbered through all components: those of component k are
 * first[k] … first[k + 1] - 1; an aligned component has none. */
typedef struct mt_side {
    mt_shape whole; /* as it was drawn */
    mt_shape
        shape; /* its components; MT_METHOD_JOINT cuts them where the other side has several, and may fill white */
    mt_box box;     /* of the shape: the paper's minimum rectangle */
    mt_frame frame; /* in which its places are seen where boundaries are compared */
    bool *aligned;  /* of each component: it is morphed by contours, not by links */
    mt_pieces pieces;
    int *first; /* shape.count + 1 of them */
} mt_side;

/* Compatible masters: two contours with as many segments, of the same degrees. Every point moves on a straight line from one to the
 * other, or on two where the contour is displaced. */
typedef struct mt_contour_pair {
    mt_contour a, b;
    mt_point displacement; /* of the whole contour half-way; it falls off in proportion towards both ends */
} mt_contour_pair;

typedef struct mt_morph {
    mt_side a, b;      /* b turned by -degrees about its box's middle */
    mt_links matches;  /* of components, 2.2.1 */
    int contour_count; /* contours of the aligned components; 0 with MT_METHOD_PAPER */
    mt_contour_pair *contours;
    mt_links links; /* of the others' pieces, 2.2.2: the paper's list R */
    double degrees; /* q of formula (5); 0 without rotation */
    bool
        proved; /* components and holes are in the ends' range at every T (check/topology.h); false: not known, or they are not */
    bool cut_short; /* the allowance was spent before all settings were tried */
} mt_morph;

/* A whole morph as compatible masters (between/variable_outline.h). */
typedef struct mt_variable_outline {
    int count;
    mt_contour_pair *contours; /* of B turned by -degrees, as in the morph */
} mt_variable_outline;

/* Whether the struct keeps its invariants, in linear time, asserted where it is made. Links: within the counts, ordered, no
 * two alike. A side: its shapes' and pieces' invariants; an aligned component has no pieces, any other has some. A contour
 * pair: as many segments of the same degrees, 1 or 2. A variable outline and a morph: those of their members. */
bool mt_links_is_valid(const mt_links *links, int count_a, int count_b);
bool mt_side_is_valid(const mt_side *side);
bool mt_contour_pair_is_valid(const mt_contour_pair *pair);
bool mt_variable_outline_is_valid(const mt_variable_outline *outline);
bool mt_morph_is_valid(const mt_morph *morph);
