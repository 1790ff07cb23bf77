/* Formula (5), the other way. */
#include "picture/turn.h"

#include <math.h>

#include "arithmetic/angles.h"

mt_turn mt_turn_back(const mt_glyph_pair *pair) {
    static const double radians = 3.14159265358979323846 / 180;
    double q = pair->morph.degrees * radians;
    mt_box box = mt_shape_box(&pair->b);
    return (mt_turn){.cosine = mt_cos(q),
                     .sine = mt_sin(q),
                     .x = ((double)box.min.x + box.max.x) / 2,
                     .y = ((double)box.min.y + box.max.y) / 2};
}

void mt_turn_point(const mt_turn *turn, double *x, double *y) {
    double dx = *x - turn->x, dy = *y - turn->y;
    *x = turn->x + turn->cosine * dx - turn->sine * dy;
    *y = turn->y + turn->sine * dx + turn->cosine * dy;
}
