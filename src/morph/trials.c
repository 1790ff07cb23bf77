/* The joint method with one set of settings after the other, until an in-between is right: as many parts and holes on the whole way as its
 * ends have (check/topology.h), and nothing that an eye would stumble over (check/appearance.h).
 *
 *     settings 0 ── joined ── looked at: .3 ── parts: 0 ──▶ taken (most glyphs)
 *                                    └── else best so far, by score and parts
 *     settings 1 ── joined as with settings 0, or not for this glyph ──▶ skipped
 *     settings 2 ── joined ── looked at: worse than the best already ──▶ skipped, its parts are not counted
 *     settings 3 ── joined ── looked at: .6 ── parts: 4 ── repaired: reconnect, separate ── 0 ──▶ taken
 *
 * If none is right, the one with the least loss is taken, the first of equals; where holes open in it, they are closed last, since
 * other settings mostly keep them closed and closing takes long. Work is counted in corners of blends looked at, and ends at MT_EFFORT,
 * so that the result does not depend on the machine; so does the work of an arena that is bounded (base/memory.h). Alignments are kept in one cache for all settings. O(MT_EFFORT log MT_EFFORT)
 * for the checks, and a division and a join for each set of settings. */
#include "morph/trials.h"

#include <limits.h>
#include <math.h>

#include "geometry/limits.h"
#include "morph/align/cache.h"
#include "morph/align/registration.h"
#include "morph/check/appearance.h"
#include "morph/check/counters.h"
#include "morph/check/reconnect.h"
#include "morph/check/separate.h"
#include "morph/join/joint.h"
#include "morph/paper/pieces.h"

/* Up to here, an appearance is not improved on: an eye does not stumble yet, and designers' own in-betweens of far corners score as much. */
#define SCORE_GOOD 1.0

/* The first settings, with white filled and as it is, are held against each other: where counters differ much, each may be right. Without
 * white to fill the second are the first. */
enum { ALWAYS = 2 };

/* The settings that were tried. */
typedef struct mt_trials {
    int count;
    mt_morph *morphs;  /* as they were joined */
    mt_white white[2]; /* A's and B's without a counterpart */
} mt_trials;

/* ---- one set of settings ---------------------------------------------------------------------------------------------- */

/* Joined and linked; where the joint method fails, by links alone, unless white was filled. */
static mt_status join(const mt_morph *matched, const mt_join_context *context, mt_arena *arena,
                      mt_morph *joined) {
    *joined = *matched;
    mt_status status = mt_joint(joined, context, arena);
    bool failed = status == MT_TOO_LARGE || status == MT_BAD_GEOMETRY;
    if (!context->white && failed && !mt_arena_is_spent(arena)) {
        *joined = *matched;
        status = MT_OK;
    }
    return status == MT_OK ? mt_map_pieces(joined, context->params, arena) : status;
}

/* What the arena's allowance did not do for is left as it is. */
static mt_status as_far_as_it_goes(mt_status status, const mt_arena *arena) {
    return mt_arena_verdict(arena, status) == MT_TOO_COSTLY ? MT_OK : status;
}

/* Repairs the topology: reconnects parts that separate, separates parts that touch. */
static mt_status repair(mt_mending *m) {
    mt_status status = mt_mend_begin(m);
    if (status == MT_OK && m->error.parts > 0) status = mt_reconnect_parts(m);
    if (status == MT_OK && m->error.merged > 0) status = mt_separate_parts(m);
    return status;
}

/* ---- all settings -------------------------------------------------------------------------------------------- */

static bool same_segment(const mt_segment *p, const mt_segment *q) {
    return p->degree == q->degree && mt_point_equal(p->end, q->end) &&
           (p->degree == 1 || mt_point_equal(p->control[0], q->control[0]));
}

static bool same_contour(const mt_contour *p, const mt_contour *q) {
    if (p->count != q->count) return false;
    for (int i = 0; i < p->count; i++)
        if (!same_segment(&p->segments[i], &q->segments[i])) return false;
    return true;
}

static bool is_same_morph(const mt_morph *p, const mt_morph *q) {
    if (p->links.count > 0 || q->links.count > 0 || p->contour_count != q->contour_count) return false;
    for (int i = 0; i < p->contour_count; i++)
        if (!same_contour(&p->contours[i].a, &q->contours[i].a) ||
            !same_contour(&p->contours[i].b, &q->contours[i].b))
            return false;
    return true;
}

/* Whether earlier settings gave the same contours. */
static bool was_tried(const mt_trials *trials, const mt_morph *morph) {
    for (int i = 0; i < trials->count; i++)
        if (is_same_morph(&trials->morphs[i], morph)) return true;
    return false;
}

