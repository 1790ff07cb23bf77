/* Quadratic splines through samples of a smooth curve, or of two curves at once with common nodes. */
#pragma once

#include "geometry/outline.h"

typedef struct mt_vec {
    double x, y;
} mt_vec;

/* A point of the curve with its direction there (unit length), grid units. */
typedef struct mt_sample {
    double x, y;
    double dx, dy;
    bool node; /* a segment has to end here: an extremum */
} mt_sample;

/* The sample at a place with a heading, radians; at a node, which is an extremum, the heading is that of the nearest axis. */
mt_sample mt_sample_at(double x, double y, double heading, bool node);

#define MT_MASTERS_MAX 2

/* The turn of one quadratic, at most, degrees: one that turns by more is too pointed for any drawing. */
#define MT_SEGMENT_TURN_MAX 100.0

/* The fewest quadratic Béziers from the first sample to the last, through some of the samples in their
 * directions and within `tolerance` of the others; of equally many, the closest. With two masters, sample k
 * of the one goes with sample k of the other, and so do the segments: they end at the same samples, where the
 * directions differ least, and fit both. A stretch that is straight within a tenth of the tolerance in every
 * master becomes a line. segments[m] has room for count - 1, and so has ends, for the number of the sample at which each
 * segment ends; *made says how many there are. MT_NO_MEMORY, MT_TOO_LARGE
 * where the arena's steps do not do. */
mt_status mt_spline(const mt_sample *const *masters, int master_count, int count, double tolerance,
                    mt_arena *arena, mt_segment *const *segments, int *ends, int *made);
