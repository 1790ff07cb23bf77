#include "gpos/gpos.h"

#include "gpos/context.h"

#include <string.h>

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

/* Whether features or contexts apply the lookup. One that contexts call may be without subtables, where each was too
 * large. */
static bool is_applied(const mt_lookup_builder *lookup) {
    return lookup->subtable_count ? lookup->member_count || lookup->called_as
                                  : lookup->called_as && lookup->type >= MT_CONTEXT;
}

/* The lookups that are written, in the order in which they are applied; none where no feature has any. */
static mt_status order_lookups(const mt_lookup_builders *made, mt_arena *scratch, mt_lookup_builders *kept) {
    bool any = false;
    for (int i = 0; i < made->count; i++) {
        const mt_lookup_builder *lookup = &made->lookups[i];
        if (!is_applied(lookup)) continue;
        mt_status status = mt_lookup_builders_add(kept, lookup, scratch);
        if (status != MT_OK) return status;
        any |= lookup->member_count > 0;
        int at = kept->count - 1;
        for (; at > 0 && kept->lookups[at - 1].order > lookup->order; at--)
            kept->lookups[at] = kept->lookups[at - 1];
        kept->lookups[at] = *lookup;
    }
    if (!any) kept->count = 0;
    return MT_OK;
}

/* The number that a called lookup has got. */
static int find_called(const mt_lookup_builders *kept, int called_as) {
    int found = 0;
    while (found < kept->count && kept->lookups[found].called_as != called_as) found++;
    return found;
}

/* Fills in the numbers of the lookups that a context calls. */
static mt_status number_calls(const mt_lookup_builders *kept, mt_lookup_builder *lookup, mt_arena *scratch) {
    mt_bytes *subtables = mt_arena_new(scratch, (size_t)lookup->subtable_count + 1, sizeof *subtables);
    if (!subtables) return MT_NO_MEMORY;
    for (int i = 0, k = 0; i < lookup->subtable_count; i++) {
        mt_bytes from = lookup->subtables[i];
        uint8_t *bytes = mt_arena_new(scratch, from.length + 1, 1);
        if (!bytes) return MT_NO_MEMORY;
        memcpy(bytes, from.bytes, from.length);
        for (; k < lookup->call_count && lookup->calls[k].subtable == i; k++) {
            int number = find_called(kept, lookup->calls[k].called_as);
            bytes[lookup->calls[k].at] = (uint8_t)(number >> 8);
            bytes[lookup->calls[k].at + 1] = (uint8_t)number;
        }
        subtables[i] = (mt_bytes){bytes, from.length};
    }
    lookup->subtables = subtables;
    return MT_OK;
}

static mt_status number_all_calls(mt_lookup_builders *kept, mt_arena *scratch) {
    mt_status status = MT_OK;
    for (int i = 0; i < kept->count && status == MT_OK; i++)
        if (kept->lookups[i].call_count) status = number_calls(kept, &kept->lookups[i], scratch);
    return status;
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
    if (status == MT_OK) status = number_all_calls(&kept, &scratch);
    if (status == MT_OK && kept.count) {
        status = assemble(systems, &kept, &scratch, lists);
        if (status == MT_OK) status = join(lists, arena, &written);
    }
    for (int i = 0; i < 3; i++) mt_table_free(&lists[i]);
    mt_arena_release(&scratch);
    if (status == MT_OK) *gpos = written;
    return status;
}
