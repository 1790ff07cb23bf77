#include "layout/anchor_class.h"

#include <stdlib.h>
#include <string.h>

enum { MARK_STEPS = 2 }; /* to look a mark up, read it and sort it */

static bool is_in(const uint64_t *set, int row) {
    return set[row / 64] >> (row % 64) & 1;
}

static void put_in(uint64_t *set, int row) {
    set[row / 64] |= (uint64_t)1 << (row % 64);
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
    if (lookup->attachment_count == lookup->attachment_room) {
        int room = lookup->attachment_room ? 2 * lookup->attachment_room : 8;
        mt_attachment *grown = mt_arena_new(job->arena, (size_t)room, sizeof *grown);
        if (!grown) return NULL;
        if (lookup->attachments)
            memcpy(grown, lookup->attachments, (size_t)lookup->attachment_count * sizeof *grown);
        lookup->attachments = grown;
        lookup->attachment_room = room;
    }
    mt_attachment *made = &lookup->attachments[lookup->attachment_count];
    *made = (mt_attachment){.marks = mt_arena_new(job->arena, (size_t)marks, sizeof *made->marks),
                            .bases = mt_arena_new(job->arena, (size_t)bases, sizeof *made->bases)};
    if (!made->marks || !made->bases) return NULL;
    lookup->attachment_count++;
    return made;
}

static void add_mark(mt_attachment *made, uint16_t glyph, mt_anchor at) {
    made->marks[made->mark_count++] = (mt_anchored){glyph, 0, 1, at};
}

static void add_base(mt_attachment *made, const mt_row *row, mt_anchor at) {
    made->bases[made->base_count++] = (mt_anchored){row->glyph, row->component, row->component_count, at};
}

static int set_size(const uint64_t *set, int words) {
    int count = 0;
    for (int i = 0; i < words; i++) count += __builtin_popcountll(set[i]);
    return count;
}

/* ---- anchored by both ---------------------------------------------------------------------------------- */

/* Finds B's anchors of the rows for a class of a rival. */
static void find_rows(mt_anchor_job *job, const mt_attachment_table *rival, int mark_class,
                      mt_class_work *work) {
    memset(work->found, 0, (size_t)work->words * sizeof *work->found);
    for (int i = 0; i < work->row_count; i++) {
        const mt_row *row = &work->rows[i];
        uint32_t partner = mt_anchor_partner(job, row->glyph);
        if (partner == MT_NO_PARTNER || !is_in(work->has, i)) continue;
        int index = mt_coverage_find(rival->base_coverage, partner);
        if (mt_attachment_components(rival, index) == row->component_count &&
            mt_attachment_base(rival, index, row->component, mark_class, job->b->variations, &work->in_b[i]))
            put_in(work->found, i);
    }
}

/* Drops from the found rows those that every one of the marks has already, and gives the marks the others. */
static void cover(const mt_read_mark *marks, int count, mt_class_work *work) {
    for (int w = 0; w < work->words; w++) {
        uint64_t all = ~(uint64_t)0;
        for (int i = 0; i < count; i++) all &= covered_by(work, marks[i].place)[w];
        work->found[w] &= ~all;
        for (int i = 0; i < count; i++) covered_by(work, marks[i].place)[w] |= work->found[w];
    }
}

/* Marks that are of one class in both fonts, with the bases that both anchor for it. */
static mt_status add_mixed(mt_anchor_job *job, const mt_attachment_table *rival, const mt_read_mark *marks,
                           int count, mt_class_work *work, mt_anchor_lookup *lookup) {
    if (!mt_anchor_spend(job, work->row_count + (int64_t)count * work->words)) return MT_OK;
    find_rows(job, rival, marks->mark_class, work);
    cover(marks, count, work);
    int kept = set_size(work->found, work->words);
    if (kept == 0 || !mt_anchor_spend(job, MT_ANCHOR_KEPT_STEPS * (int64_t)(count + kept))) return MT_OK;
    mt_attachment *made = add_attachment(job, lookup, count, kept);
    if (!made) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++)
        add_mark(made, marks[i].glyph,
                 mt_anchor_mixed(job, work->marks[marks[i].place].point, marks[i].point));
    for (int i = 0; i < work->row_count; i++)
        if (is_in(work->found, i))
            add_base(made, &work->rows[i], mt_anchor_mixed(job, work->in_a[i], work->in_b[i]));
    return MT_OK;
}

