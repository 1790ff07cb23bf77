/* PANOSE, a typeface described by ten digits (OpenType spec, "OS/2": panose). What a digit means depends on the first,
 * the family kind. In all families 0 is "any" and 1 "no fit". */
#pragma once

#include <stdint.h>

enum {
    MT_PANOSE_DIGITS = 10,
    MT_PANOSE_WEIGHT = 2, /* digits of the Latin text family */
    MT_PANOSE_PROPORTION = 3,
    MT_PANOSE_CONTRAST = 4,
    MT_PANOSE_LATIN_TEXT = 2, /* of the first digit */
    MT_PANOSE_MONOSPACED = 9, /* of the proportion */
};

/* The digits of the font at t. The ends have those of their font. In between, a family kind that both fonts have and the
 * digits that they have in common are kept, weight and contrast of a text face are mixed, since they are on a scale, and
 * every other digit is "any". */
void mt_panose_mix(const uint8_t *a, const uint8_t *b, double t, uint8_t *mix);
