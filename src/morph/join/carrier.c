/* A place is moved by the mean of what the contours around it are moved by, each sample with its length over the fourth power of
 * its distance (D. Shepard, "A two-dimensional interpolation function for irregularly-spaced data", 1968): beside a contour
 * a place goes with it, and between two it goes between. O(samples). */
#include "morph/join/carrier.h"

#include <math.h>

#include "geometry/limits.h"

#define SAMPLES_APART 20.0 /* along a contour, 1/1000 em */
#define NEAREST 4.0        /* 1/1000 em: no distance counts as less */

typedef struct mt_carried_sample {
    mt_vector at, by;
    double length;
} mt_carried_sample;

static mt_point start_of(const mt_contour *contour, int i) {
    return contour->segments[i ? i - 1 : contour->count - 1].end;
}

static double chord(const mt_contour *contour, int i) {
    return sqrt((double)mt_distance2(start_of(contour, i), contour->segments[i].end));
}

static int steps_along(const mt_contour *contour, int i) {
    return (int)(chord(contour, i) / mt_grid_units(SAMPLES_APART)) + 1;
}

static void sample_contour(const mt_contour *own, const mt_contour *other, mt_carrier *carrier) {
    for (int i = 0; i < own->count; i++) {
        int steps = steps_along(own, i);
        for (int k = 0; k < steps; k++) {
            double t = (k + 0.5) / steps;
            mt_vector here = mt_segment_at(start_of(own, i), &own->segments[i], t),
                      there = mt_segment_at(start_of(other, i), &other->segments[i], t);
            carrier->samples[carrier->count++] =
                (mt_carried_sample){here, {there.x - here.x, there.y - here.y}, chord(own, i) / steps};
        }
    }
}

mt_status mt_carrier_of(const mt_contour_pair *contours, int count, bool in_a, mt_box box, mt_box other_box,
                        mt_arena *arena, mt_carrier *carrier) {
    size_t room = 0;
    for (int i = 0; i < count; i++) {
        const mt_contour *own = in_a ? &contours[i].a : &contours[i].b;
        for (int k = 0; k < own->count; k++) room += (size_t)steps_along(own, k);
    }
    *carrier = (mt_carrier){0, mt_arena_new(arena, room, sizeof(mt_carried_sample)), box, other_box};
    if (!carrier->samples) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++)
        sample_contour(in_a ? &contours[i].a : &contours[i].b, in_a ? &contours[i].b : &contours[i].a,
                       carrier);
    return MT_OK;
}

static mt_vector carry_by_box(const mt_carrier *c, mt_vector p) {
    return (mt_vector){
        c->other_box.min.x + (p.x - c->box.min.x) / mt_box_width(c->box) * mt_box_width(c->other_box),
        c->other_box.min.y + (p.y - c->box.min.y) / mt_box_height(c->box) * mt_box_height(c->other_box)};
}

mt_vector mt_carry(const mt_carrier *c, mt_vector p) {
    double sum = 0, x = 0, y = 0, nearest = mt_grid_units(NEAREST);
    for (int i = 0; i < c->count; i++) {
        const mt_carried_sample *s = &c->samples[i];
        double u = s->at.x - p.x, v = s->at.y - p.y, far2 = fmax(u * u + v * v, nearest * nearest);
        double weight = s->length / (far2 * far2);
        sum += weight;
        x += weight * s->by.x;
        y += weight * s->by.y;
    }
    return sum > 0 ? (mt_vector){p.x + x / sum, p.y + y / sum} : carry_by_box(c, p);
}
