/* Walking around one ring while walking on another glyph's border: where each stop goes, and which bridges it takes. */
#ifndef MT_WALK_H
#define MT_WALK_H

#include "morph/divide/boundary_graph.h"

/* One step of a walk: the stop of the ring, the stop of the border, and the bridge of the border that was crossed to get there from
 * the step before, or -1. */
typedef struct mt_pace {
    int here, there, bridge;
} mt_pace;

typedef struct mt_walk {
    int count;
    mt_pace *paces;
    double price; /* the mean of what its paces cost */
} mt_walk;

/* The cheapest closed walk once around ring `ring` of `from` on the border of `to`, by dynamic programming over what is in sight of
 * each stop; the tariff's corners do not count. `start` is a pace that it has to have, such as the first of an earlier walk; NULL:
 * one is found, by an open walk. O(n m) for n stops of the ring and m of the border. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_walk_around(const mt_border *from, int ring, const mt_border *to, const mt_tariff *tariff,
                         const mt_pace *start, mt_arena *arena, mt_walk *walk);

#endif
