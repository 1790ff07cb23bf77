/* A report has each pair of glyphs once, under one of its characters; here it is found by any of them. */
#include "source/font.h"
#include "specimen/specimen.h"

#include <stdlib.h>

typedef struct mt_flag_row {
    uint32_t a, b; /* the two fonts' glyphs */
    const mt_report_glyph *glyph;
} mt_flag_row;

struct mt_specimen_flags {
    const mt_report *report;
    int count;
    mt_flag_row *rows; /* by their glyphs */
};

static mt_flag_row row_of(const mt_report *report, uint32_t code_point, const mt_report_glyph *glyph) {
    return (mt_flag_row){mt_font_glyph(report->request.a, code_point),
                         mt_font_glyph(report->request.b, code_point), glyph};
}

static int compare(const void *p, const void *q) {
    const mt_flag_row *x = p, *y = q;
    if (x->a != y->a) return x->a < y->a ? -1 : 1;
    return (x->b > y->b) - (x->b < y->b);
}

mt_status mt_specimen_flags_make(const mt_report *report, mt_arena *arena, const mt_specimen_flags **flags) {
    int count = report->summary.flagged; /* they stand before the others */
    mt_specimen_flags *made = mt_arena_new(arena, 1, sizeof *made);
    mt_flag_row *rows = mt_arena_new(arena, (size_t)count + 1, sizeof *rows);
    if (!made || !rows) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++)
        rows[i] = row_of(report, report->glyphs[i].code_point, &report->glyphs[i]);
    qsort(rows, (size_t)count, sizeof *rows, compare);
    *made = (mt_specimen_flags){report, count, rows};
    *flags = made;
    return MT_OK;
}

const mt_report_glyph *mt_specimen_flags_find(const mt_specimen_flags *flags, uint32_t code_point) {
    mt_flag_row key = row_of(flags->report, code_point, NULL);
    const mt_flag_row *row = bsearch(&key, flags->rows, (size_t)flags->count, sizeof key, compare);
    return row ? row->glyph : NULL;
}
