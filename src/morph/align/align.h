/* Aligning the boundaries of two matched components, ring by ring: where on the one ring does each place of
 * the other go? */
#ifndef MT_MORPH_ALIGN_ALIGN_H
#define MT_MORPH_ALIGN_ALIGN_H

#include <math.h>

#include "geometry/trace.h"
#include "morph/model/morph.h"
#include "morph/model/settings.h"

/* A place on a ring: a vertex, or a place between two. */
typedef struct mt_ring_sample {
    double x, y;    /* grid units, on the curve that the ring stands for */
    double in, out; /* headings, radians: the same where the drawing is smooth */
    bool corner;    /* the drawing has a corner here */
    bool breaks;    /* a corner, or where a line begins or ends */
    bool extremum;  /* turns back in x or in y, smoothly */
    bool line;      /* goes on from here along a line */
} mt_ring_sample;

typedef struct mt_ring_samples {
    int count;
    mt_ring_sample *samples;
} mt_ring_samples;

/* The samples of a ring whose curves were flattened within `flatness` grid units: its vertices, and places between them where they
 * are further apart than `step`. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_ring_samples_of(const mt_trace *trace, double flatness, double step, mt_arena *arena,
                             mt_ring_samples *samples);

/* The samples of a ring by itself: its vertices, and at least `least` in all. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_ring_samples_at_least(const mt_ring *ring, double flatness, double least, mt_arena *arena,
                                   mt_ring_samples *samples);

/* A sample as the cost of a step sees it: its place relative to the glyph's box, and its headings as unit vectors. */
typedef struct mt_sample_view {
    double x, y;
    double in_x, in_y, out_x, out_y;
    double turn_x, turn_y; /* the direction out, relative to the direction in */
} mt_sample_view;

mt_sample_view mt_sample_view_of(const mt_ring_sample *sample, mt_box box);

/* What it costs that two samples go with each other. */
static inline double mt_step_cost(const mt_cost_weights *t, const mt_sample_view *a,
                                  const mt_sample_view *b) {
    double same = a->in_x * b->in_x + a->in_y * b->in_y + a->out_x * b->out_x + a->out_y * b->out_y;
    double alike = a->turn_x * b->turn_x + a->turn_y * b->turn_y;
    double dx = a->x - b->x, dy = a->y - b->y;
    return t->direction * (2 - same) / 4 + t->distance * sqrt(dx * dx + dy * dy) +
           t->corner * (1 - alike) / 2;
}

/* What it costs beside that one sample moves on while the other waits. */
#define MT_WAIT_COST 0.02

/* An alignment: steps through both rings, once around each; from one step to the next either sample moves on by
 * one, or both. */
typedef struct mt_alignment {
    int count;
    mt_link *steps; /* sample of A, sample of B; cyclic */
    double cost;    /* the mean of what its steps cost */
} mt_alignment;

/* The alignment of least cost, by cyclic dynamic programming: a step costs by how far apart its two samples
 * are, each relative to its own glyph's box, and by how much their headings differ, in and out, so that
 * corners go to corners. The samples of a pin go with each other. The same whichever of the rings is A's. O(n m).
 * MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_align(const mt_ring_samples *a, mt_box box_a, const mt_ring_samples *b, mt_box box_b,
                   const mt_cost_weights *weights, const mt_links *pins, mt_arena *arena,
                   mt_alignment *alignment);

/* The pins that hints ask for on two rings: those whose places lie near both. MT_NO_MEMORY. */
mt_status mt_pins_of(const mt_hints *hints, const mt_ring_samples *a, const mt_ring_samples *b,
                     mt_arena *arena, mt_links *pins);

#endif
