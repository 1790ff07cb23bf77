#include "kerning/write.h"

#include <string.h>

mt_status mt_pair_writer_add(mt_pair_writer *writer, mt_table *table) {
    if (writer->count == writer->room) {
        int room = writer->room ? 2 * writer->room : 8;
        mt_bytes *grown = mt_arena_new(writer->arena, (size_t)room, sizeof *grown);
        if (!grown) table->failed = true;
        if (grown && writer->count) memcpy(grown, writer->subtables, (size_t)writer->count * sizeof *grown);
        if (grown) writer->subtables = grown;
        if (grown) writer->room = room;
    }
    mt_bytes bytes;
    mt_status status = mt_table_keep(table, writer->arena, &bytes);
    if (status == MT_OK) writer->subtables[writer->count++] = bytes;
    return status;
}

void mt_pair_write_header(mt_table *table, int format, size_t coverage, mt_value_format values) {
    mt_table_16(table, format);
    mt_table_16(table, (int)coverage);
    mt_table_16(table, mt_value_format_field(values, 0));
    mt_table_16(table, mt_value_format_field(values, MT_VALUE_PARTS));
}

mt_status mt_pairs_write(const mt_mixed_pairs *mixed, mt_var_store *store, mt_arena *arena,
                         mt_bytes **subtables, int *count) {
    mt_pair_writer writer = {.mixed = mixed, .store = store, .arena = arena};
    mt_status status = mt_pair_write_list(&writer);
    if (status == MT_OK) status = mt_pair_write_matrix(&writer);
    if (status != MT_OK) return status;
    *subtables = writer.subtables;
    *count = writer.count;
    return MT_OK;
}
