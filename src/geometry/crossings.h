/* How often the edges of rings cross, and where: what a union of them costs beside their corners. */
#pragma once

#include "geometry/ring.h"

typedef struct mt_crossings {
    int64_t count;
    int64_t compared; /* pairs of edges that are at one height */
} mt_crossings;

/* Pairs of edges that cross, in their middles. MT_TOO_LARGE where there are more than `most`, or MT_COMPARED_MAX pairs at one height;
 * MT_NO_MEMORY. O(n log n) where edges are short, O(n²) at the worst. */
#define MT_COMPARED_MAX ((int64_t)1 << 28)
mt_status mt_count_crossings(const mt_rings *rings, int64_t most, mt_arena *arena, mt_crossings *crossings);

/* The places where they cross, in their middles, each rounded to the nearest point of the grid, halves upwards. MT_TOO_LARGE for more than
 * MT_POINTS_MAX, or MT_COMPARED_MAX pairs at one height; MT_NO_MEMORY. As mt_count_crossings. */
mt_status mt_list_crossings(const mt_rings *rings, mt_arena *arena, mt_point **places, int *count);

/* Takes what a union costs off the steps that the arena has left, if it is bounded. MT_TOO_LARGE where these do not do, MT_NO_MEMORY. */
mt_status mt_pay_for_union(const mt_rings *rings, mt_arena *arena);
