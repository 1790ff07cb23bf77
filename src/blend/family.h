/* A family of fonts as one that varies: each font at a value of its own, named as it is. */
#pragma once

#include "blend/row.h"
#include "sfnt/axis_data.h"
#include "sfnt/stops.h"

/* Where each font of the row stands: at its own value or, without values, evenly. */
mt_stops mt_variable_stops(const mt_variable *variable);

/* What users set for a font of the row, where nothing is mapped. */
double mt_variable_value(const mt_variable *variable, int font);

/* Fills in the name and the named places of the data, whose axis is set: those of the family, as its fonts are named; or, without
 * values, as mt_axis_name_places. In the arena. MT_NO_MEMORY. */
mt_status mt_variable_name_places(const mt_variable *variable, const double *values, int count,
                                  mt_arena *arena, mt_axis_data *data);

/* Whether the fonts are upright with italics beside them, or italic themselves. */
mt_slope mt_variable_slope(const mt_variable *variable);
