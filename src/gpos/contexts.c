#include "gpos/contexts.h"

#include "layout/calls.h"

enum { GLYPH_NUMBERS = 65536, NONE = -1 };

/* Flags that name marks by another font's GDEF, which the new font has not, pass over all marks. */
mt_lookup_builder mt_context_head(const mt_layout *layout, int font, int lookup) {
    enum { IGNORE_MARKS = 0x0008, NAMED_MARKS = MT_LOOKUP_MARK_SET | 0xFF00 };
    mt_lookup own = mt_layout_lookup(layout, lookup);
    bool named = font > 0 && (own.flag & NAMED_MARKS);
    return (mt_lookup_builder){.order = lookup,
                               .type = own.type,
                               .flag = named ? (own.flag & ~NAMED_MARKS) | IGNORE_MARKS : own.flag,
                               .mark_set = named ? NONE : own.mark_set};
}

/* What is shared by the fonts, and what belongs to the one at hand. */
typedef struct mt_contexts_job {
    const mt_layout *const *layouts;
    const mt_systems *systems;
    const mt_font_glyphs *glyphs;
    int font;
    mt_context_reader reader;
    mt_lookup_builder *heads; /* of each of the font's lookups that is a context of a feature */
    int *caller;              /* of each that is called, a context of a feature that leads to it; else NONE */
} mt_contexts_job;

static bool spend(mt_contexts_job *job, int64_t count) {
    int64_t *steps = &job->reader.steps;
    *steps = *steps < count ? 0 : *steps - count;
    return *steps > 0;
}

static bool is_context(int type) {
    return type == MT_CONTEXT || type == MT_CHAINED_CONTEXT;
}

/* ---- what is called ------------------------------------------------------------------------------------ */

static bool is_in_feature(const mt_layout *layout, int system, int i, int lookup, uint32_t *tag) {
    int feature = mt_system_feature(layout, &layout->systems[system], i);
    *tag = feature < 0 ? 0 : mt_feature_tag(layout, feature);
    return feature >= 0 && mt_feature_has(layout, feature, lookup);
}

/* Whether a feature of the first font's system has contexts. */
static bool has_contexts(const mt_layout *layout, int system, uint32_t tag) {
    int count = system < 0 ? 0 : layout->systems[system].feature_count + 1;
    for (int i = 0; i < count; i++) {
        int feature = mt_system_feature(layout, &layout->systems[system], i);
        if (feature < 0 || mt_feature_tag(layout, feature) != tag) continue;
        for (int k = 0; k < mt_feature_lookup_count(layout, feature); k++) {
            int lookup = mt_feature_lookup(layout, feature, k);
            if (lookup >= 0 && is_context(mt_layout_lookup(layout, lookup).type)) return true;
        }
    }
    return false;
}

/* Where another font's lookup belongs, as far as the first font has no contexts there; counts only where `members` is NULL. */
static int list_members(mt_contexts_job *job, int lookup, mt_member *members) {
    const mt_layout *layout = job->layouts[job->font];
    int count = 0;
    for (int s = 0; s < job->systems->count; s++) {
        const mt_shared_system *system = &job->systems->list[s];
        int own = system->own[job->font], features = own < 0 ? 0 : layout->systems[own].feature_count + 1;
        for (int i = 0; i < features && spend(job, 1); i++) {
            uint32_t tag;
            if (!is_in_feature(layout, own, i, lookup, &tag)) continue;
            if (has_contexts(job->layouts[0], system->own[0], tag)) continue;
            if (members) members[count] = (mt_member){s, tag};
            count++;
        }
    }
    return count;
}

static mt_status find_others(mt_contexts_job *job, int lookup, mt_lookup_builder *head) {
    mt_member *members =
        mt_arena_new(job->reader.arena, (size_t)list_members(job, lookup, NULL) + 1, sizeof *members);
    if (!members) return MT_NO_MEMORY;
    head->member_count = list_members(job, lookup, members);
    head->members = members;
    return MT_OK;
}

static mt_status find_members(mt_contexts_job *job, int lookup) {
    mt_lookup_builder *head = &job->heads[lookup];
    mt_member *members;
    *head = mt_context_head(job->layouts[job->font], job->font, lookup);
    head->order += job->reader.first_call;
    if (job->font) return find_others(job, lookup, head);
    mt_status status =
        mt_members_of(job->layouts[0], lookup, job->reader.arena, &members, &head->member_count);
    if (status != MT_OK || head->member_count == 0) return status;
    head->members = members;
    return mt_systems_spread(job->systems, job->reader.arena, head);
}

