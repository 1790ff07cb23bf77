/* The frame of a box, and what every frame keeps. O(1). */
#include "morph/model/frame.h"

#include <math.h>

#define THIN 0.35 /* of the other side: what a side of a box counts as, at least */

mt_frame mt_frame_of_box(mt_box box) {
    return (mt_frame){.box = box, .x = {0, 1, 0, 0}, .y = {0, 0, 1, 0}, .heading = {1, 0, 0, 1}};
}

double mt_frame_side(double side, double across) {
    return fmax(side, THIN * across);
}

bool mt_frame_is_valid(const mt_frame *frame) {
    if (frame->box.min.x > frame->box.max.x || frame->box.min.y > frame->box.max.y) return false;
    for (int i = 0; i < 4; i++)
        if (!isfinite(frame->x[i]) || !isfinite(frame->y[i]) || !isfinite(frame->heading[i])) return false;
    return frame->heading[0] * frame->heading[3] > frame->heading[1] * frame->heading[2];
}
