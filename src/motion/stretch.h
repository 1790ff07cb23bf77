/* What moves between two key frames: contours of every pair of parts, each point on straight lines. */
#pragma once

#include "geometry/union.h"
#include "morph/model/morph.h"
#include "motion/part_pairs.h"

/* Contours, with the place of their origin: grid units from the middle of the line. */
typedef struct mt_placed {
    mt_outline outline;
    mt_vector place;
    bool apart; /* filled by itself, by the rule; otherwise with all others that are not, nonzero */
    mt_rule rule;
} mt_placed;

typedef struct mt_drawing {
    int count;
    mt_placed *list;
} mt_drawing;

/* A part on its way. */
typedef struct mt_moving_part {
    mt_variable_outline contours;
    mt_morph turning; /* the boxes and the angle of formula (5) alone */
    mt_vector a, b;   /* where its origin is at both ends */
    mt_status
        failed; /* other than MT_OK: why A's part shrinks and B's grows, and no contour becomes another */
} mt_moving_part;

typedef struct mt_stretch {
    const mt_figure *a, *b;
    mt_part_pairs pairs;
    mt_moving_part *parts; /* one for each pair */
    int steps;             /* straight steps of equal length in T with which every point keeps to its path */
} mt_stretch;

/* Moves one pair of parts. What lives on is in `kept`. MT_NO_MEMORY. */
mt_status mt_moving_part_make(const mt_figure_part *a, const mt_figure_part *b, const mt_hints *hints,
                              const mt_params *params, mt_arena *scratch, mt_arena *kept,
                              mt_moving_part *part);

/* How many straight steps all parts need. */
int mt_stretch_steps(const mt_stretch *stretch);

/* The contours at T, as many with segments of the same degrees everywhere; T may overshoot 0 … 1 a little. The ink is their nonzero
 * union. In the arena. MT_NO_MEMORY. */
mt_status mt_stretch_at(const mt_stretch *stretch, double t, mt_arena *arena, mt_drawing *drawing);

/* A key frame as its source draws it, cubic curves too. MT_NO_MEMORY. */
mt_status mt_figure_drawing(const mt_figure *figure, mt_arena *arena, mt_drawing *drawing);
