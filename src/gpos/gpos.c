#include "gpos/gpos.h"

/* ---- lookups ------------------------------------------------------------------------------------------- */

enum { LOOKUP_HEADER = 6, EXTENSION_SIZE = 8 };

static size_t lookup_size(const mt_lookup_builder *lookup) {
    return LOOKUP_HEADER + 2 * (size_t)lookup->subtable_count + (lookup->mark_set >= 0 ? 2 : 0);
}

static size_t subtables_size(const mt_lookup_builder *lookup) {
    size_t size = 0;
    for (int i = 0; i < lookup->subtable_count; i++) size += lookup->subtables[i].length;
    return size;
}

/* The header, with the offsets of its subtables (or of their extension records) from `start` on; returns where the next
 * begins. */
static size_t write_lookup(const mt_lookup_builder *lookup, bool extended, size_t start, mt_table *table) {
    size_t at = table->length;
    mt_table_16(table, extended ? MT_EXTENSION_GPOS : lookup->type);
    int flag = lookup->flag & ~MT_LOOKUP_MARK_SET;
    mt_table_16(table, lookup->mark_set >= 0 ? flag | MT_LOOKUP_MARK_SET : flag);
    mt_table_16(table, lookup->subtable_count);
    for (int i = 0; i < lookup->subtable_count; i++) {
        mt_table_16(table, (int)(start - at));
        start += extended ? EXTENSION_SIZE : lookup->subtables[i].length;
    }
    if (lookup->mark_set >= 0) mt_table_16(table, lookup->mark_set);
    return start;
}

/* Extension records for all subtables, which follow them in the same order. */
static void write_extensions(const mt_lookup_builders *lookups, int subtable_count, mt_table *table) {
    size_t at = table->length, subtable = at + EXTENSION_SIZE * (size_t)subtable_count;
    for (int i = 0; i < lookups->count; i++)
        for (int k = 0; k < lookups->lookups[i].subtable_count; k++) {
            mt_table_16(table, 1);
            mt_table_16(table, lookups->lookups[i].type);
            mt_table_32(table, (uint32_t)(subtable - at));
            at += EXTENSION_SIZE;
            subtable += lookups->lookups[i].subtables[k].length;
        }
}

mt_status mt_gpos_lookup_list(const mt_lookup_builders *lookups, mt_table *table) {
    size_t at = 2 + 2 * (size_t)lookups->count, heads = at, subtables = 0;
    int subtable_count = 0;
    for (int i = 0; i < lookups->count; i++) {
        heads += lookup_size(&lookups->lookups[i]);
        subtables += subtables_size(&lookups->lookups[i]);
        subtable_count += lookups->lookups[i].subtable_count;
    }
    bool extended = heads + subtables > UINT16_MAX;
    if (extended && heads + EXTENSION_SIZE * (size_t)subtable_count > UINT16_MAX) return MT_TOO_LARGE;
    if (subtables > INT32_MAX) return MT_TOO_LARGE;
    mt_table_16(table, lookups->count);
    for (int i = 0; i < lookups->count; i++) {
        mt_table_16(table, (int)at);
        at += lookup_size(&lookups->lookups[i]);
    }
    size_t start = heads;
    for (int i = 0; i < lookups->count; i++)
        start = write_lookup(&lookups->lookups[i], extended, start, table);
    if (extended) write_extensions(lookups, subtable_count, table);
    for (int i = 0; i < lookups->count; i++)
        for (int k = 0; k < lookups->lookups[i].subtable_count; k++)
            mt_table_bytes(table, lookups->lookups[i].subtables[k].bytes,
                           lookups->lookups[i].subtables[k].length);
    return MT_OK;
}

/* ---- the table ----------------------------------------------------------------------------------------- */

/* The lookups that are written, in the order in which they are applied. */
static mt_status order_lookups(const mt_lookup_builders *made, mt_arena *scratch, mt_lookup_builders *kept) {
    for (int i = 0; i < made->count; i++) {
        const mt_lookup_builder *lookup = &made->lookups[i];
        if (!lookup->member_count || !lookup->subtable_count) continue;
        mt_status status = mt_lookup_builders_add(kept, lookup, scratch);
        if (status != MT_OK) return status;
        int at = kept->count - 1;
        for (; at > 0 && kept->lookups[at - 1].order > lookup->order; at--)
            kept->lookups[at] = kept->lookups[at - 1];
        kept->lookups[at] = *lookup;
    }
    return MT_OK;
}

static mt_status assemble(const mt_systems *systems, const mt_lookup_builders *kept, mt_arena *scratch,
                          mt_table lists[3]) {
    mt_gpos_feature *features;
    int count;
    mt_status status = mt_gpos_features(kept, scratch, &features, &count);
    if (status == MT_OK) status = mt_gpos_script_list(systems, features, count, scratch, &lists[0]);
    if (status == MT_OK) status = mt_gpos_feature_list(features, count, &lists[1]);
    return status == MT_OK ? mt_gpos_lookup_list(kept, &lists[2]) : status;
}

static mt_status join(const mt_table lists[3], mt_arena *arena, mt_bytes *gpos) {
    enum { HEADER = 10 };
    mt_table table = {0};
    size_t at = HEADER;
    if (HEADER + lists[0].length + lists[1].length > UINT16_MAX) return MT_TOO_LARGE;
    mt_table_32(&table, 0x00010000);
    for (int i = 0; i < 3; i++) {
        mt_table_16(&table, (int)at);
        at += lists[i].length;
    }
    for (int i = 0; i < 3; i++) {
        mt_table_bytes(&table, lists[i].bytes, lists[i].length);
        table.failed |= lists[i].failed;
    }
    return mt_table_keep(&table, arena, gpos);
}

mt_status mt_gpos_write(const mt_systems *systems, const mt_lookup_builders *made, mt_arena *arena,
                        mt_bytes *gpos) {
    mt_arena scratch = {0};
    mt_lookup_builders kept = {0};
    mt_table lists[3] = {0};
    mt_bytes written = {0};
    mt_status status = order_lookups(made, &scratch, &kept);
    if (status == MT_OK && kept.count) {
        status = assemble(systems, &kept, &scratch, lists);
        if (status == MT_OK) status = join(lists, arena, &written);
    }
    for (int i = 0; i < 3; i++) mt_table_free(&lists[i]);
    mt_arena_release(&scratch);
    if (status == MT_OK) *gpos = written;
    return status;
}
