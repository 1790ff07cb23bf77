/* Section 2.3, formula (5): the rotation q. B is turned by −q before it is compared, and a blend at weight r by (1 − r) q back.
 *
 *     A ▐   B  ╱     principal axes of matched components, of their second moments of area; q is the mean of the angles
 *       ▐     ╱      between them, as vectors at twice the angle, weighted by area and by how elongated both are
 *
 * The paper gives no way to find q; this is ours. Invariants: multiples of 90° are exact, other turns round to the grid. O(n) for n points. */
#include "morph/paper/rotation.h"

#include <math.h>

#include "arithmetic/angles.h"
#include "geometry/limits.h"

mt_point mt_box_middle(mt_box box) {
    return (mt_point){box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
}

/* Sine and cosine, exact at multiples of 90°. */
static void sine_cosine(double degrees, double *sine, double *cosine) {
    double turns = fmod(degrees, 360);
    if (turns < 0) turns += 360;
    int quarter = (int)(turns / 90);
    double rest = (turns - 90 * quarter) * (M_PI / 180);
    double s = mt_sin(rest), c = mt_cos(rest);
    double by_quarter[5] = {s, c, -s, -c, s};
    *sine = by_quarter[quarter % 4];
    *cosine = by_quarter[quarter % 4 + 1];
}

mt_point mt_turn(mt_point p, mt_point centre, double degrees) {
    double sine, cosine;
    sine_cosine(degrees, &sine, &cosine);
    double x = (double)p.x - centre.x, y = (double)p.y - centre.y;
    return (mt_point){(int32_t)lround(centre.x + x * cosine - y * sine),
                      (int32_t)lround(centre.y + x * sine + y * cosine)};
}

static mt_status turn_ring(const mt_ring *ring, mt_point centre, double degrees, mt_arena *arena,
                           mt_ring *turned) {
    mt_status status = mt_ring_new(arena, ring->count, turned);
    if (status != MT_OK) return status;
    for (int i = 0; i < ring->count; i++) {
        turned->points[i] = mt_turn(ring->points[i], centre, degrees);
        turned->marks[i] = ring->marks[i];
    }
    return MT_OK;
}

mt_status mt_shape_turn(const mt_shape *shape, mt_point centre, double degrees, mt_arena *arena,
                        mt_shape *turned) {
    mt_shape made = {shape->count, mt_arena_new(arena, (size_t)shape->count, sizeof(mt_component))};
    if (!made.components) return MT_NO_MEMORY;
    for (int k = 0; k < shape->count; k++) {
        const mt_component *from = &shape->components[k];
        mt_component *to = &made.components[k];
        *to = (mt_component){from->count, mt_arena_new(arena, (size_t)from->count, sizeof(mt_ring))};
        if (!to->rings) return MT_NO_MEMORY;
        for (int i = 0; i < from->count; i++) {
            mt_status status = turn_ring(&from->rings[i], centre, degrees, arena, &to->rings[i]);
            if (status != MT_OK) return status;
        }
    }
    *turned = made;
    return MT_OK;
}

mt_point mt_morph_turn(const mt_morph *morph, mt_weights weights, mt_point p) {
    if (morph->degrees == 0) return p;
    mt_point centre = mt_mix(weights, mt_box_middle(morph->a.box), mt_box_middle(morph->b.box));
    return mt_turn(p, centre, morph->degrees * weights.b / MT_WEIGHT_ONE);
}

/* ---- principal axes ------------------------------------------------------------------------------------ */

/* The axis as a vector at twice its angle; its length is the shape's elongation, 0 … 1. */
typedef struct mt_turn_axis {
    double area, cosine, sine;
} mt_turn_axis;

/* Moments of area of the signed triangles between the first point of the outer ring and each edge: ∫1, ∫x,
 * ∫y, ∫xx, ∫xy, ∫yy, in ems. */
static void add_moments(const mt_ring *ring, mt_point o, double m[6]) {
    for (int i = 0; i < ring->count; i++) {
        mt_point a = ring->points[i], b = ring->points[(i + 1) % ring->count];
        double px = ((double)a.x - o.x) / MT_EM, py = ((double)a.y - o.y) / MT_EM;
        double qx = ((double)b.x - o.x) / MT_EM, qy = ((double)b.y - o.y) / MT_EM;
        double w = px * qy - py * qx;
        m[0] += w / 2;
        m[1] += w * (px + qx) / 6;
        m[2] += w * (py + qy) / 6;
        m[3] += w * (px * px + px * qx + qx * qx) / 12;
        m[4] += w * (2 * px * py + px * qy + qx * py + 2 * qx * qy) / 24;
        m[5] += w * (py * py + py * qy + qy * qy) / 12;
    }
}

static mt_turn_axis axis_of(const mt_component *component) {
    double m[6] = {0};
    for (int i = 0; i < component->count; i++)
        add_moments(&component->rings[i], component->rings[0].points[0], m);
    if (m[0] <= 0) return (mt_turn_axis){0};
    double xx = m[3] - m[1] * m[1] / m[0], xy = m[4] - m[1] * m[2] / m[0], yy = m[5] - m[2] * m[2] / m[0];
    double spread = xx + yy;
    if (spread <= 0) return (mt_turn_axis){0};
    return (mt_turn_axis){m[0], (xx - yy) / spread, 2 * xy / spread};
}

double mt_find_rotation(const mt_shape *a, const mt_shape *b, const mt_links *matches) {
    double cosine = 0, sine = 0;
    for (int i = 0; i < matches->count; i++) {
        mt_turn_axis u = axis_of(&a->components[matches->links[i].a]),
                     v = axis_of(&b->components[matches->links[i].b]);
        double weight = sqrt(u.area * v.area);
        cosine += weight * (u.cosine * v.cosine + u.sine * v.sine);
        sine += weight * (u.cosine * v.sine - u.sine * v.cosine);
    }
    return cosine == 0 && sine == 0 ? 0 : mt_atan2(sine, cosine) * (90 / M_PI);
}
