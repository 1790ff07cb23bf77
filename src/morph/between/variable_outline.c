/* A morph as contours that vary (section 2.3 for all r at once), and the steps that a rotation takes.
 *
 * Without rotation a point moves on a straight line, in one step. With formula (5) it turns by (1 − r) q about a middle while its distance
 * from that changes evenly: the second derivative of its path is at most q² · radius + 2 q · change, q in radians, and a chord over 1/n of
 * the path departs from it by at most an eighth of that over n².
 *
 * Contours beside a cut are made to overlap (seam_overlap.c): rounded to whole units, they would leave a hairline. Invariant: as many
 * contours, and segments of the same degrees, in both masters. O(n) for n segments, but for the links' fits and the seams. */
#include "morph/between/variable_outline.h"

#include <assert.h>
#include <math.h>

#include "arithmetic/angles.h"
#include "geometry/limits.h"
#include "morph/between/link_contour.h"
#include "morph/between/seam_overlap.h"
#include "morph/fit/contour_pair.h"
#include "morph/paper/rotation.h"

/* The overlap of contours beside a cut, 1/1000 em: one and a half times the gap that rounding to whole units can leave. */
#define SEAM_OVERLAP 1.5

mt_status mt_variable_outline_make(const mt_morph *morph, const mt_params *params, mt_arena *arena,
                                   mt_variable_outline *variable) {
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
    mt_status status = mt_overlap_seams(morph, mt_grid_units(SEAM_OVERLAP), arena, &made);
    assert(status != MT_OK || mt_variable_outline_is_valid(&made));
    if (status == MT_OK) *variable = made;
    return status;
}

/* ---- one place ----------------------------------------------------------------------------------------- */

static void turn_contour(const mt_morph *morph, mt_weights weights, mt_contour *contour) {
    for (int i = 0; i < contour->count; i++) {
        mt_segment *s = &contour->segments[i];
        s->control[0] = mt_morph_turn(morph, weights, s->control[0]);
        s->end = mt_morph_turn(morph, weights, s->end);
    }
}

mt_status mt_variable_outline_at(const mt_morph *morph, const mt_variable_outline *variable,
                                 mt_weights weights, mt_arena *arena, mt_outline *outline) {
    mt_outline made = {variable->count, mt_arena_new(arena, (size_t)variable->count, sizeof(mt_contour))};
    if (!made.contours) return MT_NO_MEMORY;
    for (int i = 0; i < variable->count; i++) {
        mt_status status = mt_contour_pair_mix(&variable->contours[i], weights, arena, &made.contours[i]);
        if (status != MT_OK) return status;
        turn_contour(morph, weights, &made.contours[i]);
    }
    *outline = made;
    return MT_OK;
}

/* ---- rotation ------------------------------------------------------------------------------------------ */

/* Raises *radius to a point's distance from the middle that it is turned about, and *change to the difference of both ends'. */
static void measure(mt_point a, mt_point middle_a, mt_point b, mt_point middle_b, double *radius,
                    double *change) {
    double ax = a.x - middle_a.x, ay = a.y - middle_a.y, bx = b.x - middle_b.x, by = b.y - middle_b.y;
    *radius = fmax(*radius, fmax(mt_hypot(ax, ay), mt_hypot(bx, by)));
    *change = fmax(*change, mt_hypot(bx - ax, by - ay));
}

/* Whether a contour is displaced half-way. */
static bool is_displaced(const mt_variable_outline *variable) {
    for (int i = 0; i < variable->count; i++)
        if (!mt_point_equal(variable->contours[i].displacement, (mt_point){0, 0})) return true;
    return false;
}

int mt_variable_outline_steps(const mt_morph *morph, const mt_variable_outline *variable, double bound) {
    double radius = 0, change = 0, q = fabs(morph->degrees) * (M_PI / 180);
    mt_point a = mt_box_middle(morph->a.box), b = mt_box_middle(morph->b.box);
    int parts = is_displaced(variable) ? 2 : 1;
    if (morph->degrees == 0) return parts;
    for (int i = 0; i < variable->count; i++)
        for (int k = 0; k < variable->contours[i].a.count; k++) {
            const mt_segment *s = &variable->contours[i].a.segments[k],
                             *t = &variable->contours[i].b.segments[k];
            measure(s->end, a, t->end, b, &radius, &change);
            if (s->degree == 2) measure(s->control[0], a, t->control[0], b, &radius, &change);
        }
    double steps = ceil(sqrt((q * q * radius + 2 * q * change) / (8 * bound)));
    int most = MT_TURN_STEPS_MAX / parts, needed = (int)fmin(fmax(ceil(steps / parts), 1), most);
    return needed * parts;
}
