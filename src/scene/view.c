#include "scene/view.h"

#include <math.h>

#include "arithmetic/angles.h"

mt_eye mt_eye_at(double turn, double tilt) {
    double radian = M_PI / 180, s = mt_sin(turn * radian), c = mt_cos(turn * radian),
           rise = mt_sin(tilt * radian), run = mt_cos(tilt * radian);
    return (mt_eye){
        .right = {c, 0, -s}, .up = {-s * rise, run, -c * rise}, .towards = {s * run, rise, c * run}};
}

static double dot(mt_vector3 a, mt_vector3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

mt_vector3 mt_eye_sees(const mt_eye *eye, mt_vector3 place) {
    return (mt_vector3){dot(eye->right, place), dot(eye->up, place), dot(eye->towards, place)};
}

mt_seen_box mt_eye_box(const mt_eye *eye, const mt_mesh *mesh) {
    mt_seen_box box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (int i = 0; i < mesh->n_points; i++) {
        mt_vector3 p = mt_eye_sees(eye, mesh->points[i]);
        box.low = (mt_vector3){fmin(box.low.x, p.x), fmin(box.low.y, p.y), fmin(box.low.z, p.z)};
        box.high = (mt_vector3){fmax(box.high.x, p.x), fmax(box.high.y, p.y), fmax(box.high.z, p.z)};
    }
    return box;
}
