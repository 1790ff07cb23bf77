/* The options of animate. */
#pragma once

#include "drawing/colour.h"
#include "motion/timeline.h"
#include "morphotype.h"

typedef struct cli_motion {
    mt_timing timing;  /* its duration is 0 where none is given */
    int width, height; /* of --canvas; 0: not given */
    int colour_count;  /* of --color; 0: not given */
    mt_colour colours[MT_VARIABLE_FONTS_MAX];
    bool has_background;
    mt_colour background;
    bool css;
} cli_motion;

/* What holds where nothing is asked. */
cli_motion motion_defaults(void);

/* Reads the argument of the option with this letter (options.c). False, said, for wrong usage of `command`. */
bool motion_read(const char *command, char letter, const char *argument, cli_motion *motion);
