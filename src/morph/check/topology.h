/* The topology of a drawing, and the topology error of a morph: how far in-betweens leave the range of both ends. */
#pragma once

#include "morph/model/morph.h"

/* Components, holes and ink of a shape. Seams (MT_SEAM_WIDTH) do not count. */
typedef struct mt_topology {
    int components, holes;
    int crumbs;  /* components and holes smaller than MT_CRUMB, not counted in the two */
    double area; /* em² */
} mt_topology;

mt_topology mt_topology_of(const mt_shape *shape);

/* The distance of a count from the range of the two ends'. */
int mt_count_excess(int count, int a, int b);

/* The distance of an area from the range of the two ends', relative to the larger. */
double mt_area_excess(double area, double a, double b);

/* T of place 0 … MT_TOPOLOGY_STEPS - 1 between the ends: half-way first, then on both sides of it, first towards the end with more ink,
 * so that the order does not depend on which end is A. */
double mt_topology_position(const mt_morph *morph, int number);

/* The error of a morph between its ends: at MT_TOPOLOGY_STEPS places, of which each stands for a twentieth of the way, and at one more of each
 * lull (check/lulls.h) that has none of them, which stands for its length. */
typedef struct mt_topology_error {
    int parts; /* components and holes out of the ends' range, times twentieths; rounded down, so that what is
                        over in less than one counts nothing */
    int merged; /* of these, components missing: fewer than at either end */
    int opened; /* and holes missing */
    bool stays; /* no place leaves the range, however short its lull */
    bool
        proved; /* every T between the ends has the topology of a place that was looked at, but for moments */
    int64_t corners; /* of all blends looked at to find the error */
} mt_topology_error;

/* Counts the blend as it is drawn (MT_NONZERO) and, where contours overlap, as it is meant (MT_POSITIVE): where a hole's contour leaves
 * its ink, the nonzero rule of fonts draws ink. Takes the worse of the two; stops once the parts are `enough`. As mt_morph_blend. */
mt_status mt_morph_topology_error(const mt_morph *morph, int enough, const mt_params *params, mt_arena *arena,
                                  mt_topology_error *by);
