/* Anchors, static or varying, as GPOS subtables (OpenType spec, "GPOS": lookup types 3 to 6), in parts where 16-bit
 * offsets would not reach. */
#ifndef MT_ANCHORS_WRITE_H
#define MT_ANCHORS_WRITE_H

#include "anchors/anchor.h"
#include "sfnt/sfnt.h"

/* A list of subtables that grows in an arena; all zero is empty. */
typedef struct mt_subtables {
    int count, room;
    mt_bytes *list;
} mt_subtables;

/* anchor_write.c. Moves what was written into the arena and the list; the table is empty then. MT_NO_MEMORY. */
mt_status mt_subtables_add(mt_table *table, mt_arena *arena, mt_subtables *subtables);

/* anchor_write_marks.c, anchor_write_cursive.c: add the subtables of one. MT_NO_MEMORY,
 * MT_TOO_LARGE. */
mt_status mt_attachment_write(const mt_attachment *attachment, int type, const mt_places *places,
                              mt_arena *arena, mt_subtables *subtables);
mt_status mt_cursive_write(const mt_cursive *cursive, const mt_places *places, mt_arena *arena,
                           mt_subtables *subtables);

#endif
