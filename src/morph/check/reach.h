/* How far a morph goes past its ends, contours on the straight ways on which they come there; and how far aside, to where T is
 * another one across than upwards. */
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

/* How far it goes aside on the straight way from a place with one T in both directions to `aim`: all of it, where at `aim` the counts of
 * components and holes are in the range of both ends and of `from`; otherwise as far as they are all along. A morph with links has no
 * place outside 0 … 1 in any direction, and none has with a turn of formula (5). As mt_morph_reach. */
mt_status mt_morph_aside(const mt_morph *morph, double from, mt_at aim, const mt_params *params,
                         mt_arena *arena, mt_at *reach);
