#include "motion/colour.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static bool is_hexadecimal(const char *text) {
    for (; *text; text++)
        if (!isxdigit((unsigned char)*text)) return false;
    return true;
}

static mt_colour colour_of(unsigned long rgb) {
    return (mt_colour){(uint8_t)(rgb >> 16), (uint8_t)(rgb >> 8), (uint8_t)rgb};
}

static bool read_name(const char *text, mt_colour *colour) {
    static const struct {
        const char *name;
        unsigned long rgb;
    } names[] = {
        {"black", 0x000000},  {"silver", 0xc0c0c0}, {"gray", 0x808080},   {"white", 0xffffff},
        {"maroon", 0x800000}, {"red", 0xff0000},    {"purple", 0x800080}, {"fuchsia", 0xff00ff},
        {"green", 0x008000},  {"lime", 0x00ff00},   {"olive", 0x808000},  {"yellow", 0xffff00},
        {"navy", 0x000080},   {"blue", 0x0000ff},   {"teal", 0x008080},   {"aqua", 0x00ffff},
        {"orange", 0xffa500},
    };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        if (strcasecmp(text, names[i].name) != 0) continue;
        *colour = colour_of(names[i].rgb);
        return true;
    }
    return false;
}

bool mt_colour_read(const char *text, mt_colour *colour) {
    if (*text != '#') return read_name(text, colour);
    size_t digits = strlen(text + 1);
    if ((digits != 3 && digits != 6) || !is_hexadecimal(text + 1)) return false;
    unsigned long value = strtoul(text + 1, NULL, 16);
    if (digits == 3) value = ((value & 0xf00) << 8 | (value & 0xf0) << 4 | (value & 0xf)) * 0x11;
    *colour = colour_of(value);
    return true;
}

void mt_colour_write(mt_colour colour, char text[8]) {
    snprintf(text, 8, "#%02x%02x%02x", colour.red, colour.green, colour.blue);
}

static uint8_t mix(uint8_t a, uint8_t b, double t) {
    return (uint8_t)lround(a + (b - a) * fmin(fmax(t, 0), 1));
}

mt_colour mt_colour_mix(mt_colour a, mt_colour b, double t) {
    return (mt_colour){mix(a.red, b.red, t), mix(a.green, b.green, t), mix(a.blue, b.blue, t)};
}
