/* Colours: sRGB, mixed channel by channel as SVG and CSS do. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

typedef struct mt_colour {
    uint8_t red, green, blue;
} mt_colour;

/* #rgb, #rrggbb, or a name (W3C, "CSS Color Module Level 4", 6.1), in either case; false for anything else. */
bool mt_colour_read(const char *text, mt_colour *colour);
/* #rrggbb */
void mt_colour_write(mt_colour colour, char text[8]);
/* At t from a to b; outside of 0 … 1 it is that of the nearer end. */
mt_colour mt_colour_mix(mt_colour a, mt_colour b, double t);
