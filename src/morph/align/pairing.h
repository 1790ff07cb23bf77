/* Which rings of one side go with which of the other: the cheapest pairs to align. */
#ifndef MT_MORPH_ALIGN_PAIRING_H
#define MT_MORPH_ALIGN_PAIRING_H

#include "morph/align/align.h"

/* Rings of one glyph, and its box. */
typedef struct mt_ring_list {
    int count;
    const mt_ring **rings;
    mt_box box;
} mt_ring_list;

/* Pairs rings so that aligning the boundaries of all pairs costs least in all, and none costs more than
 * `most`. partner_a[i] is the ring of B that goes with ring i of A, -1 where none does, and partner_b the other way
 * round: what they say before the call is kept. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_pair_rings(const mt_ring_list *a, const mt_ring_list *b, double most,
                        const mt_settings *settings, mt_arena *arena, int *partner_a, int *partner_b);

/* What it costs to align two rings, looked at coarsely: the mean of the steps. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_pair_cost(const mt_ring *p, mt_box box_p, const mt_ring *q, mt_box box_q,
                       const mt_settings *settings, mt_arena *arena, double *cost);

/* The outer rings of a shape's components, in its glyph's box. MT_NO_MEMORY. */
mt_status mt_outer_rings(const mt_shape *shape, mt_box box, mt_arena *arena, mt_ring_list *list);

#endif
