#include "solid_options.h"

#include "messages.h"
#include "numbers.h"

#include <math.h>
#include <string.h>

#include "arithmetic/angles.h"

/* From the left and a little above. */
#define TURN (-30)
#define TILT 25

cli_solid solid_defaults(void) {
    return (cli_solid){.turn = TURN, .tilt = TILT};
}

static bool read_depth(const char *command, const char *argument, cli_solid *solid) {
    bool good = number_read(argument, &solid->depth) && solid->depth >= MT_SOLID_DEPTH_MIN &&
                solid->depth <= MT_SOLID_DEPTH_MAX;
    if (!good)
        misuse(command, "--depth %s: a number from %g to %g is wanted", argument, MT_SOLID_DEPTH_MIN,
               MT_SOLID_DEPTH_MAX);
    return good;
}

static bool read_axis(const char *command, const char *argument, cli_solid *solid) {
    static const char names[] = "xyz";
    double axis[3] = {0};
    const char *named = argument[0] && !argument[1] ? strchr(names, argument[0]) : NULL;
    bool good = named || numbers_read(argument, axis, 3) == 3;
    if (named) axis[named - names] = 1;
    double length = mt_hypot(mt_hypot(axis[0], axis[1]), axis[2]);
    if (!good || length == 0 || !isfinite(length)) {
        misuse(command, "--about %s: x, y, z or a direction X,Y,Z is wanted", argument);
        return false;
    }
    solid->axis = (mt_vector3){axis[0], axis[1], axis[2]};
    return true;
}

static bool read_view(const char *command, const char *argument, cli_solid *solid) {
    double angles[2];
    bool good = numbers_read(argument, angles, 2) == 2 && fabs(angles[0]) <= 360 && fabs(angles[1]) <= 90;
    if (!good) {
        misuse(command, "--view %s: TURN,TILT is wanted, degrees up to 360 and up to 90", argument);
        return false;
    }
    solid->turn = angles[0];
    solid->tilt = angles[1];
    return true;
}

bool solid_read(const char *command, char letter, const char *argument, cli_solid *solid) {
    if (letter == 'i') return read_depth(command, argument, solid);
    return letter == 'u' ? read_axis(command, argument, solid) : read_view(command, argument, solid);
}
