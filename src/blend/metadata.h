/* What a blended font says of itself: metrics, names and dates made from those of its two sources. */
#pragma once

#include "geometry/point.h"
#include "write/font_data.h"

/* The new font's units per em: the larger of the sources', doubled until it is at least 1000 or, where it is a power of two,
 * 2048. On a coarse grid rounding alone blunts the thin tips of a brushed Han face. */
int mt_metadata_units(const mt_font *a, const mt_font *b);

/* Fills the metrics, dates and embedding bits of `data` for the font at a place; its units must be set. Heights are upwards; weight, width,
 * slant and all that is no measure go by T across. */
void mt_metadata_fill(const mt_font *a, const mt_font *b, mt_at at, mt_font_data *data);

/* Gives a font another style than the one made of its T, and the weight and the width that it names. */
void mt_metadata_style(const char *name, mt_font_data *data);

/* Gives the metrics what an axis for weight, width or slant says where users set it to `value`. */
void mt_metadata_axis(const mt_axis *axis, double value, int units, mt_metrics *metrics);

/* metadata_names.c: the names of the font at a place. `family` replaces the family name made from the sources' when it is not
 * NULL. The strings belong to the arena, the fonts or the caller. MT_NO_MEMORY. */
mt_status mt_metadata_names(const mt_font *a, const mt_font *b, mt_at at, const char *family, mt_arena *arena,
                            mt_font_data *data);
/* The names of a font that varies along the axis of axis.h from the first of 2 … 64 fonts to the last; all but the style.
 * `values` are what users set for each, and the axis is that of data->variation. A source's notices get less room where there are many. */
mt_status mt_metadata_axis_names(mt_font *const *fonts, const double *values, int count, const char *family,
                                 mt_arena *arena, mt_font_data *data);
