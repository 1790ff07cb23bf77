/* One mark attachment subtable of A's, blended with what B has for the same marks and bases. */
#include "layout/anchor_class.h"

#include <stdlib.h>

/* More components of bases in a subtable are left out: the largest have some thousands. */
enum { ROWS_MAX = 1 << 18 };

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
        if (mt_attachment_mark(table, entries[i].index, job->a->variations, &mark->mark_class, &mark->point))
            read++;
    }
    qsort(made, (size_t)read, sizeof *made, mt_read_mark_compare);
    *marks = made;
    *count = read;
    return MT_OK;
}

/* A's bases, ascending, each with all its components. */
static mt_status read_rows(mt_anchor_job *job, const mt_attachment_table *table, mt_row **rows, int *count) {
    mt_entry *entries;
    int entry_count, all = 0, made_count = 0;
    mt_status status = mt_anchor_entries(job, table->base_coverage, &entries, &entry_count);
    if (status != MT_OK) return status;
    int64_t sum = 0;
    for (int i = 0; i < entry_count; i++) sum += mt_attachment_components(table, entries[i].index);
    if (sum <= ROWS_MAX && mt_anchor_spend(job, sum)) all = (int)sum;
    mt_row *made = mt_arena_new(&job->scratch, (size_t)all + 1, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    for (int i = 0; i < entry_count && made_count < all; i++) {
        int components = mt_attachment_components(table, entries[i].index);
        for (int c = 0; c < components; c++)
            made[made_count++] =
                (mt_row){entries[i].glyph, (uint16_t)c, (uint16_t)components, entries[i].index};
    }
    *rows = made;
    *count = made_count;
    return MT_OK;
}

mt_status mt_attachment_blend(mt_anchor_job *job, mt_bytes subtable, const mt_rivals *rivals,
                              mt_anchor_lookup *lookup) {
    mt_attachment_table table;
    mt_read_mark *marks;
    mt_row *rows;
    int mark_count, row_count;
    if (!mt_attachment_open(subtable, lookup->head.type, &table)) return MT_OK;
    mt_status status = read_marks(job, &table, &marks, &mark_count);
    if (status == MT_OK) status = read_rows(job, &table, &rows, &row_count);
    for (int i = 0, end; status == MT_OK && i < mark_count; i = end) {
        end = mt_class_end(marks, mark_count, i);
        mt_class_work work = {.table = &table,
                              .marks = marks + i,
                              .mark_count = end - i,
                              .rows = rows,
                              .row_count = row_count,
                              .words = (row_count + 63) / 64};
        mt_arena_place place = mt_arena_mark(&job->scratch);
        status = mt_class_blend(job, &work, rivals, lookup);
        mt_arena_rewind(&job->scratch, place);
    }
    return status;
}
