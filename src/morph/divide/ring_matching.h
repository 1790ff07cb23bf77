/* Walking around one ring while walking on another glyph's boundary: where each sample goes, and which chords it takes. */
#ifndef MT_MORPH_DIVIDE_RING_MATCHING_H
#define MT_MORPH_DIVIDE_RING_MATCHING_H

#include "morph/divide/boundary_graph.h"

/* One step of a walk: the sample of the ring, the sample of the boundary, and the chord of the boundary that was crossed to get there from
 * the step before, or -1. */
typedef struct mt_match_step {
    int here, there, chord;
} mt_match_step;

typedef struct mt_ring_match {
    int count;
    mt_match_step *steps;
    double cost; /* the mean of what its steps cost */
} mt_ring_match;

/* The cheapest closed walk once around ring `ring` of `from` on the boundary of `to`, by dynamic programming over what is in the window of
 * each sample; the weights's corners do not count. `start` is a step that it has to have, such as the first of an earlier walk; NULL:
 * one is found, by an open walk. O(n m) for n samples of the ring and m of the boundary. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_match_ring(const mt_boundary *from, int ring, const mt_boundary *to,
                        const mt_cost_weights *weights, const mt_match_step *start, mt_arena *arena,
                        mt_ring_match *walk);

#endif
