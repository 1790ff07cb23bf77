/* One class of A's marks at work, as it is divided by what another font has for it. */
#pragma once

#include "anchors/rivals.h"

/* A mark with its class and anchor in one of the fonts. */
typedef struct mt_read_mark {
    uint16_t glyph;
    int mark_class, place; /* place: in the attachment at work */
    mt_anchor_point point;
} mt_read_mark;

/* By class, then glyph; for qsort. */
int mt_read_mark_compare(const void *p, const void *q);
/* The end of the run of one class that starts at `start`. */
int mt_class_end(const mt_read_mark *marks, int count, int start);

/* Divides marks of one class and their bases, anchored in the fonts before `font`, by the font's classes, and adds
 * what comes of it to the lookup: its type is the lookup's, and all pairs of its marks and bases are in it, in one or
 * more of the attachments. MT_NO_MEMORY. */
mt_status mt_class_divide(mt_anchor_job *job, int font, const mt_attachment *from, const mt_rivals *rivals,
                          mt_anchor_lookup *lookup);
