/* Pictures in memory: a Cairo surface whose PNG, SVG or PDF ends in a buffer, so that a file appears whole or
 * not at all.
 *
 * A picture's unit is a pixel in PNG and a point in SVG and PDF; y runs downwards. The same drawing gives the
 * same bytes: a PDF's creation date is SOURCE_DATE_EPOCH when that is set, otherwise a fixed day. */
#pragma once

#include "base/buffer.h"

#include <cairo.h>

/* The longest side of a picture, units, and the most pixels of an image: what Cairo's images hold, and one
 * gigabyte. */
#define MT_PICTURE_SIDE_MAX 32767
#define MT_PICTURE_PIXELS_MAX (1 << 28)

typedef enum mt_format { MT_FORMAT_PNG, MT_FORMAT_SVG, MT_FORMAT_PDF } mt_format;

/* The format that a file name's extension asks for, in either case. MT_UNKNOWN_FORMAT. */
mt_status mt_format_of(const char *path, mt_format *format);

typedef struct mt_canvas {
    mt_format format;
    cairo_surface_t *surface;
    cairo_t *cairo;
    mt_buffer bytes;
} mt_canvas; /* must not move while it is open: its surface points at it */

/* A white page, with black chosen. MT_TOO_LARGE before anything is drawn, MT_NO_MEMORY. */
mt_status mt_canvas_open(mt_format format, double width, double height, mt_canvas *canvas);
/* Ends a page and starts the next one; PDF only. */
void mt_canvas_next_page(mt_canvas *canvas);
/* The finished file; the buffer is the caller's. MT_NO_MEMORY, MT_TOO_LARGE, MT_CANNOT_WRITE. */
mt_status mt_canvas_finish(mt_canvas *canvas, mt_buffer *file);
/* Finishes, and writes the file to `path`. */
mt_status mt_canvas_save(mt_canvas *canvas, const char *path);
void mt_canvas_close(mt_canvas *canvas); /* one that never opened is fine when it is all zero */
