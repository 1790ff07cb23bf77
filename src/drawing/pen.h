/* What the elements of a drawing draw: contours on the page of the drawing, y downwards, in layers. */
#pragma once

#include "base/memory.h"
#include "drawing/transform.h"
#include "geometry/union.h"

/* Segments of one drawing: far more than a logo or an icon has. */
#define MT_DRAWING_SEGMENTS_MAX 8192

typedef struct mt_pen_segment {
    int degree;           /* 1 or 3 */
    mt_vector control[2]; /* of degree 3 */
    mt_vector end;
} mt_pen_segment;

typedef struct mt_pen_contour {
    mt_vector start;
    int first, count; /* segments */
} mt_pen_contour;

typedef struct mt_pen_layer {
    int first, count; /* contours */
    mt_rule rule;
} mt_pen_layer;

typedef struct mt_pen {
    mt_arena *arena;
    mt_affine map; /* from the element at hand to the page */
    mt_vector at;  /* of the element */
    mt_vector start;
    bool open; /* a contour has begun */
    int layer_count, contour_count, segment_count;
    int layer_room, contour_room, segment_room;
    mt_pen_layer *layers;
    mt_pen_contour *contours;
    mt_pen_segment *segments;
    mt_status
        status; /* MT_NO_MEMORY, MT_TOO_LARGE for more than MT_DRAWING_SEGMENTS_MAX, or places that are not finite */
} mt_pen;

/* A pen that has failed draws nothing more. A layer is what one element draws. */
void mt_pen_layer_begin(mt_pen *pen, mt_rule rule);
void mt_pen_move(mt_pen *pen, double x, double y);
void mt_pen_line(mt_pen *pen, double x, double y);
void mt_pen_quadratic(mt_pen *pen, double cx, double cy, double x, double y);
void mt_pen_cubic(mt_pen *pen, double c1x, double c1y, double c2x, double c2y, double x, double y);
/* An arc of an ellipse as path data have it ("SVG 2", 9.5.1 and B.2), in cubic curves of an eighth of a turn at the most, which are
 * within 1/200 000 of its radius. */
void mt_pen_arc(mt_pen *pen, double rx, double ry, double degrees, bool large, bool sweep, double x,
                double y);
/* The pen goes back to where the contour began; what is drawn next begins there. */
void mt_pen_close(mt_pen *pen);
