/* Labels: T values, code points, page numbers and font names, in a small plotter alphabet of their own, so
 * that a picture has them on a machine without any installed font, and is the same on every machine. */
#pragma once

#include "geometry/point.h"

#include <cairo.h>
#include <stddef.h>

/* Draws from (x, y), the left end of the baseline, in the current colour; `height` is that of a capital. The
 * alphabet is printable ASCII; any other character of the UTF-8 text is an empty box. */
void mt_label_draw(cairo_t *cairo, const char *text, double x, double y, double height);
void mt_label_draw_centred(cairo_t *cairo, const char *text, double x, double y, double height);
double mt_label_width(const char *text, double height);
/* The height, at most `height`, at which a label is no wider than `room`. */
double mt_label_fitting(const char *text, double height, double room);

/* "T = 0.25": at most four decimals, without the zeros at the end. "T = 0.25,y=0.5" where T is another one upwards. */
void mt_label_t(double t, char *text, size_t room);
void mt_label_at(mt_at at, char *text, size_t room);

/* How high labels are beside text of `size` units an em. */
double mt_label_height(double size);
