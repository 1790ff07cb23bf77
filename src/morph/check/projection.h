/* The ink of a drawing, projected on directions. */
#pragma once

#include "geometry/ring.h"

/* Directions, evenly spread over half a turn; bins across the ink; and shares of it whose places are kept. */
enum { MT_DIRECTIONS = 12, MT_BINS = 128, MT_QUANTILES = 32 };

/* What is projected where: x is taken from `middle`, and bins reach from -reach to reach, grid units. Ink beyond is in the last bin. */
typedef struct mt_projection_frame {
    double middle, base, reach;
} mt_projection_frame;

typedef struct mt_projection {
    double area;                               /* grid units squared */
    double share[MT_DIRECTIONS][MT_BINS];      /* of the ink, up to the end of each bin */
    double place[MT_DIRECTIONS][MT_QUANTILES]; /* of each quantile, grid units */
} mt_projection;

/* Projects the ink of rings that do not cross, with the ink to the left. Exact at the bins' ends; places in between are interpolated.
 * O(directions · (points + bins)). */
void mt_project(const mt_rings *rings, const mt_projection_frame *frame, mt_projection *projection);

/* The places of the quantiles of a share by bins. */
void mt_quantiles_of(const double share[MT_BINS], double reach, double place[MT_QUANTILES]);
