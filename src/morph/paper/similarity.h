/* The similarity of two components: section 2.2.1, the similar function m(h1, h2). */
#pragma once

#include "geometry/ring.h"

/* The paper's attributes of a component: its convex hull's 3-tuple (p, s, t), relative to the glyph's minimum
 * rectangle with the origin at its lower left corner. */
typedef struct mt_hull {
    double centre[2];       /* p: the barycentre, each axis by the rectangle's own side */
    double area;            /* s: relative to the square of the rectangle's longer side */
    double low[2], high[2]; /* of t: the extremes of x and y, scaled as the centre */
} mt_hull;

/* The hull of a component of a glyph whose minimum rectangle is `box`. MT_NO_MEMORY. */
mt_status mt_hull_of(const mt_component *component, mt_box box, mt_arena *arena, mt_hull *hull);

/* m(h1, h2) = w1 v1 + w2 v2 + w3 v3, 0 … 1 with 1 for equal hulls. The readings of v1, v2 and v3 are in
 * docs/paper.md. */
double mt_similarity(const mt_hull *h1, const mt_hull *h2, const double weights[3]);

/* Whether the barycentre lies within the extremes, and the area is not negative. */
bool mt_hull_is_valid(const mt_hull *hull);
