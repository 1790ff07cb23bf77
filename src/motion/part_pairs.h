/* Which part of one key frame becomes which of the next. */
#pragma once

#include "motion/figure.h"

/* A part of A and one of B; -1 where a part comes from nothing, or goes to nothing. */
typedef struct mt_part_pair {
    int a, b;
} mt_part_pair;

typedef struct mt_part_pairs {
    int count;
    mt_part_pair *pairs; /* in the order of the page */
} mt_part_pairs;

/* Pairs parts in order: every part of the figure that has fewer gets a partner. Parts of the same text go together first, then the way
 * is the shortest. In the arena. O(n m) for n and m parts. MT_NO_MEMORY. */
mt_status mt_pair_parts(const mt_figure *a, const mt_figure *b, mt_arena *arena, mt_part_pairs *pairs);
