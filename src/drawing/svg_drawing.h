/* A drawing as it is read from SVG: paths and basic shapes with solid fills, in groups with transforms.
 *
 * The view box, or what width and height say, or else the box around the drawing, is put into a square whose side is an em. The square
 * stands an eighth of an em below the baseline, as in icon fonts, with its middle above the origin. What is outside of the view is kept. */
#pragma once

#include "drawing/style.h"
#include "geometry/layers.h"

/* The largest file that is read, bytes. */
#define MT_SVG_MAX (1 << 24)

typedef struct mt_svg_drawing {
    mt_layers layers; /* of each element that draws something, in their order; grid units, y upwards */
    bool one_colour;  /* all of them have this one */
    mt_colour colour;
    unsigned left_out; /* bits of mt_left_out */
} mt_svg_drawing;

/* Whether a file that begins with these bytes is XML by its looks: a <, after blanks and a byte order mark. */
bool mt_svg_looks_so(const uint8_t *bytes, size_t length);

/* Reads a drawing, in the arena. MT_BAD_DRAWING, *problem is then a line of English; MT_BLANK where nothing is filled, with
 * `drawing->left_out` set; MT_TOO_LARGE for more elements, segments or ems than the limits, MT_NO_MEMORY. */
mt_status mt_svg_read(const uint8_t *bytes, size_t length, mt_arena *arena, mt_svg_drawing *drawing,
                      const char **problem);
