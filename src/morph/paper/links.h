/* Mapping convex pieces: formula (3) and the three steps of section 2.2.2. */
#pragma once

#include "morph/model/morph.h"

/* The list R for two decomposed sides whose components are matched. Pieces are compared by the place of their
 * barycentres in their glyph's minimum rectangle: each axis by its own side or, with one_scale, both by the
 * longer. Every piece of a matched component has at least one link,
 * all inside matched components. MT_NO_MEMORY. */
mt_status mt_link_pieces(const mt_side *a, const mt_side *b, const mt_links *matches, bool one_scale,
                         mt_arena *arena, mt_links *links);

/* The same, from whichever side comes first in an order of their own: swapping A and B swaps the links. */
mt_status mt_link_evenly(const mt_side *a, const mt_side *b, const mt_links *matches, bool one_scale,
                         mt_arena *arena, mt_links *links);
