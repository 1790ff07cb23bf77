/* One class of A's marks at work: what becomes of a part of a subtable (anchor_class.c; anchor_blend.c reads
 * the parts). */
#ifndef MT_ANCHOR_CLASS_H
#define MT_ANCHOR_CLASS_H

#include "layout/anchor_job.h"

/* A mark with its class and anchor in one of the fonts. */
typedef struct mt_read_mark {
    uint16_t glyph;
    int mark_class, place; /* place: of A's mark of this glyph, in the class at work */
    mt_anchor_point point;
} mt_read_mark;

/* A base's component; `index` is the base's place in A's coverage. */
typedef struct mt_row {
    uint16_t glyph, component, component_count;
    int index;
} mt_row;

/* Sets of rows are bit sets of `words` words. */
typedef struct mt_class_work {
    const mt_attachment_table *table;
    const mt_read_mark *marks; /* of the class, ascending */
    int mark_count;
    const mt_row *rows;
    int row_count, words;
    mt_anchor_point *in_a, *in_b; /* for each row; B's of the rival at work */
    uint64_t *has;                /* the rows with an anchor in A */
    uint64_t *covered;            /* for each mark, the rows that both fonts' anchors are kept for */
    uint64_t *found;              /* scratch */
} mt_class_work;

/* By class, then glyph; for qsort. */
int mt_read_mark_compare(const void *p, const void *q);
/* The end of the run of one class that starts at `start`. */
int mt_class_end(const mt_read_mark *marks, int count, int start);

/* Adds the subtables for a class to the lookup; the work has its table, marks and rows. MT_NO_MEMORY. */
mt_status mt_class_blend(mt_anchor_job *job, mt_class_work *work, const mt_rivals *rivals,
                         mt_anchor_lookup *lookup);

#endif
