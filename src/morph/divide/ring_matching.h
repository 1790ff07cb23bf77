/* Matching one ring with the whole boundary of another glyph: the boundary's sample for each of its samples, and the chords between. */
#pragma once

#include "morph/divide/boundary_graph.h"

/* A sample of the ring, its sample of the boundary, and the chord of the boundary that leads there from the step before, or -1. */
typedef struct mt_match_step {
    int here, there, chord;
} mt_match_step;

typedef struct mt_ring_match {
    int count;
    mt_match_step *steps;
    double cost; /* the mean cost of its steps */
} mt_ring_match;

/* The cheapest closed match, once around ring `ring` of `from`, with the boundary of `to`. The weight of corners is ignored. `start` is
 * a step that the match has to contain, such as the first of an earlier match; NULL: an open match finds one. MT_NO_MEMORY,
 * MT_TOO_LARGE. */
mt_status mt_match_ring(const mt_boundary *from, int ring, const mt_boundary *to,
                        const mt_cost_weights *weights, const mt_match_step *start, mt_arena *arena,
                        mt_ring_match *match);

/* Whether it is closed, steps differ, and a step over a chord stays at its sample of the ring. Linear. */
bool mt_ring_match_is_valid(const mt_ring_match *match);
