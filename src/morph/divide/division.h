/* Cutting two glyphs once, each where the other is apart. */
#ifndef MT_SHARES_H
#define MT_SHARES_H

#include "morph/model/morph.h"
#include "morph/model/settings.h"

/* One side, cut into shares. */
typedef struct mt_cut_side {
    mt_shape shares;
    int *partner; /* of each share, that of the other side; -1 where none is */
} mt_cut_side;

/* Walks around every ring of each side on the border of the other (walk.h), cuts where walkers cross the ink both ways, pairs
 * what comes of it (as the hints say, then by pairing.h), and takes back the cuts that do not help. `hints` is not NULL.
 * MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_find_shares(const mt_side *a, const mt_side *b, const mt_hints *hints, const mt_manner *manner,
                         mt_arena *arena, mt_cut_side *cut_a, mt_cut_side *cut_b);

#endif
