/* The anchors of all fonts, lookup by lookup of A's. */
#include "anchors/anchors.h"

#include "anchors/blend.h"
#include "anchors/cursive.h"
#include "anchors/rivals.h"
#include "anchors/subtable.h"

/* ---- the job ------------------------------------------------------------------------------------------- */

enum { GLYPH_NUMBERS = 65536 };

/* Lists the new glyphs by A's. */
static mt_status index_glyphs(mt_anchor_job *job) {
    int count = job->glyphs->glyph_count;
    const uint32_t *in_a = job->glyphs->of[0];
    job->first = mt_arena_new(job->arena, GLYPH_NUMBERS + 1, sizeof *job->first);
    job->new_of_a = mt_arena_new(job->arena, (size_t)count, sizeof *job->new_of_a);
    uint32_t *next = mt_arena_new(&job->scratch, GLYPH_NUMBERS, sizeof *next);
    if (!job->first || !job->new_of_a || !next) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++)
        if (in_a[i] < GLYPH_NUMBERS) job->first[in_a[i] + 1]++;
    for (int i = 0; i < GLYPH_NUMBERS; i++) {
        next[i] = job->first[i];
        job->first[i + 1] += job->first[i];
    }
    for (int i = 0; i < count; i++)
        if (in_a[i] < GLYPH_NUMBERS) job->new_of_a[next[in_a[i]]++] = (uint16_t)i;
    return MT_OK;
}

/* ---- lookups ------------------------------------------------------------------------------------------- */

/* Fills the lookup by A's subtables. */
static mt_status blend_subtables(mt_anchor_job *job, const mt_lookup *in_a, const mt_rivals *rivals,
                                 mt_anchor_lookup *made) {
    mt_status status = MT_OK;
    mt_arena_place place = mt_arena_mark(&job->scratch);
    for (int i = 0; i < in_a->subtable_count && status == MT_OK && mt_anchor_spend(job, 1); i++) {
        mt_bytes subtable = mt_lookup_subtable(in_a, i);
        if (in_a->type == MT_CURSIVE)
            status = mt_cursive_blend(job, subtable, rivals, made);
        else
            status = mt_attachment_blend(job, subtable, rivals, made);
        mt_arena_rewind(&job->scratch, place);
    }
    return status;
}

static mt_lookup_builder head_of(int order, const mt_lookup *in_a) {
    return (mt_lookup_builder){
        .order = order, .type = in_a->type, .flag = in_a->flag, .mark_set = in_a->mark_set};
}

/* A's lookup as it goes into the new font; one that is in no feature has nothing. */
static mt_status blend_lookup(mt_anchor_job *job, int order, const mt_lookup *in_a, mt_anchor_lookup *made) {
    mt_member *members;
    mt_rivals rivals[MT_STOPS_MAX] = {0};
    made->head = head_of(order, in_a);
    mt_status status =
        mt_members_of(job->sources[0].layout, order, job->arena, &members, &made->head.member_count);
    if (status != MT_OK || made->head.member_count == 0) return status;
    made->head.members = members;
    mt_arena_reset(&job->scratch);
    status = mt_systems_spread(job->systems, job->arena, &made->head);
    for (int k = 1; k < job->glyphs->font_count && status == MT_OK; k++)
        status = mt_rivals_find(job, k, &made->head, &rivals[k]);
    return status == MT_OK ? blend_subtables(job, in_a, rivals, made) : status;
}

/* A lookup that A's contexts call: apart from the one that features have, if they have it. */
static mt_status blend_called(mt_anchor_job *job, const mt_called_lookup *call, const mt_lookup *in_a,
                              mt_anchor_lookup *made) {
    mt_rivals rivals[MT_STOPS_MAX] = {0};
    mt_status status = MT_OK;
    made->head = head_of(MT_CALLED_ORDER + call->called_as, in_a);
    made->head.members = call->members;
    made->head.member_count = call->member_count;
    mt_arena_reset(&job->scratch);
    for (int k = 1; k < job->glyphs->font_count && status == MT_OK; k++)
        status = call->in_fonts[k] >= 0 ? mt_rivals_of(job, k, call->in_fonts[k], &rivals[k])
                                        : mt_rivals_find(job, k, &made->head, &rivals[k]);
    made->head.called_as = call->called_as;
    made->head.member_count = 0;
    return status == MT_OK ? blend_subtables(job, in_a, rivals, made) : status;
}

static bool has_anchors(int type) {
    return type >= MT_CURSIVE && type <= MT_MARK_TO_MARK;
}

static mt_status blend_lookups(mt_anchor_job *job, const mt_called_lookup *calls, int call_count,
                               mt_anchors *anchors) {
    const mt_layout *layout = job->sources[0].layout;
    int lookup_count = layout->lookup_count;
    size_t room = (size_t)lookup_count + (size_t)call_count + 1;
    anchors->lookups = mt_arena_new(job->arena, room, sizeof *anchors->lookups);
    if (!anchors->lookups) return MT_NO_MEMORY;
    for (int i = 0; i < lookup_count + call_count; i++) {
        const mt_called_lookup *call = i < lookup_count ? NULL : &calls[i - lookup_count];
        if (call && call->font) continue;
        mt_lookup in_a = mt_layout_lookup(layout, call ? call->in_fonts[0] : i);
        mt_anchor_lookup made = {0};
        if (!has_anchors(in_a.type) || !mt_anchor_spend(job, 1)) continue;
        mt_status status = call ? blend_called(job, call, &in_a, &made) : blend_lookup(job, i, &in_a, &made);
        if (status != MT_OK) return status;
        if (made.attachment_count || made.cursive_count) anchors->lookups[anchors->count++] = made;
    }
    return MT_OK;
}

static mt_status open_moves(mt_anchor_job *job, int units) {
    mt_status status = MT_OK;
    for (int k = 1; k < job->glyphs->font_count && status == MT_OK; k++)
        status = mt_outline_moves_open(job->sources[0].font, job->sources[k].font, job->glyphs, k, units,
                                       job->arena, &job->moves[k]);
    return status;
}

mt_status mt_anchors_prepare(const mt_anchor_source *sources, const mt_systems *systems,
                             const mt_called_lookup *calls, int call_count, const mt_font_glyphs *glyphs,
                             int units, mt_arena *arena, mt_anchors *anchors) {
    mt_anchor_job job = {.sources = sources,
                         .systems = systems,
                         .glyphs = glyphs,
                         .arena = arena,
                         .steps = MT_ANCHOR_STEPS_MAX};
    mt_anchors made = {0};
    for (int k = 0; k < glyphs->font_count; k++)
        job.scales[k] = (double)units / mt_font_units_per_em(sources[k].font);
    mt_status status = index_glyphs(&job);
    if (status == MT_OK) status = open_moves(&job, units);
    if (status == MT_OK) status = blend_lookups(&job, calls, call_count, &made);
    mt_arena_release(&job.scratch);
    for (int k = 1; k < glyphs->font_count; k++) mt_arena_release(&job.moves[k].scratch);
    if (status == MT_OK) *anchors = made;
    return status;
}
