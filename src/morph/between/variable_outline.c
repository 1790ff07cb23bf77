#include "morph/between/variable_outline.h"

#include <math.h>

#include "geometry/limits.h"
#include "morph/between/link_contour.h"
#include "morph/between/seam_overlap.h"
#include "morph/fit/contour_pair.h"
#include "morph/paper/rotation.h"

/* How far contours that meet at a cut lie over one another, 1/1000 em: as much as rounding to whole units could part them
 * by, and half as much again. */
#define LAP 1.5

mt_status mt_variable_outline_make(const mt_morph *morph, const mt_params *params, mt_arena *arena,
                                   mt_variable_outline *moving) {
    size_t room = (size_t)morph->contour_count + (size_t)morph->links.count;
    mt_variable_outline made = {morph->contour_count, mt_arena_new(arena, room, sizeof(mt_contour_pair))};
    if (!made.contours) return MT_NO_MEMORY;
    for (int i = 0; i < morph->contour_count; i++) made.contours[i] = morph->contours[i];
    for (int i = 0; i < morph->links.count; i++) {
        mt_link link = morph->links.links[i];
        mt_status status = mt_link_contour(&morph->a.pieces.rings[link.a], &morph->b.pieces.rings[link.b],
                                           mt_grid_units(params->tolerance), mt_grid_units(params->fit),
                                           arena, &made.contours[made.count++]);
        if (status != MT_OK) return status;
    }
    mt_status status = mt_overlap_seams(morph, mt_grid_units(LAP), arena, &made);
    if (status == MT_OK) *moving = made;
    return status;
}

/* ---- places on the way --------------------------------------------------------------------------------- */

static void turn_contour(const mt_morph *morph, mt_weights weights, mt_contour *contour) {
    for (int i = 0; i < contour->count; i++) {
        mt_segment *s = &contour->segments[i];
        s->control[0] = mt_morph_turn(morph, weights, s->control[0]);
        s->end = mt_morph_turn(morph, weights, s->end);
    }
}

mt_status mt_variable_outline_at(const mt_morph *morph, const mt_variable_outline *moving, mt_weights weights,
                                 mt_arena *arena, mt_outline *outline) {
    mt_outline made = {moving->count, mt_arena_new(arena, (size_t)moving->count, sizeof(mt_contour))};
    if (!made.contours) return MT_NO_MEMORY;
    for (int i = 0; i < moving->count; i++) {
        mt_status status = mt_contour_pair_mix(&moving->contours[i], weights, arena, &made.contours[i]);
        if (status != MT_OK) return status;
        turn_contour(morph, weights, &made.contours[i]);
    }
    *outline = made;
    return MT_OK;
}

/* ---- rotation ------------------------------------------------------------------------------------------ */

/* How far a point is from the middle it is turned about, and how much of that changes on the way. */
static void measure(mt_point a, mt_point middle_a, mt_point b, mt_point middle_b, double *radius,
                    double *change) {
    double ax = a.x - middle_a.x, ay = a.y - middle_a.y, bx = b.x - middle_b.x, by = b.y - middle_b.y;
    *radius = fmax(*radius, fmax(hypot(ax, ay), hypot(bx, by)));
    *change = fmax(*change, hypot(bx - ax, by - ay));
}

/* Whether a contour turns off its straight way half-way (mt_contour_pair.displacement). */
static bool is_displaced(const mt_variable_outline *moving) {
    for (int i = 0; i < moving->count; i++)
        if (!mt_point_equal(moving->contours[i].displacement, (mt_point){0, 0})) return true;
    return false;
}

/* A point is turned by an angle that grows with T about a middle, as its distance from it changes evenly. The second derivative of
 * its way is then at most q²·radius + 2q·change (q in radians), and a flatness over 1/n of it departs by an eighth of that over n². */
int mt_variable_outline_steps(const mt_morph *morph, const mt_variable_outline *moving, double bound) {
    double radius = 0, change = 0, q = fabs(morph->degrees) * (M_PI / 180);
    mt_point a = mt_box_middle(morph->a.box), b = mt_box_middle(morph->b.box);
    int parts = is_displaced(moving) ? 2 : 1;
    if (morph->degrees == 0) return parts;
    for (int i = 0; i < moving->count; i++)
        for (int k = 0; k < moving->contours[i].a.count; k++) {
            const mt_segment *s = &moving->contours[i].a.segments[k], *t = &moving->contours[i].b.segments[k];
            measure(s->end, a, t->end, b, &radius, &change);
            if (s->degree == 2) measure(s->control[0], a, t->control[0], b, &radius, &change);
        }
    double steps = ceil(sqrt((q * q * radius + 2 * q * change) / (8 * bound)));
    int most = MT_TURN_STEPS_MAX / parts, needed = (int)fmin(fmax(ceil(steps / parts), 1), most);
    return needed * parts;
}
