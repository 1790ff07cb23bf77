/* How far past its ends a morph goes on: contours on the straight ways on which they come there. */
#pragma once

#include "morph/model/morph.h"

/* No morph goes farther past an end than from the one to the other. */
#define MT_REACH_MOST 1.0

/* From … to, T: -MT_REACH_MOST … 0, and 1 … 1 + MT_REACH_MOST. */
typedef struct mt_reach {
    double from, to;
} mt_reach;

/* As far as the morph has the components and holes of the nearer end: no T up to there lacks any of them, or has more. Past `wanted` it
 * need not have been looked for. A morph with links ends at its ends: a sum has no weight under 0. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_morph_reach(const mt_morph *morph, mt_reach wanted, const mt_params *params, mt_arena *arena,
                         mt_reach *reach);
