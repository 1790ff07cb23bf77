/* What another font has for a lookup of A's. */
#pragma once

#include "anchors/subtable.h"

/* Another font's subtables that may anchor what a lookup of A's does; the first that applies decides. */
typedef struct mt_rivals {
    int count;
    mt_bytes *subtables;
} mt_rivals;

/* The font's subtables of the type in the features and language systems that A's lookup is in: of
 * later lookups first, because those are applied last and so decide. In the arena. MT_NO_MEMORY. */
mt_status mt_rivals_of(mt_anchor_job *job, int font, int lookup, mt_rivals *rivals); /* of that one alone */
mt_status mt_rivals_find(mt_anchor_job *job, int font, const mt_lookup_builder *lookup, mt_rivals *rivals);
