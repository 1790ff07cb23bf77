#include "anchors/write.h"

#include <string.h>

mt_status mt_subtables_add(mt_table *table, mt_arena *arena, mt_subtables *subtables) {
    mt_bytes kept;
    mt_status status = mt_table_keep(table, arena, &kept);
    if (status != MT_OK) return status;
    if (subtables->count == subtables->room) {
        int room = subtables->room ? 2 * subtables->room : 8;
        mt_bytes *grown = mt_arena_new(arena, (size_t)room, sizeof *grown);
        if (!grown) return MT_NO_MEMORY;
        if (subtables->list) memcpy(grown, subtables->list, (size_t)subtables->count * sizeof *grown);
        subtables->list = grown;
        subtables->room = room;
    }
    subtables->list[subtables->count++] = kept;
    return MT_OK;
}

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
