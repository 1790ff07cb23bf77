#include "motion_options.h"

#include "messages.h"
#include "motion/motion.h"
#include "numbers.h"

#include <stdio.h>
#include <string.h>

#define FPS 30

/* Numbers of CSS are short; what is longer is none. */
#define ARGUMENT_ROOM 128

cli_motion motion_defaults(void) {
    return (cli_motion){.timing = {.easing = {0.42, 0, 0.58, 1}, .fps = FPS},
                        .has_background = true,
                        .background = {255, 255, 255}};
}

static bool refuse(const char *command, const char *name, const char *argument, const char *wanted) {
    misuse(command, "--%s %s: %s", name, argument, wanted);
    return false;
}

static bool read_seconds(const char *command, const char *name, const char *argument, double min, double max,
                         double *seconds) {
    if (number_read(argument, seconds) && *seconds >= min && *seconds <= max) return true;
    misuse(command, "--%s %s: seconds from %g to %g are wanted", name, argument, min, max);
    return false;
}

static bool read_count(const char *command, const char *name, const char *argument, int min, int max,
                       int *count) {
    double number;
    bool good = number_read(argument, &number) && number >= min && number <= max && number == (int)number;
    if (good)
        *count = (int)number;
    else
        misuse(command, "--%s %s: a whole number from %d to %d is wanted", name, argument, min, max);
    return good;
}

/* cubic-bezier(X1,Y1,X2,Y2); blanks may follow a comma. */
static bool read_bezier(const char *argument, mt_easing *easing) {
    static const char head[] = "cubic-bezier(";
    char inner[ARGUMENT_ROOM], *to = inner;
    double values[4];
    size_t length = strlen(argument);
    bool framed = strncmp(argument, head, sizeof head - 1) == 0 && argument[length - 1] == ')';
    if (!framed || length >= sizeof inner) return false;
    for (const char *p = argument + sizeof head - 1; p[1]; p++)
        if (*p != ' ') *to++ = *p;
    *to = '\0';
    if (numbers_read(inner, values, 4) != 4) return false;
    *easing = (mt_easing){values[0], values[1], values[2], values[3]};
    return mt_easing_is_valid(easing);
}

static bool read_ease(const char *command, const char *argument, mt_easing *easing) {
    if (mt_easing_named(argument, easing) || read_bezier(argument, easing)) return true;
    return refuse(
        command, "ease", argument,
        "linear, ease, ease-in, ease-out, ease-in-out or cubic-bezier(X1,Y1,X2,Y2) is wanted, X from "
        "0 to 1 and Y from -2 to 3");
}

static bool read_ease_over(const char *command, const char *argument, mt_timing *timing) {
    timing->whole = strcmp(argument, "whole") == 0;
    return timing->whole || strcmp(argument, "each") == 0 ||
           refuse(command, "ease-over", argument, "each or whole is wanted");
}

static bool read_loop(const char *command, const char *argument, mt_timing *timing) {
    timing->plays = 0;
    return strcmp(argument, "forever") == 0 || read_count(command, "loop", argument, 1, 1000, &timing->plays);
}

/* WIDTHxHEIGHT */
static bool read_canvas(const char *command, const char *argument, cli_motion *motion) {
    char width[ARGUMENT_ROOM] = "";
    const char *x = strchr(argument, 'x');
    double sides[2];
    bool whole = x && (size_t)(x - argument) < sizeof width;
    if (whole) strncat(width, argument, (size_t)(x - argument));
    whole = whole && number_read(width, &sides[0]) && number_read(x + 1, &sides[1]);
    for (int i = 0; whole && i < 2; i++)
        whole = sides[i] >= 8 && sides[i] <= MT_CANVAS_MAX && sides[i] == (int)sides[i];
    if (!whole)
        return refuse(command, "canvas", argument, "WIDTHxHEIGHT is wanted, each from 8 to 8192 pixels");
    motion->width = (int)sides[0];
    motion->height = (int)sides[1];
    return true;
}

/* Colours with commas between them. */
static bool read_colours(const char *command, const char *argument, cli_motion *motion) {
    bool good = true;
    motion->colour_count = 0;
    for (const char *p = argument; good; p++) {
        char one[ARGUMENT_ROOM] = "";
        size_t length = strcspn(p, ",");
        good = length < sizeof one && motion->colour_count < MT_VARIABLE_FONTS_MAX;
        if (good) strncat(one, p, length);
        good = good && mt_colour_read(one, &motion->colours[motion->colour_count++]);
        p += length;
        if (!*p) break;
    }
    return good || refuse(command, "color", argument,
                          "#RRGGBB, #RGB or a name of CSS is wanted, or several with commas");
}

static bool read_background(const char *command, const char *argument, cli_motion *motion) {
    motion->has_background = strcmp(argument, "none") != 0;
    if (!motion->has_background || mt_colour_read(argument, &motion->background)) return true;
    return refuse(command, "background", argument, "none, #RRGGBB, #RGB or a name of CSS is wanted");
}

bool motion_read(const char *command, char letter, const char *argument, cli_motion *motion) {
    mt_timing *timing = &motion->timing;
    switch (letter) {
    case 'D':
        return read_seconds(command, "duration", argument, MT_DURATION_MIN, MT_DURATION_MAX,
                            &timing->duration);
    case 'd': return read_seconds(command, "hold", argument, 0, MT_HOLD_MAX, &timing->hold);
    case 'U': return read_count(command, "fps", argument, 1, MT_FPS_MAX, &timing->fps);
    case 'e': return read_ease(command, argument, &timing->easing);
    case 'O': return read_ease_over(command, argument, timing);
    case 'N': return read_loop(command, argument, timing);
    case 'y': return timing->yoyo = true;
    case 'C': return read_canvas(command, argument, motion);
    case 'k': return read_colours(command, argument, motion);
    case 'b': return read_background(command, argument, motion);
    default: return motion->css = true;
    }
}
