/* Which part of one key frame becomes which of the next. */
#pragma once

#include "motion/figure.h"

/* Neighbouring parts of a figure. */
typedef struct mt_part_run {
    int first, count; /* 0 of them: nothing */
} mt_part_run;

/* Parts of A and parts of B, one of these at the most several; or a part that comes from nothing, or goes to nothing. */
typedef struct mt_part_pair {
    mt_part_run a, b;
} mt_part_pair;

typedef struct mt_part_pairs {
    int count;
    mt_part_pair *pairs; /* in the order of the page */
} mt_part_pairs;

/* Pairs parts in order: every part of the figure that has fewer gets a partner. Parts of the same text go together first, then the way
 * is the shortest. What the other figure has more goes with a neighbour whose partner has another text, or else by itself. In the arena.
 * O(n m) for n and m parts. MT_NO_MEMORY. */
mt_status mt_pair_parts(const mt_figure *a, const mt_figure *b, mt_arena *arena, mt_part_pairs *pairs);
