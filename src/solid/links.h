/* Sections 2.2.1 and 2.2.2 in space: which components go together, and the list R of links between pieces. */
#pragma once

#include "morph/model/morph.h"
#include "solid/half.h"

/* The links from `first` to `second`, ordered, no two alike: the components by relaxation, formulas (1) and (2); the pieces of matched
 * components by formula (3) and the algorithm's three steps; and as few more as keep together what hangs together in both. Two links
 * hang together when their pieces meet in both solids. MT_NO_MEMORY. */
mt_status mt_link_halves(mt_arena *arena, const mt_half *first, const mt_half *second, mt_links *links);

/* Adds to the links what keeps together what hangs together in both, as mt_link_halves does. MT_NO_MEMORY. */
mt_status mt_links_join(mt_arena *arena, const mt_half *first, const mt_half *second, mt_links *links);
