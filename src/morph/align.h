/* Aligning the boundaries of two matched components, ring by ring: where on the one ring does each place of
 * the other go? */
#ifndef MT_ALIGN_H
#define MT_ALIGN_H

#include "geometry/trace.h"
#include "morph/morph.h"

/* A place on a ring: a vertex, or a place between two. */
typedef struct mt_stop {
    double x, y;    /* grid units, on the curve that the ring stands for */
    double in, out; /* headings, radians: the same where the drawing is smooth */
    bool corner;    /* the drawing has a corner here */
    bool breaks;    /* a corner, or where a line begins or ends */
    bool extremum;  /* turns back in x or in y, smoothly */
} mt_stop;

typedef struct mt_stops {
    int count;
    mt_stop *stops;
} mt_stops;

/* The stops of a ring whose curves were flattened within `chord` grid units: its vertices, and places between them where they
 * are further apart than `step`. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_stops_of(const mt_trace *trace, double chord, double step, mt_arena *arena, mt_stops *stops);

/* An alignment: steps through both rings, once around each; from one step to the next either stop moves on by
 * one, or both. */
typedef struct mt_alignment {
    int count;
    mt_link *steps; /* stop of A, stop of B; cyclic */
    double cost;    /* the mean of what its steps cost */
} mt_alignment;

/* The alignment of least cost, by cyclic dynamic programming: a step costs by how far apart its two stops
 * are, each relative to its own glyph's box, and by how much their headings differ, in and out, so that
 * corners go to corners. O(n m). MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_align(const mt_stops *a, mt_box box_a, const mt_stops *b, mt_box box_b, mt_arena *arena,
                   mt_alignment *alignment);

#endif
