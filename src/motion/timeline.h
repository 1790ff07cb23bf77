/* When a chain of key frames is where.
 *
 * Places on the chain count through: 0 is the first key frame, 1 the second, and 1.25 is a quarter of the way from the second to the
 * third. A stretch is what lies between two neighbours. One play of the chain is a list of legs, on each of which the place goes from
 * one to another with one easing, or stays.
 *
 *     --hold, each stretch eased:   stay at 0 · 0 → 1 · stay at 1 · 1 → 2 · stay at 2
 *     eased as a whole:             stay at 0 · 0 → 2 · stay at 2
 *     --yoyo:                       the same, and back the way it came */
#pragma once

#include "base/memory.h"
#include "morphotype.h"
#include "motion/easing.h"

#define MT_DURATION_MIN 0.01 /* seconds of a play's motion */
#define MT_DURATION_MAX 600.0
#define MT_HOLD_MAX 60.0 /* seconds */
#define MT_FPS_MAX 240
#define MT_FRAMES_MAX 20000 /* of a play */

typedef struct mt_timing {
    double duration; /* seconds from the first key frame to the last, without the holds */
    double hold;     /* seconds that each key frame stays */
    mt_easing easing;
    bool
        whole; /* the easing is over all of the chain, not over each stretch; key frames in the middle do not stay */
    bool yoyo; /* and back again */
    int plays; /* 0: without an end */
    int fps;   /* frames a second, for formats that have frames */
} mt_timing;

bool mt_timing_is_valid(const mt_timing *timing);

typedef struct mt_leg {
    double start, end; /* seconds from the start of the play */
    double from, to;   /* places; equal while it stays */
    mt_easing easing;
} mt_leg;

typedef struct mt_timeline {
    int stretch_count;
    int count;
    mt_leg *legs;
    double length; /* of a play, seconds */
} mt_timeline;

/* Of a chain with so many stretches, in the arena. MT_NO_MEMORY. */
mt_status mt_timeline_make(const mt_timing *timing, int stretch_count, mt_arena *arena,
                           mt_timeline *timeline);

/* A place, as the stretch that it is on and T there. T leaves 0 … 1 where an easing overshoots the ends of the chain. */
typedef struct mt_moment {
    int stretch;
    double t;
} mt_moment;

mt_moment mt_timeline_at(const mt_timeline *timeline, double time);
/* The same of a place on a chain of so many stretches. */
mt_moment mt_moment_of(double place, int stretch_count);

/* A frame, shown from its number on for so many frames. */
typedef struct mt_timed_frame {
    mt_moment moment;
    int number, length;
} mt_timed_frame;

typedef struct mt_timed_frames {
    int count;
    mt_timed_frame *list;
    int all; /* the sum of all lengths */
} mt_timed_frames;

/* The frames of one play: from the first key frame to the end of the play, which is left out where the next play begins with the same
 * picture. Neighbours that show the same are one. In the arena. MT_NO_MEMORY, MT_TOO_LARGE for more than MT_FRAMES_MAX. */
mt_status mt_timeline_frames(const mt_timeline *timeline, const mt_timing *timing, mt_arena *arena,
                             mt_timed_frames *frames);

/* A part of the play on which contours move on straight lines, for formats that know key times. */
typedef struct mt_span {
    double start, end;
    int stretch;
    double from, to;  /* T; equal while it stays */
    mt_easing easing; /* control points from 0 to 1 */
} mt_span;

typedef struct mt_spans {
    int count;
    mt_span *list;
} mt_spans;

/* The play in spans, which end where contours bend: steps[i] is the number of straight steps of stretch i. An easing that cannot be cut
 * there, or that overshoots, becomes linear spans of a sixtieth of a second. In the arena. MT_NO_MEMORY. */
mt_status mt_timeline_spans(const mt_timeline *timeline, const int *steps, mt_arena *arena, mt_spans *spans);
