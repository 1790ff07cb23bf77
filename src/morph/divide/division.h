/* Cutting two glyphs once, each where the other is apart. */
#ifndef MT_MORPH_DIVIDE_DIVISION_H
#define MT_MORPH_DIVIDE_DIVISION_H

#include "morph/model/morph.h"
#include "morph/model/settings.h"

/* One side, cut into parts. */
typedef struct mt_cut_side {
    mt_shape parts;
    int *partner; /* of each part, that of the other side; -1 where none is */
} mt_cut_side;

/* Walks around every ring of each side on the boundary of the other (walk.h), cuts where matchers cross the ink both ways, pairs
 * what comes of it (as the hints say, then by pairing.h), and takes back the cuts that do not help. `hints` is not NULL.
 * MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_divide(const mt_side *a, const mt_side *b, const mt_hints *hints, const mt_settings *settings,
                    mt_arena *arena, mt_cut_side *cut_a, mt_cut_side *cut_b);

#endif
