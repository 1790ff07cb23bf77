/* Aligning the boundaries of two matched components, ring by ring: the place on one ring that goes with each place of the other. */
#pragma once

#include "morph/align/cost.h"
#include "morph/model/morph.h"

/* Steps through both rings, once around each; from one step to the next one sample advances by one, or both do. */
typedef struct mt_alignment {
    int count;
    mt_link *steps; /* sample of A, sample of B; cyclic */
    double cost;    /* the mean cost of its steps, by lifted length */
} mt_alignment;

/* A cheap alignment, by dynamic programming: the cheapest of those that start with the pair of least cost, or with one of the next
 * best partners of its sample on A. A start elsewhere can be cheaper. Costs are those of cost.h, weighted by lifted length (lifted.h); the two samples of a pin go
 * together. Swapping A and B swaps the result. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_align(const mt_ring_samples *a, const mt_frame *frame_a, const mt_ring_samples *b,
                   const mt_frame *frame_b, const mt_cost_weights *weights, const mt_links *pins,
                   mt_arena *arena, mt_alignment *alignment);

/* The pins of two rings: the point hints whose places lie near both. MT_NO_MEMORY. */
mt_status mt_pins_of(const mt_hints *hints, const mt_ring_samples *a, const mt_ring_samples *b,
                     mt_arena *arena, mt_links *pins);

/* Whether each step advances one ring or both, by one sample, and each ring goes once around. Linear. */
bool mt_alignment_is_valid(const mt_alignment *alignment);
