/* How a place of one drawing moves with the contours around it. */
#pragma once

#include "morph/model/morph.h"

/* Contour pairs sampled along the one side: where each sample is, how far its counterpart on the other side is from there, and the
 * length that it stands for. Without contours, places move with the boxes. */
typedef struct mt_carrier {
    int count;
    struct mt_carried_sample *samples;
    mt_box box, other_box;
} mt_carrier;

/* `in_a`: from A's places to B's, else from B's to A's. The boxes are of the glyph that places are on, and of the other. MT_NO_MEMORY. */
mt_status mt_carrier_of(const mt_contour_pair *contours, int count, bool in_a, mt_box box, mt_box other_box,
                        mt_arena *arena, mt_carrier *carrier);

/* Where a place goes, grid units. O(samples). */
mt_vector mt_carry(const mt_carrier *carrier, mt_vector place);
