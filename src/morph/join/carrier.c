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

static mt_vector place_on(const mt_contour *contour, int i, double t) {
    const mt_segment *s = &contour->segments[i];
    mt_point from = start_of(contour, i);
    mt_point middle = s->degree == 2 ? s->control[0] : from;
    double a = s->degree == 2 ? (1 - t) * (1 - t) : 1 - t, b = s->degree == 2 ? 2 * t * (1 - t) : 0,
           c = s->degree == 2 ? t * t : t;
    return (mt_vector){a * from.x + b * middle.x + c * s->end.x, a * from.y + b * middle.y + c * s->end.y};
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
            mt_vector here = place_on(own, i, (k + 0.5) / steps),
                      there = place_on(other, i, (k + 0.5) / steps);
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
