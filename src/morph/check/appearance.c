/* Three measures at T = .25, .5 and .75, and one of the whole way.
 *
 * Strays: how far the ink is from where it would be if it took the shortest way from A to B, or in part faded here and grew there, as
 * it does where contrast changes. In one dimension the shortest way leads each share of the ink from its place in A straight to that in B
 * (optimal transport); in two, ink is projected on MT_DIRECTIONS directions (J. Rabin, G. Peyré, J. Delon and M. Bernot, "Wasserstein
 * barycenter and its application to texture mixing", 2011). Held against are mixes of the way and the fading; the least root mean square
 * of what places are off by is the measure. Blobs, strokes that travel or break, and parts born in the wrong place leave that way.
 *
 * Clots: the largest disc in the ink against the largest of both ends. Ink: its area, out of the range of both ends'. Turning: of the
 * boundary (turning.h), which tells what ink alone cannot: whether a black's corner goes with the hairline's corner or with a place beside it,
 * the ink is nearly the same. */
#include "morph/check/appearance.h"

#include <math.h>

#include "arithmetic/angles.h"
#include "geometry/disc.h"
#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "morph/check/projection.h"
#include "morph/check/topology.h"
#include "morph/check/turning.h"

/* What a part too many or too few at one place counts beside the score, and how many count. */
#define PART_LOSS 0.03
#define PARTS_MOST 40

/* What a corner costs where the largest disc is looked for, in steps of the arena. */
enum { DISC_STEPS = 100 };

#define FADED_STEP 0.1 /* shares of the fading that are tried, from 0 … */
enum { FADED_STEPS = 7 };

struct mt_onlooker {
    mt_projection_frame frames[2];
    mt_projection ends[2];
    double disc;         /* the largest of both, grid units */
    mt_frame in_a, in_b; /* in which headings are compared */
};

/* The rings of a shape, within what may be spent on looking at them. */
static mt_status rings_to_look_at(const mt_shape *shape, mt_arena *arena, mt_rings *rings) {
    mt_status status = mt_shape_rings(shape, arena, rings);
    if (status != MT_OK) return status;
    return mt_arena_spend(arena, DISC_STEPS * (int64_t)mt_rings_corners(rings)) ? MT_OK : MT_TOO_LARGE;
}

/* ---- the ends ----------------------------------------------------------------------------------------------------- */

static mt_status look_at_end(const mt_shape *shape, mt_arena *arena, mt_onlooker *o, int end) {
    mt_rings rings;
    mt_status status = rings_to_look_at(shape, arena, &rings);
    if (status != MT_OK) return status;
    mt_project(&rings, &o->frames[end], &o->ends[end]);
    o->disc = mt_largest_disc(&rings, o->disc);
    return MT_OK;
}

mt_status mt_look_at_ends(const mt_morph *morph, mt_arena *arena, mt_onlooker **onlooker) {
    mt_onlooker *o = mt_arena_new(arena, 1, sizeof *o);
    if (!o) return MT_NO_MEMORY;
    const mt_side *sides[] = {&morph->a, &morph->b};
    double reach = 1;
    o->in_a = morph->a.frame;
    o->in_b = morph->b.frame;
    for (int s = 0; s < 2; s++) {
        mt_box box = sides[s]->box;
        o->frames[s].middle = ((double)box.min.x + box.max.x) / 2;
        o->frames[s].base = ((double)box.min.y + box.max.y) / 2;
        reach = fmax(reach, mt_hypot(mt_box_width(box), mt_box_height(box)) / 2);
    }
    double base = (o->frames[0].base + o->frames[1].base) / 2;
    reach += fabs(o->frames[0].base - o->frames[1].base) / 2;
    mt_status status = MT_OK;
    for (int s = 0; status == MT_OK && s < 2; s++) {
        o->frames[s].base = base;
        o->frames[s].reach = reach;
        status = look_at_end(&sides[s]->whole, arena, o, s);
    }
    *onlooker = o;
    return status;
}

/* ---- the way ------------------------------------------------------------------------------------------------------ */

