/* The contours of a morph as edges between points that move. */
#pragma once

#include "morph/check/way.h"
#include "morph/model/morph.h"

/* Points that are together at every T are one, and so are edges between the same two points, whichever way they run: on both sides of a
 * cut that both ends have. Points are numbered from 0. */
typedef struct mt_moving_edges {
    int part_count; /* straight parts that ways have: 1, or 2 of equal length where a contour is displaced */
    bool shared;    /* a point is on two contours, or twice on one */
    double
        least_area2; /* twice the area that a contour has at least, at any T; grid units squared, 0 where it may turn over */
    double least_width; /* twice that area over the contour's length; grid units */
    int point_count;
    mt_way *ways[2]; /* of each point, in each part; half grid units */
    int edge_count;
    mt_link *edges;  /* a and b: points, different ones; in the order of the contours */
    int *first;      /* of each point, and one more: where its neighbours begin */
    int *neighbours; /* the points at the other end of a point's edges */
} mt_moving_edges;

/* Contours flattened alike at both ends within `tolerance` grid units, and the sums of links, whose corners move straight as well. Without
 * the turn of formula (5), which changes nothing in how they lie to one another. MT_NO_MEMORY; MT_TOO_LARGE also for places out of
 * MT_WAY_MOST. */
mt_status mt_moving_edges_of(const mt_morph *morph, double tolerance, mt_arena *arena,
                             mt_moving_edges *edges);