/* Finds the contexts of features, and notes who calls whom. */
static mt_status find_contexts(mt_contexts_job *job) {
    int count = job->layouts[job->font]->lookup_count;
    mt_status status = MT_OK;
    for (int i = 0; i < count; i++) job->caller[i] = NONE;
    for (int i = 0; i < count && status == MT_OK; i++) {
        if (!is_context(mt_layout_lookup(job->layouts[job->font], i).type) || !spend(job, 1)) continue;
        mt_arena_place place = mt_arena_mark(job->reader.scratch);
        bool *reached = mt_arena_new(job->reader.scratch, (size_t)count + 1, sizeof *reached);
        status = reached ? find_members(job, i) : MT_NO_MEMORY;
        if (status != MT_OK || job->heads[i].member_count == 0) continue;
        mt_calls_mark(&job->layouts[job->font]->calls, i, reached);
        for (int k = 0; k < count; k++)
            if (reached[k] && job->caller[k] == NONE) job->caller[k] = i;
        mt_arena_rewind(job->reader.scratch, place);
    }
    return status;
}

/* ---- what goes with it in another font ----------------------------------------------------------------- */

/* Lookups of one type that contexts of a feature call, ascending. */
typedef struct mt_call_list {
    int count;
    int *lookups;
} mt_call_list;

static mt_status list_called(mt_contexts_job *job, int font, mt_member member, int type, mt_call_list *list) {
    const mt_layout *layout = job->layouts[font];
    int system = job->systems->list[member.system].own[font];
    bool *reached = mt_arena_new(job->reader.scratch, (size_t)layout->lookup_count + 1, sizeof *reached);
    list->count = 0;
    list->lookups =
        mt_arena_new(job->reader.scratch, (size_t)layout->lookup_count + 1, sizeof *list->lookups);
    if (!reached || !list->lookups) return MT_NO_MEMORY;
    mt_context_reach_feature(layout, system, member.feature, reached);
    for (int i = 0; i < layout->lookup_count; i++)
        if (reached[i] && mt_layout_lookup(layout, i).type == type) list->lookups[list->count++] = i;
    return MT_OK;
}

/* All kinds of subtables but contexts have the glyphs that they begin with in a Coverage table at the same place. */
static bool is_covered(const mt_lookup *lookup, uint32_t glyph) {
    for (int i = 0; i < lookup->subtable_count; i++)
        if (mt_coverage_find(mt_ot_follow(mt_lookup_subtable(lookup, i), 2), glyph) >= 0) return true;
    return false;
}

/* How many new glyphs both lookups are for. */
static int count_shared(mt_contexts_job *job, int font, int in_a, int in_b) {
    mt_lookup a = mt_layout_lookup(job->layouts[0], in_a), b = mt_layout_lookup(job->layouts[font], in_b);
    int count = 0;
    for (int i = 0; i < job->glyphs->glyph_count && spend(job, a.subtable_count + b.subtable_count); i++) {
        uint32_t other = job->glyphs->of[font][i];
        count += other != MT_NO_PARTNER && is_covered(&a, job->glyphs->of[0][i]) && is_covered(&b, other);
    }
    return count;
}

static int choose(mt_contexts_job *job, int font, int lookup, const mt_call_list *in_a,
                  const mt_call_list *in_b) {
    int at = 0, most = 0, found = NONE;
    while (at < in_a->count && in_a->lookups[at] != lookup) at++;
    if (in_a->count == in_b->count && at < in_b->count &&
        count_shared(job, font, lookup, in_b->lookups[at]) > 0)
        return in_b->lookups[at];
    for (int i = 0; i < in_b->count; i++) {
        int shared = count_shared(job, font, lookup, in_b->lookups[i]);
        if (shared > most) found = in_b->lookups[i];
        if (shared > most) most = shared;
    }
    return found;
}

/* By the first of the features in which the font has such lookups. */
static mt_status find_other(mt_contexts_job *job, int font, mt_called_lookup *called) {
    mt_status status = MT_OK;
    for (int i = 0; i < called->member_count && called->in_fonts[font] == NONE && status == MT_OK; i++) {
        mt_arena_place place = mt_arena_mark(job->reader.scratch);
        mt_call_list in_a = {0}, in_b = {0};
        status = list_called(job, font, called->members[i], called->type, &in_b);
        if (status == MT_OK && in_b.count)
            status = list_called(job, 0, called->members[i], called->type, &in_a);
        if (status == MT_OK) called->in_fonts[font] = choose(job, font, called->in_fonts[0], &in_a, &in_b);
        mt_arena_rewind(job->reader.scratch, place);
    }
    return status;
}

static mt_status add_called(mt_contexts_job *job, int lookup, int type, mt_called_lookups *called) {
    const mt_lookup_builder *head = &job->heads[job->caller[lookup]];
    mt_called_lookup *made = &called->list[called->count++];
    mt_status status = MT_OK;
    *made = (mt_called_lookup){.font = job->font,
                               .type = type,
                               .called_as = job->reader.first_call + lookup + 1,
                               .member_count = head->member_count,
                               .members = head->members};
    for (int k = 0; k < job->glyphs->font_count; k++) made->in_fonts[k] = k == job->font ? lookup : NONE;
    for (int k = 1; k < job->glyphs->font_count && job->font == 0 && status == MT_OK; k++)
        status = find_other(job, k, made);
    return status;
}

