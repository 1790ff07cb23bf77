/* Aligning the boundaries of two matched components, ring by ring: where on the one ring does each place of
 * the other go? */
#ifndef MT_MORPH_ALIGN_ALIGN_H
#define MT_MORPH_ALIGN_ALIGN_H

#include "morph/align/cost.h"
#include "morph/model/morph.h"

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
