/* The holes of two parts that are joined: paired, or slit open. */
#pragma once

#include "morph/join/joining.h"

/* The counterpart of each hole, by its index among the other part's rings; 0: none. */
typedef struct mt_hole_pairs {
    int *in_b; /* of each ring of A */
    int *in_a; /* of each ring of B */
} mt_hole_pairs;

/* Pairs holes, and slits those open that have no counterpart and are open on the other side: the parts' components may have
 * fewer rings afterwards. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_pair_holes(mt_joining *j, mt_hole_pairs *pairs);
