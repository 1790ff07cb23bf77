/* Places on a ring at which boundaries are compared. */
#pragma once

#include "geometry/trace.h"

/* A place on a ring: a vertex, or a place between two. */
typedef struct mt_ring_sample {
    double x, y;    /* grid units, on the curve that the ring stands for */
    double in, out; /* headings, radians: the same where the drawing is smooth */
    bool corner;    /* the drawing has a corner here */
    bool breaks;    /* a corner, or where a line begins or ends */
    bool extremum;  /* smooth, and turns back in x or in y */
    bool line;      /* a line leaves from here */
} mt_ring_sample;

typedef struct mt_ring_samples {
    int count;
    mt_ring_sample *samples;
} mt_ring_samples;

/* The samples of a ring whose curves were flattened within `flatness` grid units: its vertices, and evenly spaced places between two
 * that are further apart than `step` grid units. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_ring_samples_of(const mt_trace *trace, double flatness, double step, mt_arena *arena,
                             mt_ring_samples *samples);

/* The samples of a ring by itself: its vertices, and at least `least` in all. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_ring_samples_at_least(const mt_ring *ring, double flatness, double least, mt_arena *arena,
                                   mt_ring_samples *samples);
