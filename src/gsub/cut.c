/* GSUB without the substitutions that lead to glyphs that are not kept: HarfBuzz's subsetter would bring these back.
 *
 * The new table is a header, a list of lookups that are all extensions, behind it the old table, and behind that the
 * subtables written anew. Contexts stay where they are in the old table: the subsetter prunes their glyphs. No byte of
 * the old table is changed, so that it does not matter which parts of it share bytes. */
#include "gsub/gsub.h"

#include "layout/lookup_builder.h"

enum { HEADER = 10, EXTENSION = 8 };

static bool all_kept(const uint16_t *glyphs, int count, const bool *kept) {
    for (int i = 0; i < count; i++)
        if (!kept[glyphs[i]]) return false;
    return true;
}

/* Alternates are asked for by number: in the place of one that is not kept stands the glyph itself. */
static bool cut_alternates(const mt_substitution *from, const bool *kept, mt_arena *arena,
                           mt_substitution *to) {
    int count = from->outputs;
    while (count > 0 && !kept[from->glyphs[count]]) count--;
    uint16_t *glyphs = mt_arena_new(arena, (size_t)count + 1, sizeof *glyphs);
    if (!glyphs) return false;
    for (int i = 0; i <= count; i++) glyphs[i] = from->glyphs[kept[from->glyphs[i]] ? i : 0];
    *to = (mt_substitution){glyphs, 1, (uint16_t)count};
    return true;
}

static mt_status cut_subtable(mt_gsub_parts *parts, int type, const mt_gsub_subtable *subtable,
                              const bool *kept) {
    mt_substitution *list = mt_arena_new(parts->arena, (size_t)subtable->count + 1, sizeof *list);
    int count = 0;
    if (!list) return MT_NO_MEMORY;
    for (int i = 0; i < subtable->count; i++) {
        const mt_substitution *from = &subtable->list[i];
        if (!all_kept(from->glyphs, from->inputs, kept)) continue;
        if (type == MT_GSUB_ALTERNATE) {
            if (!cut_alternates(from, kept, parts->arena, &list[count])) return MT_NO_MEMORY;
            count += list[count].outputs > 0;
        } else if (all_kept(from->glyphs + from->inputs, from->outputs, kept)) {
            list[count++] = *from;
        }
    }
    return mt_gsub_write(parts, type, subtable->table, list, count);
}

/* Adds the lookup's parts; gives how many. */
static mt_status cut_lookup(mt_gsub_parts *parts, const mt_gsub *gsub, const mt_gsub_lookup *lookup,
                            const bool *kept, int *count) {
    bool context = lookup->type == MT_GSUB_CONTEXT || lookup->type == MT_GSUB_CHAIN;
    int before = parts->count;
    mt_status status = MT_OK;
    for (int i = 0; i < lookup->subtable_count && status == MT_OK; i++) {
        const mt_gsub_subtable *subtable = &lookup->subtables[i];
        if (!context)
            status = cut_subtable(parts, lookup->type, subtable, kept);
        else if (subtable->table.length)
            status = mt_gsub_add_part(parts, (size_t)(subtable->table.bytes - gsub->table.bytes), true);
    }
    *count = parts->count - before;
    return status;
}

/* ---- the table ----------------------------------------------------------------------------------------- */

static size_t lookup_length(const mt_gsub_lookup *lookup, int parts) {
    return 6 + (lookup->mark_set >= 0 ? 2u : 0u) + (2 + EXTENSION) * (size_t)parts;
}

/* A lookup with the records that lead to its parts: `count` of them, `from` the first. */
static void write_lookup(mt_table *table, const mt_gsub_lookup *lookup, const mt_gsub_parts *parts, int from,
                         int count, size_t old_start, size_t new_start) {
    size_t first = lookup_length(lookup, count) - EXTENSION * (size_t)count;
    mt_table_16(table, count ? MT_EXTENSION_GSUB : lookup->type);
    mt_table_16(table, lookup->flag);
    mt_table_16(table, count);
    for (int i = 0; i < count; i++) mt_table_16(table, (int)(first + EXTENSION * (size_t)i));
    if (lookup->mark_set >= 0) mt_table_16(table, lookup->mark_set);
    for (int i = 0; i < count; i++) {
        const mt_gsub_part *part = &parts->list[from + i];
        size_t to = part->at + (part->is_old ? old_start : new_start);
        mt_table_16(table, 1);
        mt_table_16(table, lookup->type);
        mt_table_32(table, (uint32_t)(to - (table->length - 4)));
    }
}

/* The header and the lookups; false when their offsets would not do. */
static bool write_lookups(mt_table *table, const mt_gsub *gsub, const mt_gsub_parts *parts,
                          const int *counts) {
    int all = gsub->layout.lookup_count;
    size_t list = 2 + 2 * (size_t)all, length = list;
    for (int i = 0; i < all; i++) length += lookup_length(&gsub->lookups[i], counts[i]);
    size_t old_start = HEADER + length, new_start = old_start + gsub->table.length;
    size_t scripts = old_start + mt_ot_u16(gsub->table, 4), features = old_start + mt_ot_u16(gsub->table, 6);
    if (length > UINT16_MAX || scripts > UINT16_MAX || features > UINT16_MAX) return false;
    mt_table_32(table, 0x00010000);
    mt_table_16(table, (int)scripts);
    mt_table_16(table, (int)features);
    mt_table_16(table, HEADER);
    mt_table_16(table, all);
    for (int i = 0; i < all; i++) {
        mt_table_16(table, (int)list);
        list += lookup_length(&gsub->lookups[i], counts[i]);
    }
    for (int i = 0, from = 0; i < all; from += counts[i++])
        write_lookup(table, &gsub->lookups[i], parts, from, counts[i], old_start, new_start);
    return true;
}

static mt_status put_together(const mt_gsub *gsub, const mt_gsub_parts *parts, const int *counts,
                              mt_arena *arena, mt_bytes *cut) {
    mt_table table = {0};
    *cut = (mt_bytes){0};
    if (parts->bytes.failed) return MT_NO_MEMORY;
    if (!write_lookups(&table, gsub, parts, counts)) return MT_OK;
    mt_table_bytes(&table, gsub->table.bytes, gsub->table.length);
    mt_table_bytes(&table, parts->bytes.bytes, parts->bytes.length);
    return mt_table_keep(&table, arena, cut);
}

mt_status mt_gsub_cut(const mt_gsub *gsub, const bool *kept, mt_arena *arena, mt_bytes *cut) {
    int count = gsub->layout.lookup_count;
    mt_gsub_parts parts = {.arena = arena};
    int *counts = mt_arena_new(arena, (size_t)count + 1, sizeof *counts);
    mt_status status = counts ? MT_OK : MT_NO_MEMORY;
    *cut = (mt_bytes){0};
    for (int i = 0; i < count && status == MT_OK; i++)
        status = cut_lookup(&parts, gsub, &gsub->lookups[i], kept, &counts[i]);
    if (status == MT_OK && count > 0) status = put_together(gsub, &parts, counts, arena, cut);
    mt_table_free(&parts.bytes);
    return status;
}
