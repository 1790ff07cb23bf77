/* A sample of a boundary as the measure of boundaries sees it. */
#pragma once

#include "morph/align/samples.h"
#include "morph/model/frame.h"

/* A place in a frame, and headings as unit vectors. */
typedef struct mt_sample_view {
    double x, y;
    double in_x, in_y, out_x, out_y;
    double turn_x, turn_y; /* the direction out, relative to the direction in */
} mt_sample_view;

mt_sample_view mt_sample_view_of(const mt_ring_sample *sample, const mt_frame *frame);

/* A place in its glyph's box that is on no boundary: without headings. */
mt_sample_view mt_view_of_place(const mt_frame *frame, double x, double y);

/* Where the other glyph has what is seen so: the place in its frame that a view is of, up to its headings. */
mt_vector mt_place_of_view(const mt_frame *frame, const mt_sample_view *view);

/* The unit normal to the right of headings whose sum is (x, y); (0, 0) where they cancel each other. */
void mt_normal_of(double x, double y, double normal[2]);
