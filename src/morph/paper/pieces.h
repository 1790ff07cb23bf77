/* Sections 2.1 and 2.2.2 of the paper for a whole morph: convex pieces and their links. */
#pragma once

#include "morph/model/morph.h"

/* Cuts the components that are not joined into convex pieces, and links these, as the params' method says. As
 * mt_decompose and mt_link_pieces. */
mt_status mt_map_pieces(mt_morph *morph, const mt_params *params, mt_arena *arena);
