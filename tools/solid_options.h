/* The options of solid. */
#pragma once

#include "morphotype.h"

typedef struct cli_solid {
    double depth;      /* 0: not given */
    mt_vector3 axis;   /* all 0: not given */
    double turn, tilt; /* of the view, degrees */
} cli_solid;

/* What holds where nothing is asked. */
cli_solid solid_defaults(void);

/* Reads the argument of the option with this letter (options.c). False, said, for wrong usage of `command`. */
bool solid_read(const char *command, char letter, const char *argument, cli_solid *solid);
