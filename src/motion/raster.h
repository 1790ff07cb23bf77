/* Frames in pixels. A frame is how much of each pixel is ink; its colours are two, and mixed by the formats. */
#pragma once

#include "motion/motion.h"

typedef struct mt_drawn_frame {
    int width, height;
    uint8_t *coverage; /* width × height, row by row from the top: 0 none of the pixel … 255 all of it */
    mt_colour ink;
    bool has_background;
    mt_colour background;
    int number, length; /* it is shown from this frame on, for so many frames */
} mt_drawn_frame;

/* Takes a frame, which lasts as long as the call. A status other than MT_OK ends the play. */
typedef mt_status (*mt_take_frame)(const mt_drawn_frame *frame, void *user);

/* Draws one moment. `coverage` is in the arena. MT_NO_MEMORY. */
mt_status mt_raster_draw(const mt_motion *motion, mt_moment moment, mt_arena *arena, mt_drawn_frame *frame);

/* Pixels that all frames of all plays in a file have together: a minute of 4K at 60 frames a second. */
#define MT_PIXELS_MAX 34359738368.0
/* MT_TOO_LARGE where so many plays have more. */
mt_status mt_raster_check(const mt_motion *motion, int plays);

/* Draws the frames of a play, one after another. MT_NO_MEMORY, MT_TOO_LARGE for more than MT_FRAMES_MAX or MT_PIXELS_MAX, what `take`
 * gives. */
mt_status mt_raster_play(const mt_motion *motion, mt_take_frame take, void *user);

/* The pixels of a frame: red, green and blue, or these and alpha where it has no background; in the arena. NULL without memory. */
uint8_t *mt_raster_pixels(const mt_drawn_frame *frame, mt_arena *arena);
static inline int mt_raster_channels(const mt_drawn_frame *frame) {
    return frame->has_background ? 3 : 4;
}
