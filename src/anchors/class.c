#include "anchors/class.h"

#include <stdlib.h>
#include <string.h>

enum { MARK_STEPS = 2 }; /* to look a mark up, read it and sort it */

/* The marks and bases that are divided. Sets of bases are bit sets of `words` words. */
typedef struct mt_class_work {
    int font;
    const mt_attachment *from;
    int words;
    mt_anchor_point *points; /* for each base, of the font's rival at work */
    uint64_t *all;           /* the bases */
    uint64_t *covered;       /* for each mark, the bases that both anchors are kept for */
    uint64_t *found;         /* scratch */
} mt_class_work;

static bool is_in(const uint64_t *set, int base) {
    return set[base / 64] >> (base % 64) & 1;
}

static void put_in(uint64_t *set, int base) {
    set[base / 64] |= (uint64_t)1 << (base % 64);
}

static uint64_t *covered_by(const mt_class_work *work, int mark) {
    return work->covered + (size_t)mark * (size_t)work->words;
}

int mt_read_mark_compare(const void *p, const void *q) {
    const mt_read_mark *x = p, *y = q;
    if (x->mark_class != y->mark_class) return x->mark_class < y->mark_class ? -1 : 1;
    return x->glyph - y->glyph;
}

int mt_class_end(const mt_read_mark *marks, int count, int start) {
    int end = start + 1;
    while (end < count && marks[end].mark_class == marks[start].mark_class) end++;
    return end;
}

/* ---- what is kept -------------------------------------------------------------------------------------- */

/* A new subtable with room for that many. NULL when there is no memory. */
static mt_attachment *add_attachment(mt_anchor_job *job, mt_anchor_lookup *lookup, int marks, int bases) {
    mt_attachment *grown = mt_arena_grow_list(job->arena, lookup->attachments, lookup->attachment_count,
                                              &lookup->attachment_room, sizeof *grown);
    if (!grown) return NULL;
    lookup->attachments = grown;
    mt_attachment *made = &lookup->attachments[lookup->attachment_count];
    *made = (mt_attachment){.marks = mt_arena_new(job->arena, (size_t)marks, sizeof *made->marks),
                            .bases = mt_arena_new(job->arena, (size_t)bases, sizeof *made->bases)};
    if (!made->marks || !made->bases) return NULL;
    lookup->attachment_count++;
    return made;
}

/* A mark or base with its place in the font too. NULL when there is no memory. */
static mt_anchored *add_anchored(mt_anchor_job *job, int font, const mt_anchored *from, mt_anchored *to) {
    *to = *from;
    to->at = mt_anchor_new(job, from->at, font, job->arena);
    return to->at.in_fonts ? to : NULL;
}

static mt_status add_at(mt_anchor_job *job, int font, const mt_anchored *from, mt_anchor_point point,
                        mt_anchored *to) {
    if (!add_anchored(job, font, from, to)) return MT_NO_MEMORY;
    to->at.in_fonts[font] = mt_anchor_scaled(job, font, point);
    return MT_OK;
}

static mt_status add_moved(mt_anchor_job *job, int font, const mt_anchored *from, mt_anchored *to) {
    if (!add_anchored(job, font, from, to)) return MT_NO_MEMORY;
    return mt_anchor_move(job, font, from->glyph, to->at);
}

static int set_size(const uint64_t *set, int words) {
    int count = 0;
    for (int i = 0; i < words; i++) count += __builtin_popcountll(set[i]);
    return count;
}

/* ---- anchored by the font too -------------------------------------------------------------------------- */

/* Finds the font's anchors of the bases for a class of a rival. */
static void find_bases(mt_anchor_job *job, const mt_attachment_table *rival, int mark_class,
                       mt_class_work *work) {
    const uint32_t *own = job->glyphs->of[work->font];
    memset(work->found, 0, (size_t)work->words * sizeof *work->found);
    for (int i = 0; i < work->from->base_count; i++) {
        const mt_anchored *base = &work->from->bases[i];
        if (own[base->glyph] == MT_NO_PARTNER) continue;
        int index = mt_coverage_find(rival->base_coverage, own[base->glyph]);
        if (mt_attachment_components(rival, index) == base->component_count &&
            mt_attachment_base(rival, index, base->component, mark_class, job->sources[work->font].variations,
                               &work->points[i]))
            put_in(work->found, i);
    }
}

/* Drops from the found bases those that every one of the marks has already, and gives the marks the others. */
static void cover(const mt_read_mark *marks, int count, mt_class_work *work) {
    for (int w = 0; w < work->words; w++) {
        uint64_t all = ~(uint64_t)0;
        for (int i = 0; i < count; i++) all &= covered_by(work, marks[i].place)[w];
        work->found[w] &= ~all;
        for (int i = 0; i < count; i++) covered_by(work, marks[i].place)[w] |= work->found[w];
    }
}

/* Marks that are of one class in the font too, with the bases that it anchors for it. */
static mt_status add_mixed(mt_anchor_job *job, const mt_attachment_table *rival, const mt_read_mark *marks,
                           int count, mt_class_work *work, mt_anchor_lookup *lookup) {
    const mt_attachment *from = work->from;
    if (!mt_anchor_spend(job, from->base_count + (int64_t)count * work->words)) return MT_OK;
    find_bases(job, rival, marks->mark_class, work);
    cover(marks, count, work);
    int kept = set_size(work->found, work->words);
    if (kept == 0 || !mt_anchor_spend(job, MT_ANCHOR_KEPT_STEPS * (int64_t)(count + kept))) return MT_OK;
    mt_attachment *made = add_attachment(job, lookup, count, kept);
    mt_status status = made ? MT_OK : MT_NO_MEMORY;
    for (int i = 0; i < count && status == MT_OK; i++)
        status = add_at(job, work->font, &from->marks[marks[i].place], marks[i].point,
                        &made->marks[made->mark_count++]);
    for (int i = 0; i < from->base_count && status == MT_OK; i++)
        if (is_in(work->found, i))
            status =
                add_at(job, work->font, &from->bases[i], work->points[i], &made->bases[made->base_count++]);
    return status;
}

