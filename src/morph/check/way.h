/* Points that move on straight ways, and exactly when one of them is on the segment between two others. */
#pragma once

#include "geometry/point.h"

/* A point that moves evenly from at[0] to at[1]. Places are within MT_WAY_MOST on each axis. */
typedef struct mt_way {
    mt_point at[2];
} mt_way;

/* Differences of places then fit 28 bits, their vectors at a step 48 bits, and what is decided by 98 bits (mt_wide). */
#define MT_WAY_MOST (1 << 26)

/* Ways are looked at between steps: 0 is the start, MT_WAY_STEPS the end. */
enum { MT_WAY_STEPS = 1 << 20 };

/* From one step to a later one. What is at a step itself counts as within unless that end is open. */
typedef struct mt_steps {
    int from, to;
    bool open_from, open_to;
} mt_steps;

/* The side of the line from a to b on which c is at every place of these steps: 1 left, -1 right; 0 where it may be on the line, or
 * on both sides. Exact: never 1 or -1 unless it is so. */
int mt_steady_side(const mt_way *a, const mt_way *b, const mt_way *c, mt_steps steps);

/* The most stretches of steps in which a point can be on a segment. */
enum { MT_PASSES_MOST = 8 };

/* The single steps, in order, between which c may be on the segment from a to b; at no other place within `steps` it is. Neighbouring
 * steps are one stretch. Returns their count, or -1 where c stays on the line. A quadratic has two roots, so that there are few. */
int mt_passes(const mt_way *a, const mt_way *b, const mt_way *c, mt_steps steps,
              mt_steps found[MT_PASSES_MOST]);

/* The same for the segments from v to a and from v to b: when one may lie along the other. */
int mt_folds(const mt_way *v, const mt_way *a, const mt_way *b, mt_steps steps,
             mt_steps found[MT_PASSES_MOST]);

/* Whether c is strictly between a and b, seen along their line, at every place of these steps. */
bool mt_stays_between(const mt_way *a, const mt_way *b, const mt_way *c, mt_steps steps);
