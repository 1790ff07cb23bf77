/* Quadratic splines through samples of a smooth curve. */
#ifndef MT_SPLINE_H
#define MT_SPLINE_H

#include "outline.h"

/* A point of the curve with its direction there (unit length), grid units. */
typedef struct mt_sample {
    double x, y;
    double dx, dy;
    bool node; /* a segment has to end here: an extremum */
} mt_sample;

/* The fewest quadratic Béziers from the first sample to the last, through some of the samples in their
 * directions and within `tolerance` of the others; of equally many, the closest. A stretch that is straight
 * within a tenth of the tolerance becomes a line. `segments` has room for count - 1; *made says how many
 * there are. MT_NO_MEMORY. */
mt_status mt_spline(const mt_sample *samples, int count, double tolerance, mt_arena *arena,
                    mt_segment *segments, int *made);

#endif
