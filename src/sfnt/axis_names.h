/* What an axis and the places on it are called. The registered axes have the names that applications look for (OpenType
 * spec, "Registered design-variation axis tags"); any other goes by its tag or, for a few well-known ones, a word. */
#pragma once

#include <stdbool.h>

#include "base/memory.h"
#include "sfnt/axis_data.h"

/* Whether the axis may be one: a registered tag or one of capitals and digits that starts with a capital; numbers that the
 * registry lets it have and that 16.16 holds; a length over 0. */
bool mt_axis_is_valid(const mt_axis *axis);

/* Four letters as a tag; false for any other text. */
bool mt_axis_tag_read(const char *text, uint32_t *tag);

/* Fills in the name and the named places of the data, whose axis is set: of a weight the hundreds, of a width the nine
 * classes, of any other the quarters, or the ends alone where it slants; and always the values of the `count` fonts. In
 * the arena. MT_NO_MEMORY. */
mt_status mt_axis_name_places(const double *values, int count, mt_arena *arena, mt_axis_data *data);

/* What a font at a stop of its own is called: by the whole name, and by the part of it that is of the axis. */
typedef struct mt_stop_name {
    const char *whole, *part;
} mt_stop_name;

/* The same with the values of the `count` fonts alone, which ascend, by these names, which are kept. */
mt_status mt_axis_name_stops(const double *values, const mt_stop_name *names, int count, mt_arena *arena,
                             mt_axis_data *data);

/* The value that is not told in a style's name, such as a weight of 400; NAN where there is none. */
double mt_axis_plain(uint32_t tag);

/* The name of a value, in the arena; NULL when memory ran out. */
const char *mt_axis_place_name(const mt_axis *axis, double value, mt_arena *arena);