typedef struct mt_best_trial {
    mt_mending best;
    double loss;
    bool right; /* nothing is left to be wished */
} mt_best_trial;

/* Joins with one set of settings, and keeps the morph if it is better than the best so far. */
static mt_status try_settings(const mt_morph *matched, const mt_join_context *context,
                              const mt_onlooker *onlooker, mt_trials *trials, mt_best_trial *choice) {
    mt_mending tried = choice->best;
    mt_appearance seen;
    tried.morph = &trials->morphs[trials->count];
    tried.error = (mt_topology_error){.parts = INT_MAX};
    mt_status status = join(matched, context, tried.arena, tried.morph);
    if (context->white && (status == MT_TOO_LARGE || status == MT_BAD_GEOMETRY)) return MT_OK;
    if (status != MT_OK || was_tried(trials, tried.morph)) return status;
    trials->count++;
    status = mt_look_at_morph(onlooker, tried.morph, context->params, tried.arena, &seen);
    double score = mt_appearance_score(&seen);
    if (status != MT_OK || score >= choice->loss) return status;
    status = as_far_as_it_goes(repair(&tried), tried.arena);
    choice->best.effort = tried.effort;
    double loss = mt_appearance_loss(score, tried.error.parts);
    bool right = tried.error.parts == 0 && score <= SCORE_GOOD;
    bool better = right == choice->right ? loss < choice->loss : right;
    if (status != MT_OK || !better) return status;
    *choice = (mt_best_trial){tried, loss, right};
    return MT_OK;
}

/* The morph with the frames of a placing. */
static mt_morph placed(const mt_morph *morph, const mt_registered *registered, mt_placing placing) {
    mt_morph made = *morph;
    made.a.frame = registered->a[placing];
    made.b.frame = registered->b[placing];
    return made;
}

static mt_status try_all(const mt_morph *morph, const mt_hints *hints, const mt_params *params,
                         mt_trials *trials, mt_best_trial *choice) {
    mt_arena *arena = choice->best.arena;
    mt_alignment_cache *cache = mt_arena_new(arena, 1, sizeof *cache);
    mt_registered registered;
    mt_onlooker *onlooker;
    if (!cache) return MT_NO_MEMORY;
    mt_settings first = mt_settings_at(0, params);
    first.cache = cache;
    mt_status status = mt_register(&morph->a, &morph->b, params->lean, &first, arena, &registered);
    mt_morph first_placed = placed(morph, &registered, MT_REGISTERED);
    if (status == MT_OK) status = mt_look_at_ends(&first_placed, arena, &onlooker);
    if (status == MT_OK) status = mt_find_white(&morph->a.shape, &morph->b.shape, arena, trials->white);
    bool white = trials->white[0].count + trials->white[1].count > 0;
    for (int i = 0; status == MT_OK && i < mt_settings_count(); i++) {
        mt_settings settings = mt_settings_at(i, params);
        if ((choice->right && i >= ALWAYS) || choice->best.effort <= 0 || mt_arena_is_spent(arena)) break;
        if (!registered.applies[settings.placing] || (settings.fills && !white)) continue;
        settings.cache = cache;
        mt_join_context context = {hints, params, settings, settings.fills ? trials->white : NULL};
        mt_morph matched = placed(morph, &registered, settings.placing);
        status = try_settings(&matched, &context, onlooker, trials, choice);
    }
    return choice->loss < INFINITY ? as_far_as_it_goes(status, arena) : status;
}

mt_status mt_join_best(mt_morph *morph, const mt_hints *hints, const mt_params *params, mt_arena *arena) {
    mt_trials trials = {.morphs = mt_arena_new(arena, (size_t)mt_settings_count(), sizeof(mt_morph))};
    mt_best_trial choice = {{morph, params, arena, {.parts = INT_MAX}, MT_EFFORT}, INFINITY, false};
    if (!trials.morphs) return MT_NO_MEMORY;
    mt_status status = try_all(morph, hints, params, &trials, &choice);
    if (status == MT_OK && choice.loss == INFINITY && mt_arena_is_spent(arena)) status = MT_TOO_LARGE;
    if (status == MT_OK && choice.best.error.opened > 0)
        status = as_far_as_it_goes(mt_keep_counters(&choice.best), arena);
    if (status != MT_OK) return status;
    *morph = *choice.best.morph;
    morph->proved = choice.best.error.proved && choice.best.error.stays;
    morph->cut_short = mt_arena_is_spent(arena);
    return MT_OK;
}
