/* Cutting two glyphs once, each where the other has separate parts. */
#pragma once

#include "morph/model/morph.h"
#include "morph/model/settings.h"

/* One side, cut into parts. */
typedef struct mt_cut_side {
    mt_shape parts;
    int *partner; /* of each part, the other side's part that it goes with; -1: none */
} mt_cut_side;

/* Matches every ring of each side with the boundary of the other (ring_matching.h), cuts along chords that matches cross both ways,
 * pairs the parts (by the hints, then by align/pairing.h), and undoes the cuts that do not help. `hints` is not NULL. MT_NO_MEMORY,
 * MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_divide(const mt_side *a, const mt_side *b, const mt_hints *hints, const mt_settings *settings,
                    mt_arena *arena, mt_cut_side *cut_a, mt_cut_side *cut_b);

/* Whether the parts are a valid shape, and each partner is mutual. Linear. */
bool mt_cut_side_is_valid(const mt_cut_side *cut, const mt_cut_side *other);