static mt_status blend_rival(mt_anchor_job *job, mt_bytes subtable, mt_class_work *work,
                             mt_anchor_lookup *lookup) {
    mt_attachment_table rival;
    int count = 0;
    mt_status status = MT_OK;
    if (!mt_attachment_open(subtable, work->table->type, &rival)) return MT_OK;
    mt_read_mark *marks = mt_arena_new(&job->scratch, (size_t)work->mark_count, sizeof *marks);
    if (!marks) return MT_NO_MEMORY;
    for (int i = 0; i < work->mark_count; i++) {
        mt_read_mark *mark = &marks[count];
        uint32_t partner = mt_anchor_partner(job, work->marks[i].glyph);
        int index = partner == MT_NO_PARTNER ? -1 : mt_coverage_find(rival.mark_coverage, partner);
        *mark = (mt_read_mark){.glyph = work->marks[i].glyph, .place = i};
        if (mt_attachment_mark(&rival, index, job->b->variations, &mark->mark_class, &mark->point)) count++;
    }
    qsort(marks, (size_t)count, sizeof *marks, mt_read_mark_compare);
    for (int i = 0, end; i < count && status == MT_OK; i = end) {
        end = mt_class_end(marks, count, i);
        status = add_mixed(job, &rival, marks + i, end - i, work, lookup);
    }
    return status;
}

/* Whether the mark has rows in A that are not covered. */
static bool has_left(const mt_class_work *work, int mark) {
    const uint64_t *covered = covered_by(work, mark);
    for (int w = 0; w < work->words; w++)
        if (work->has[w] & ~covered[w]) return true;
    return false;
}

static int count_left(const mt_class_work *work) {
    int count = 0;
    for (int i = 0; i < work->mark_count; i++) count += has_left(work, i);
    return count;
}

/* Goes through B's subtables until all is covered. */
static mt_status blend_rivals(mt_anchor_job *job, mt_class_work *work, const mt_rivals *rivals,
                              mt_anchor_lookup *lookup) {
    int64_t steps = (int64_t)work->mark_count * (MARK_STEPS + work->words);
    mt_status status = MT_OK;
    for (int i = 0; i < rivals->count && status == MT_OK && mt_anchor_spend(job, steps); i++) {
        if (count_left(work) == 0) break;
        mt_arena_place place = mt_arena_mark(&job->scratch);
        status = blend_rival(job, rivals->subtables[i], work, lookup);
        mt_arena_rewind(&job->scratch, place);
    }
    return status;
}

/* ---- anchored by A alone ------------------------------------------------------------------------------- */

static mt_status moved(mt_anchor_job *job, uint16_t glyph, mt_anchor_point in_a, mt_anchor *at) {
    *at = mt_anchor_mixed(job, in_a, (mt_anchor_point){0, 0});
    return mt_outline_move(&job->moves, glyph, at->ends[0], &at->ends[1]);
}

/* Finds the rows that are not covered for some mark; returns how many. */
static int find_left(mt_class_work *work) {
    for (int w = 0; w < work->words; w++) {
        uint64_t left = 0;
        for (int i = 0; i < work->mark_count; i++) left |= work->has[w] & ~covered_by(work, i)[w];
        work->found[w] = left;
    }
    return set_size(work->found, work->words);
}

static mt_status add_rest(mt_anchor_job *job, mt_class_work *work, mt_anchor_lookup *lookup) {
    int count = count_left(work), kept = find_left(work);
    if (kept == 0 || !mt_anchor_spend(job, MT_ANCHOR_KEPT_STEPS * (int64_t)(count + kept))) return MT_OK;
    mt_attachment *made = add_attachment(job, lookup, count, kept);
    if (!made) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    mt_anchor at;
    for (int i = 0; i < work->mark_count && status == MT_OK; i++) {
        if (!has_left(work, i)) continue;
        status = moved(job, work->marks[i].glyph, work->marks[i].point, &at);
        add_mark(made, work->marks[i].glyph, at);
    }
    for (int i = 0; i < work->row_count && status == MT_OK; i++) {
        if (!is_in(work->found, i)) continue;
        status = moved(job, work->rows[i].glyph, work->in_a[i], &at);
        add_base(made, &work->rows[i], at);
    }
    return status;
}

/* ---- the whole class ----------------------------------------------------------------------------------- */

mt_status mt_class_blend(mt_anchor_job *job, mt_class_work *work, const mt_rivals *rivals,
                         mt_anchor_lookup *lookup) {
    size_t rows = (size_t)work->row_count, words = (size_t)work->words, marks = (size_t)work->mark_count;
    if (!mt_anchor_spend(job, (int64_t)(rows + 16 * marks * words))) return MT_OK;
    work->in_a = mt_arena_new(&job->scratch, rows, sizeof *work->in_a);
    work->in_b = mt_arena_new(&job->scratch, rows, sizeof *work->in_b);
    work->has = mt_arena_new(&job->scratch, words, sizeof *work->has);
    work->found = mt_arena_new(&job->scratch, words, sizeof *work->found);
    work->covered = mt_arena_new(&job->scratch, marks * words, sizeof *work->covered);
    if (!work->in_a || !work->in_b || !work->has || !work->found || !work->covered) return MT_NO_MEMORY;
    for (int i = 0; i < work->row_count; i++)
        if (mt_attachment_base(work->table, work->rows[i].index, work->rows[i].component,
                               work->marks->mark_class, job->a->variations, &work->in_a[i]))
            put_in(work->has, i);
    mt_status status = blend_rivals(job, work, rivals, lookup);
    return status == MT_OK ? add_rest(job, work, lookup) : status;
}