static mt_status blend_rival(mt_anchor_job *job, mt_bytes subtable, mt_class_work *work,
                             mt_anchor_lookup *lookup) {
    mt_attachment_table rival;
    int count = 0, all = work->from->mark_count;
    mt_status status = MT_OK;
    if (!mt_attachment_open(subtable, lookup->head.type, &rival)) return MT_OK;
    mt_read_mark *marks = mt_arena_new(&job->scratch, (size_t)all, sizeof *marks);
    if (!marks) return MT_NO_MEMORY;
    for (int i = 0; i < all; i++) {
        mt_read_mark *mark = &marks[count];
        uint16_t glyph = work->from->marks[i].glyph;
        uint32_t own = job->glyphs->of[work->font][glyph];
        int index = own == MT_NO_PARTNER ? -1 : mt_coverage_find(rival.mark_coverage, own);
        *mark = (mt_read_mark){.glyph = glyph, .place = i};
        if (mt_attachment_mark(&rival, index, job->sources[work->font].variations, &mark->mark_class,
                               &mark->point))
            count++;
    }
    qsort(marks, (size_t)count, sizeof *marks, mt_read_mark_compare);
    for (int i = 0, end; i < count && status == MT_OK; i = end) {
        end = mt_class_end(marks, count, i);
        status = add_mixed(job, &rival, marks + i, end - i, work, lookup);
    }
    return status;
}

/* Whether the mark has bases that are not covered. */
static bool has_left(const mt_class_work *work, int mark) {
    const uint64_t *covered = covered_by(work, mark);
    for (int w = 0; w < work->words; w++)
        if (work->all[w] & ~covered[w]) return true;
    return false;
}

static int count_left(const mt_class_work *work) {
    int count = 0;
    for (int i = 0; i < work->from->mark_count; i++) count += has_left(work, i);
    return count;
}

/* Goes through the font's subtables until all is covered. */
static mt_status blend_rivals(mt_anchor_job *job, mt_class_work *work, const mt_rivals *rivals,
                              mt_anchor_lookup *lookup) {
    int64_t steps = (int64_t)work->from->mark_count * (MARK_STEPS + work->words);
    mt_status status = MT_OK;
    for (int i = 0; i < rivals->count && status == MT_OK && mt_anchor_spend(job, steps); i++) {
        if (count_left(work) == 0) break;
        mt_arena_place place = mt_arena_mark(&job->scratch);
        status = blend_rival(job, rivals->subtables[i], work, lookup);
        mt_arena_rewind(&job->scratch, place);
    }
    return status;
}

/* ---- not anchored by the font -------------------------------------------------------------------------- */

/* Finds the bases that are not covered for some mark; returns how many. */
static int find_left(mt_class_work *work) {
    for (int w = 0; w < work->words; w++) {
        uint64_t left = 0;
        for (int i = 0; i < work->from->mark_count; i++) left |= work->all[w] & ~covered_by(work, i)[w];
        work->found[w] = left;
    }
    return set_size(work->found, work->words);
}

static mt_status add_rest(mt_anchor_job *job, mt_class_work *work, mt_anchor_lookup *lookup) {
    const mt_attachment *from = work->from;
    int count = count_left(work), kept = find_left(work);
    if (kept == 0 || !mt_anchor_spend(job, MT_ANCHOR_KEPT_STEPS * (int64_t)(count + kept))) return MT_OK;
    mt_attachment *made = add_attachment(job, lookup, count, kept);
    mt_status status = made ? MT_OK : MT_NO_MEMORY;
    for (int i = 0; i < from->mark_count && status == MT_OK; i++)
        if (has_left(work, i))
            status = add_moved(job, work->font, &from->marks[i], &made->marks[made->mark_count++]);
    for (int i = 0; i < from->base_count && status == MT_OK; i++)
        if (is_in(work->found, i))
            status = add_moved(job, work->font, &from->bases[i], &made->bases[made->base_count++]);
    return status;
}

/* ---- the whole class ----------------------------------------------------------------------------------- */

mt_status mt_class_divide(mt_anchor_job *job, int font, const mt_attachment *from, const mt_rivals *rivals,
                          mt_anchor_lookup *lookup) {
    size_t bases = (size_t)from->base_count, words = (bases + 63) / 64, marks = (size_t)from->mark_count;
    mt_class_work work = {.font = font, .from = from, .words = (int)words};
    if (!mt_anchor_spend(job, (int64_t)(bases + 16 * marks * words))) return MT_OK;
    mt_arena_place place = mt_arena_mark(&job->scratch);
    work.points = mt_arena_new(&job->scratch, bases, sizeof *work.points);
    work.all = mt_arena_new(&job->scratch, words, sizeof *work.all);
    work.found = mt_arena_new(&job->scratch, words, sizeof *work.found);
    work.covered = mt_arena_new(&job->scratch, marks * words, sizeof *work.covered);
    if (!work.points || !work.all || !work.found || !work.covered) return MT_NO_MEMORY;
    for (int i = 0; i < from->base_count; i++) put_in(work.all, i);
    mt_status status = blend_rivals(job, &work, rivals, lookup);
    if (status == MT_OK) status = add_rest(job, &work, lookup);
    mt_arena_rewind(&job->scratch, place);
    return status;
}
