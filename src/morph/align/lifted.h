/* A ring by its lifted length: its share of length and its share of turning, one half each.
 *
 * Where a boundary is smooth, it is compared place by place. A corner turns at one place, and a round that it goes with does so over many:
 * so a corner is seen as a fan of headings, from the one in to the one out. What each view weighs is the lifted length around it.
 * A ring that is thin, flat or cornered weighs as much as one that is fat and round: the flat end of a stroke has a half turn
 * at any width. */
#pragma once

#include "morph/align/view.h"

typedef struct mt_lifted_ring {
    int count; /* of views */
    mt_sample_view *views;
    int *of;       /* the sample that each is of; those of one are beside each other */
    float *weight; /* of each; 1 in all */
} mt_lifted_ring;

/* In the arena. MT_NO_MEMORY. */
mt_status mt_lift_ring(const mt_ring_samples *samples, const mt_frame *frame, mt_arena *arena,
                       mt_lifted_ring *lifted);
