/* The proof of a morph's topology: lulls, during which nothing between its contours changes. */
#pragma once

#include "morph/check/moving_edges.h"

/* Places between which no two edges meet, part or fold: a lull. */
typedef struct mt_lull {
    double from, to; /* T */
} mt_lull;

/* What is proved, exactly, of the edges of mt_moving_edges_of at every T between the ends: contours as chords, with points that are not
 * rounded on the way. During a lull the same edges cross, in the same order along each, so that the ink of any rule has the same
 * components and holes at each of its places, however small these are. Between two lulls is a moment, in which edges meet. Lulls so short
 * that no point gets far meanwhile belong to it, unless several in a row are longer. A curve is within the edges' tolerance of
 * its chords: what touches by less is not told from what is apart by less. */
typedef struct mt_lulls {
    bool
        known; /* false: nothing is proved; edges stay on one another, three cross at once, or there is too much to look at */
    bool plain; /* one lull all along, no two edges touch or cross in it, and no two contours share points */
    int count;
    mt_lull *lulls; /* in order */
} mt_lulls;

/* `far`, grid units: in a moment no point gets farther. MT_NO_MEMORY. */
mt_status mt_find_lulls(const mt_moving_edges *edges, double far, mt_arena *arena, mt_lulls *lulls);
