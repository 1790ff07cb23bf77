/* The canvas of an animation: one for all frames. */
#pragma once

#include "motion/stretch.h"

/* A picture's side, pixels. */
#define MT_CANVAS_MAX 8192
#define MT_MOTION_SIZE 256.0 /* pixels an em, where nothing else is asked for */

/* A box around drawings, grid units. */
typedef struct mt_bounds {
    double left, right, bottom, top;
} mt_bounds;

/* The box of nothing, which takes in whatever comes. */
mt_bounds mt_bounds_of_nothing(void);
void mt_bounds_take_in(mt_bounds *bounds, const mt_drawing *drawing);

/* What is asked of the canvas. */
typedef struct mt_page_request {
    double size;       /* pixels an em; 0: MT_MOTION_SIZE, or what fits the canvas */
    int width, height; /* of the canvas, pixels; 0: as large as the drawing needs */
} mt_page_request;

/* From places on the grid to the page: x_page = (x - left) · scale, y_page = (top - y) · scale. */
typedef struct mt_page {
    int width, height; /* pixels */
    double left, top;  /* grid units */
    double scale;      /* pixels a grid unit */
} mt_page;

/* A canvas around the box, with a margin and even sides, or of the size asked for with the box in its middle. MT_TOO_LARGE for a side
 * over MT_CANVAS_MAX, MT_BAD_PARAMETER for a size that is none. */
mt_status mt_page_lay(const mt_page_request *request, mt_bounds bounds, mt_page *page);
