/* What an axis and the places on it are called. The registered axes have the names that applications look for (OpenType
 * spec, "Registered design-variation axis tags"); any other goes by its tag or, for a few well-known ones, a word. */
#pragma once

#include <stdbool.h>

#include "base/memory.h"
#include "sfnt/axis_data.h"

/* Whether the axis may be one: a registered tag or one of capitals and digits that starts with a capital; numbers that the
 * registry lets it have and that 16.16 holds; a length over 0. */
bool mt_axis_is_valid(const mt_axis *axis);

/* Fills in the name and the named places of the data, whose axis is set: of a weight the hundreds, of a width the nine
 * classes, of any other the quarters, or the ends alone where it slants; and always the values of the `count` fonts. In
 * the arena. MT_NO_MEMORY. */
mt_status mt_axis_name_places(const double *values, int count, mt_arena *arena, mt_axis_data *data);

/* The name of a value, in the arena; NULL when memory ran out. */
const char *mt_axis_place_name(const mt_axis *axis, double value, mt_arena *arena);