/* ---- contexts ------------------------------------------------------------------------------------------ */

static mt_status read_lookup(mt_contexts_job *job, int index, mt_context_lookup *made) {
    mt_lookup lookup = mt_layout_lookup(job->layouts[job->font], index);
    mt_status status = MT_OK;
    made->head = job->heads[index];
    if (job->caller[index] != NONE) made->head.called_as = job->reader.first_call + index + 1;
    if (made->head.member_count == 0) made->head.order += MT_CALLED_ORDER;
    made->subtables =
        mt_arena_new(job->reader.arena, (size_t)lookup.subtable_count + 1, sizeof *made->subtables);
    if (!made->subtables) return MT_NO_MEMORY;
    for (int i = 0; i < lookup.subtable_count && status == MT_OK && spend(job, 1); i++) {
        bool found;
        status = mt_context_read(&job->reader, lookup.type, mt_lookup_subtable(&lookup, i),
                                 &made->subtables[made->count], &found);
        made->count += status == MT_OK && found;
    }
    return status;
}

static mt_status read_all(mt_contexts_job *job, mt_contexts *contexts, mt_called_lookups *called) {
    int count = job->layouts[job->font]->lookup_count;
    mt_status status = MT_OK;
    for (int i = 0; i < count && status == MT_OK; i++) {
        int type = mt_layout_lookup(job->layouts[job->font], i).type;
        bool is_called = job->caller[i] != NONE;
        if (!is_context(type)) {
            if (is_called && type) status = add_called(job, i, type, called);
            continue;
        }
        if (!is_called && job->heads[i].member_count == 0) continue;
        mt_context_lookup made = {0};
        status = read_lookup(job, i, &made);
        if (status == MT_OK && made.count) contexts->list[contexts->count++] = made;
    }
    return status;
}

/* What the reader needs to know of the font at hand. */
static mt_status open_reader(mt_contexts_job *job) {
    mt_context_reader *reader = &job->reader;
    const uint32_t *own = job->glyphs->of[job->font];
    bool *has = mt_arena_new(reader->scratch, GLYPH_NUMBERS, sizeof *has);
    if (!has) return MT_NO_MEMORY;
    for (int i = 0; i < job->glyphs->glyph_count; i++)
        if (own[i] < GLYPH_NUMBERS) has[own[i]] = true;
    reader->layout = job->layouts[job->font];
    reader->own = own;
    reader->has = has;
    return MT_OK;
}

static mt_status add_font(mt_contexts_job *job, mt_contexts *contexts, mt_called_lookups *called) {
    size_t room = (size_t)job->layouts[job->font]->lookup_count + 1;
    mt_status status = open_reader(job);
    job->heads = mt_arena_new(job->reader.scratch, room, sizeof *job->heads);
    job->caller = mt_arena_new(job->reader.scratch, room, sizeof *job->caller);
    if (!job->heads || !job->caller) return MT_NO_MEMORY;
    if (status == MT_OK) status = find_contexts(job);
    return status == MT_OK ? read_all(job, contexts, called) : status;
}

static mt_status prepare(mt_contexts_job *job, mt_contexts *contexts, mt_called_lookups *called) {
    size_t room = 1;
    mt_status status = MT_OK;
    for (int k = 0; k < job->glyphs->font_count; k++) room += (size_t)job->layouts[k]->lookup_count;
    contexts->list = mt_arena_new(job->reader.arena, room, sizeof *contexts->list);
    called->list = mt_arena_new(job->reader.arena, room, sizeof *called->list);
    if (!contexts->list || !called->list) return MT_NO_MEMORY;
    for (job->font = 0; job->font < job->glyphs->font_count && status == MT_OK; job->font++) {
        mt_arena_place place = mt_arena_mark(job->reader.scratch);
        status = add_font(job, contexts, called);
        mt_arena_rewind(job->reader.scratch, place);
        job->reader.first_call += job->layouts[job->font]->lookup_count;
    }
    return status;
}

mt_status mt_contexts_prepare(const mt_layout *const *layouts, const mt_systems *systems,
                              const mt_font_glyphs *glyphs, mt_arena *arena, mt_contexts *contexts,
                              mt_called_lookups *called) {
    mt_arena scratch = {0};
    mt_contexts_job job = {.layouts = layouts,
                           .systems = systems,
                           .glyphs = glyphs,
                           .reader = {.glyph_count = glyphs->glyph_count,
                                      .arena = arena,
                                      .scratch = &scratch,
                                      .steps = MT_CONTEXT_STEPS_MAX}};
    mt_contexts made = {0};
    mt_called_lookups made_called = {0};
    mt_status status = prepare(&job, &made, &made_called);
    mt_arena_release(&scratch);
    if (status != MT_OK) return status;
    *contexts = made;
    *called = made_called;
    return MT_OK;
}