/* The mean square of what places are off by, with `faded` of the fading. */
static double off_by(const mt_projection *at, double moved[MT_DIRECTIONS][MT_QUANTILES],
                     double faded[MT_DIRECTIONS][MT_QUANTILES], double share) {
    double sum = 0;
    for (int d = 0; d < MT_DIRECTIONS; d++)
        for (int q = 0; q < MT_QUANTILES; q++) {
            double off = (1 - share) * moved[d][q] + share * faded[d][q] - at->place[d][q];
            sum += off * off;
        }
    return sum / (MT_DIRECTIONS * MT_QUANTILES);
}

/* 1/1000 em. */
static double strays(const mt_onlooker *o, const mt_projection *at, double t) {
    const mt_projection *a = &o->ends[0], *b = &o->ends[1];
    double moved[MT_DIRECTIONS][MT_QUANTILES], faded[MT_DIRECTIONS][MT_QUANTILES], mixed[MT_BINS];
    double in_a = (1 - t) * a->area, in_b = t * b->area, least = INFINITY;
    for (int d = 0; d < MT_DIRECTIONS; d++) {
        for (int q = 0; q < MT_QUANTILES; q++) moved[d][q] = (1 - t) * a->place[d][q] + t * b->place[d][q];
        for (int i = 0; i < MT_BINS; i++)
            mixed[i] = (in_a * a->share[d][i] + in_b * b->share[d][i]) / (in_a + in_b);
        mt_quantiles_of(mixed, o->frames[0].reach, faded[d]);
    }
    for (int i = 0; i < FADED_STEPS; i++) least = fmin(least, off_by(at, moved, faded, i * FADED_STEP));
    return sqrt(least) * 1000 / MT_EM;
}

mt_status mt_look_at_ink(const mt_onlooker *o, const mt_shape *ink, double t, mt_arena *arena,
                         mt_appearance *seen) {
    mt_rings rings;
    mt_projection at;
    mt_projection_frame frame = o->frames[0];
    frame.middle = (1 - t) * o->frames[0].middle + t * o->frames[1].middle;
    mt_status status = rings_to_look_at(ink, arena, &rings);
    if (status != MT_OK) return status;
    mt_project(&rings, &frame, &at);
    seen->strays = fmax(seen->strays, strays(o, &at, t));
    seen->ink = fmax(seen->ink, mt_area_excess(at.area, o->ends[0].area, o->ends[1].area));
    if (o->disc > 0) seen->clots = fmax(seen->clots, mt_largest_disc(&rings, o->disc) / o->disc);
    return MT_OK;
}

static mt_status look_at_place(const mt_onlooker *o, const mt_morph *morph, double t, const mt_params *params,
                               mt_arena *arena, mt_appearance *seen) {
    mt_morph still = *morph;
    mt_rings rings;
    mt_shape ink;
    still.degrees = 0; /* formula (5) turns all of it: a stroke on an arc does not stray */
    mt_status status = mt_morph_rings(&still, mt_weights_at(t), params, arena, &rings);
    if (status == MT_OK) status = mt_union_unmarked(&rings, MT_NONZERO, arena, &ink);
    if (status == MT_OK) status = mt_look_at_ink(o, &ink, t, arena, seen);
    return status;
}

mt_status mt_look_at_morph(const mt_onlooker *o, const mt_morph *morph, const mt_params *params,
                           mt_arena *arena, mt_appearance *seen) {
    static const double places[] = {0.25, 0.5, 0.75};
    *seen = MT_NOTHING_SEEN;
    seen->turning = mt_turning(morph, &o->in_a, &o->in_b);
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        mt_arena_place before = mt_arena_mark(arena);
        mt_status status = look_at_place(o, morph, places[i], params, arena, seen);
        mt_arena_rewind(arena, before);
        if (status != MT_OK) return status;
    }
    return MT_OK;
}

double mt_appearance_score(const mt_appearance *seen) {
    double clots = (seen->clots - 1) / MT_CLOTS_MOST;
    double ink = fmax(seen->strays / MT_STRAYS_MOST, fmax(clots, seen->ink / MT_INK_MOST));
    return ink + seen->turning / MT_TURNING_MOST;
}

double mt_appearance_loss(double score, int parts) {
    return score + PART_LOSS * fmin(parts, PARTS_MOST);
}
