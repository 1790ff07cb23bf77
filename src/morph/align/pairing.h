/* Pairs of rings of two sides: those that align at the least cost in all. */
#pragma once

#include "morph/align/align.h"

/* Rings of one glyph, and its frame. */
typedef struct mt_ring_list {
    int count;
    const mt_ring **rings;
    mt_frame frame;
} mt_ring_list;

/* Pairs rings so that the costs of aligning all pairs have the least sum, and none is above `most`. partner_a[i] is the ring of B
 * paired with ring i of A, or -1, and partner_b the inverse; pairs that they hold before the call are kept. MT_NO_MEMORY,
 * MT_TOO_LARGE. */
mt_status mt_pair_rings(const mt_ring_list *a, const mt_ring_list *b, double most,
                        const mt_settings *settings, mt_arena *arena, int *partner_a, int *partner_b);

/* The mean step cost of aligning two rings over coarse samples. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_pair_cost(const mt_ring *p, const mt_frame *frame_p, const mt_ring *q, const mt_frame *frame_q,
                       const mt_settings *settings, mt_arena *arena, double *cost);

/* The outer rings of a shape's components, in its glyph's frame. MT_NO_MEMORY. */
mt_status mt_outer_rings(const mt_shape *shape, const mt_frame *frame, mt_arena *arena, mt_ring_list *list);
