/* A play as formats with key times have it: one set of contours after another, each with the times at which it is where. */
#pragma once

#include "motion/motion.h"

typedef struct mt_key_time {
    double time; /* a share of the play, 0 … 1; ascending */
    mt_moment moment;
    mt_easing easing; /* from here to the next; of the last, none */
} mt_key_time;

/* Neighbouring spans on one stretch: the same contours move without a break. */
typedef struct mt_run {
    int count;          /* at least two */
    mt_key_time *times; /* the first and the last are where the run begins and ends */
} mt_run;

typedef struct mt_runs {
    int count;
    mt_run *list; /* one after another, from 0 to 1 */
} mt_runs;

/* Segments that all key times have together: what a file of them holds. */
#define MT_KEY_SEGMENTS_MAX (1 << 22)

/* In the arena. MT_TOO_LARGE for more than MT_KEY_SEGMENTS_MAX, MT_NO_MEMORY. */
mt_status mt_runs_make(const mt_motion *motion, mt_arena *arena, mt_runs *runs);
