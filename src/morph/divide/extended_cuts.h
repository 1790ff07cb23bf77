/* Parts that were cut apart lie over one another, as strokes do that a designer puts together. */
#ifndef MT_MORPH_DIVIDE_EXTENDED_CUTS_H
#define MT_MORPH_DIVIDE_EXTENDED_CUTS_H

#include "morph/divide/division.h"

/* Where two parts of one side meet at a cut and their partners on the other side are apart, lengthens the one that ends at
 * the cut into the ink of the other, by as much as the partners are apart: so they part half-way and not at once. The ink
 * of each side, which is in_a and in_b, stays what it is. MT_NO_MEMORY. */
mt_status mt_extend_cuts(const mt_shape *in_a, mt_cut_side *a, const mt_shape *in_b, mt_cut_side *b,
                         mt_arena *arena);

#endif
