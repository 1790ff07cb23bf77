/* The joint method with one set of settings after the other, until the topology of the in-betweens is right (check/topology.h).
 *
 *     settings 0 ── joined ── error 0 ──▶ taken (most glyphs)
 *                       └──── error 4 ── repaired: reconnect, separate ── error 1 ──▶ best so far
 *     settings 1 ── joined as with settings 0 ──▶ skipped
 *     settings 2 ── joined ── error 0 ──▶ taken
 *
 * The one with the least error is taken, the first of equals; where holes open in it, they are closed last, since other settings
 * mostly keep them closed and closing takes long. Work is counted in corners of blends looked at, and ends at MT_EFFORT, so
 * that the result does not depend on the machine. Alignments are kept in one cache for all settings. O(MT_EFFORT log MT_EFFORT) for
 * the checks, and up to 14 divisions and joins. */
#include "morph/trials.h"

#include <limits.h>
#include <math.h>

#include "geometry/limits.h"
#include "morph/align/cache.h"
#include "morph/align/registration.h"
#include "morph/check/counters.h"
#include "morph/check/reconnect.h"
#include "morph/check/separate.h"
#include "morph/join/joint.h"
#include "morph/paper/pieces.h"

/* The settings that were tried. */
typedef struct mt_trials {
    int count;
    mt_morph *morphs; /* as they were joined */
} mt_trials;

/* ---- one set of settings ---------------------------------------------------------------------------------------------- */

/* Joined and linked; where the joint method fails, by links alone. */
static mt_status join(const mt_morph *matched, const mt_join_context *context, mt_arena *arena,
                      mt_morph *joined) {
    *joined = *matched;
    mt_status status = mt_joint(joined, context, arena);
    if (status == MT_TOO_LARGE || status == MT_BAD_GEOMETRY) {
        *joined = *matched;
        status = MT_OK;
    }
    return status == MT_OK ? mt_map_pieces(joined, context->params, arena) : status;
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

/* Whether settings have less error in parts and holes, and no more in the ink where that is out of bounds. */
static bool is_better(mt_topology_error tried, mt_topology_error best) {
    return tried.parts < best.parts && (tried.ink <= MT_INK_EXCESS || tried.ink <= best.ink);
}

mt_status mt_join_best(mt_morph *morph, const mt_hints *hints, const mt_params *params, mt_arena *arena) {
    mt_trials trials = {0, mt_arena_new(arena, (size_t)mt_settings_count(), sizeof(mt_morph))};
    mt_alignment_cache *cache = mt_arena_new(arena, 1, sizeof *cache);
    mt_mending best = {morph, params, arena, {.parts = INT_MAX, .ink = INFINITY}, MT_EFFORT};
    if (!cache || !trials.morphs) return MT_NO_MEMORY;
    mt_settings first = mt_settings_at(0, params);
    first.cache = cache;
    mt_status status = mt_register(&morph->a, &morph->b, &first, arena);
    if (status != MT_OK) return status;
    for (int i = 0; i < mt_settings_count() && mt_mend_goes_on(&best); i++) {
        mt_join_context context = {hints, params, mt_settings_at(i, params)};
        context.settings.cache = cache;
        mt_mending tried = best;
        tried.morph = &trials.morphs[trials.count];
        status = join(morph, &context, arena, tried.morph);
        if (status != MT_OK) return status;
        if (was_tried(&trials, tried.morph)) continue;
        trials.count++;
        status = repair(&tried);
        if (status != MT_OK) return status;
        best.effort = tried.effort;
        if (is_better(tried.error, best.error)) best = tried;
    }
    status = best.error.opened > 0 ? mt_keep_counters(&best) : MT_OK;
    if (status == MT_OK) *morph = *best.morph;
    return status;
}
