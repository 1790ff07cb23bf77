/* One mark attachment subtable of A's, blended with what the other fonts have for the same marks and bases. */
#include "anchors/blend.h"

#include <stdlib.h>

#include "anchors/class.h"

/* More components of bases in a subtable are left out: the largest have some thousands. */
enum { ROWS_MAX = 1 << 18 };

/* A base's component; `index` is the base's place in A's coverage. */
typedef struct mt_anchor_row {
    uint16_t glyph, component, component_count;
    int index;
} mt_anchor_row;

/* A's marks, by class, then ascending. */
static mt_status read_marks(mt_anchor_job *job, const mt_attachment_table *table, mt_read_mark **marks,
                            int *count) {
    mt_entry *entries;
    int entry_count, read = 0;
    mt_status status = mt_anchor_entries(job, table->mark_coverage, &entries, &entry_count);
    if (status != MT_OK) return status;
    mt_read_mark *made = mt_arena_new(&job->scratch, (size_t)entry_count + 1, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    for (int i = 0; i < entry_count; i++) {
        mt_read_mark *mark = &made[read];
        mark->glyph = entries[i].glyph;
        if (mt_attachment_mark(table, entries[i].index, job->sources[0].variations, &mark->mark_class,
                               &mark->point))
            read++;
    }
    qsort(made, (size_t)read, sizeof *made, mt_read_mark_compare);
    *marks = made;
    *count = read;
    return MT_OK;
}

/* A's bases, ascending, each with all its components. */
static mt_status read_rows(mt_anchor_job *job, const mt_attachment_table *table, mt_anchor_row **rows,
                           int *count) {
    mt_entry *entries;
    int entry_count, all = 0, made_count = 0;
    mt_status status = mt_anchor_entries(job, table->base_coverage, &entries, &entry_count);
    if (status != MT_OK) return status;
    int64_t sum = 0;
    for (int i = 0; i < entry_count; i++) sum += mt_attachment_components(table, entries[i].index);
    if (sum <= ROWS_MAX && mt_anchor_spend(job, sum)) all = (int)sum;
    mt_anchor_row *made = mt_arena_new(&job->scratch, (size_t)all + 1, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    for (int i = 0; i < entry_count && made_count < all; i++) {
        int components = mt_attachment_components(table, entries[i].index);
        for (int c = 0; c < components; c++)
            made[made_count++] =
                (mt_anchor_row){entries[i].glyph, (uint16_t)c, (uint16_t)components, entries[i].index};
    }
    *rows = made;
    *count = made_count;
    return MT_OK;
}

/* A mark or a base with its place in A. */
static mt_status anchor(mt_anchor_job *job, mt_anchor_point point, mt_anchored *made) {
    made->at = mt_anchor_new(job, (mt_anchor){NULL}, 0, &job->scratch);
    if (!made->at.in_fonts) return MT_NO_MEMORY;
    made->at.in_fonts[0] = mt_anchor_scaled(job, 0, point);
    return MT_OK;
}

static mt_status add_marks(mt_anchor_job *job, const mt_read_mark *marks, int count, mt_attachment *made) {
    mt_status status = MT_OK;
    made->marks = mt_arena_new(&job->scratch, (size_t)count, sizeof *made->marks);
    if (!made->marks) return MT_NO_MEMORY;
    for (int i = 0; i < count && status == MT_OK; i++) {
        mt_anchored *mark = &made->marks[made->mark_count++];
        *mark = (mt_anchored){.glyph = marks[i].glyph, .component_count = 1};
        status = anchor(job, marks[i].point, mark);
    }
    return status;
}

/* The rows that A has an anchor of for the class. */
static mt_status add_bases(mt_anchor_job *job, const mt_attachment_table *table, const mt_anchor_row *rows,
                           int count, int mark_class, mt_attachment *made) {
    mt_status status = MT_OK;
    made->bases = mt_arena_new(&job->scratch, (size_t)count + 1, sizeof *made->bases);
    if (!made->bases) return MT_NO_MEMORY;
    for (int i = 0; i < count && status == MT_OK; i++) {
        mt_anchor_point point;
        if (!mt_attachment_base(table, rows[i].index, rows[i].component, mark_class,
                                job->sources[0].variations, &point))
            continue;
        mt_anchored *base = &made->bases[made->base_count++];
        *base = (mt_anchored){rows[i].glyph, rows[i].component, rows[i].component_count, {NULL}};
        status = anchor(job, point, base);
    }
    return status;
}

/* Divides a class of A's by the second font, what comes of it by the third, and so on. */
static mt_status blend_class(mt_anchor_job *job, mt_attachment *in_a, const mt_rivals *rivals,
                             mt_anchor_lookup *lookup) {
    int last = job->glyphs->font_count - 1;
    mt_anchor_lookup done = {.attachment_count = in_a->base_count > 0, .attachments = in_a};
    mt_status status = MT_OK;
    for (int k = 1; k <= last; k++) {
        mt_anchor_lookup next = {.head = lookup->head};
        for (int i = 0; i < done.attachment_count && status == MT_OK; i++)
            status = mt_class_divide(job, k, &done.attachments[i], &rivals[k], k == last ? lookup : &next);
        done = next;
    }
    return status;
}

mt_status mt_attachment_blend(mt_anchor_job *job, mt_bytes subtable, const mt_rivals *rivals,
                              mt_anchor_lookup *lookup) {
    mt_attachment_table table;
    mt_read_mark *marks;
    mt_anchor_row *rows;
    int mark_count, row_count;
    if (!mt_attachment_open(subtable, lookup->head.type, &table)) return MT_OK;
    mt_status status = read_marks(job, &table, &marks, &mark_count);
    if (status == MT_OK) status = read_rows(job, &table, &rows, &row_count);
    for (int i = 0, end; status == MT_OK && i < mark_count; i = end) {
        mt_attachment in_a = {0};
        mt_arena_place place = mt_arena_mark(&job->scratch);
        end = mt_class_end(marks, mark_count, i);
        if (!mt_anchor_spend(job, row_count)) return MT_OK;
        status = add_marks(job, marks + i, end - i, &in_a);
        if (status == MT_OK) status = add_bases(job, &table, rows, row_count, marks[i].mark_class, &in_a);
        if (status == MT_OK) status = blend_class(job, &in_a, rivals, lookup);
        mt_arena_rewind(&job->scratch, place);
    }
    return status;
}
