/* What a drawing consists of, and how far that strays on the way from what both ends have. */
#ifndef MT_MORPH_CHECK_TOPOLOGY_H
#define MT_MORPH_CHECK_TOPOLOGY_H

#include "morph/model/morph.h"

/* Components, holes and ink of a shape. Seams (MT_SEAM_WIDTH) do not count. */
typedef struct mt_topology {
    int components, holes;
    int crumbs;  /* components and holes smaller than MT_CRUMB, which are not in those */
    double area; /* em² */
} mt_topology;

mt_topology mt_topology_of(const mt_shape *shape);

/* By how much a count is out of the range of the two ends'. */
int mt_count_excess(int count, int a, int b);

/* How far the ink is out of the range of the two ends', relative to the larger. */
double mt_area_excess(double area, double a, double b);

/* The places between the ends at which is looked, 0 … MT_TOPOLOGY_STEPS - 1: half-way first, then to both sides of it, first
 * towards the end with more ink, so that it is all the same which end is A. */
double mt_topology_position(const mt_morph *morph, int number);

/* How far a morph strays, over MT_TOPOLOGY_STEPS places between its ends. */
typedef struct mt_topology_error {
    int parts; /* by how many components and holes its in-betweens are out of the ends' range, all added up */
    int merged;      /* of these, the components that are fewer than at either end */
    int opened;      /* and the holes that are */
    double ink;      /* how far the ink is, at most, relative to the larger end */
    int64_t corners; /* of all that was looked at to say so */
} mt_topology_error;

/* Counts the blend as it is drawn and, where contours lie over one another, as it is meant: what a hole's contour goes around
 * outside of its ink is not meant, though the nonzero rule of fonts draws it. Takes the worse of the two; goes on until the parts
 * are `enough`. As mt_morph_blend. */
mt_status mt_morph_topology_error(const mt_morph *morph, int enough, const mt_params *params, mt_arena *arena,
                                  mt_topology_error *by);

#endif
