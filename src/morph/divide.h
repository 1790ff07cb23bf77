/* Dividing a component among several partners, so that the counts are equal on both sides (docs/paper.md, the joint method). */
#ifndef MT_DIVIDE_H
#define MT_DIVIDE_H

#include "morph/morph.h"

/* Cuts component k of `from` among `count` components of `to` along diagonals of its triangulation: each triangle goes to
 * the partner whose ink lies nearest to it, both relative to their glyph's box, with a price on the length of the cuts.
 * Writes a share for each partner, and sets *divided; clears it when some partner would get nothing, or a share in
 * several pieces. The shares' areas add up to the component's. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_divide(const mt_side *from, int k, const mt_side *to, const int *partners, int count,
                    mt_arena *arena, mt_component *shares, bool *divided);

#endif
