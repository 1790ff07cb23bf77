#include "anchors/write.h"

#include "anchors/write_cursive.h"
#include "anchors/write_marks.h"

static mt_status write_lookup(const mt_anchor_lookup *lookup, const mt_places *places, mt_arena *arena,
                              mt_lookup_builders *made) {
    mt_subtables subtables = {0};
    mt_status status = MT_OK;
    for (int i = 0; i < lookup->attachment_count && status == MT_OK; i++)
        status = mt_attachment_write(&lookup->attachments[i], lookup->head.type, places, arena, &subtables);
    for (int i = 0; i < lookup->cursive_count && status == MT_OK; i++)
        status = mt_cursive_write(&lookup->cursives[i], places, arena, &subtables);
    if (status != MT_OK || subtables.count == 0) return status;
    mt_lookup_builder head = lookup->head;
    head.subtable_count = subtables.count;
    head.subtables = subtables.list;
    return mt_lookup_builders_add(made, &head, arena);
}

mt_status mt_anchors_write(const mt_anchors *anchors, const mt_places *places, mt_arena *arena,
                           mt_lookup_builders *made) {
    mt_status status = MT_OK;
    for (int i = 0; i < anchors->count && status == MT_OK; i++)
        status = write_lookup(&anchors->lookups[i], places, arena, made);
    return status;
}
