/* Section 2.2.1: the connected components of both sides, matched. */
#pragma once

#include "morph/model/morph.h"

/* Sets the matches of a morph's components, by similarity and relaxation. MT_NO_MEMORY. */
mt_status mt_match_sides(mt_morph *morph, const mt_params *params, mt_arena *arena);
