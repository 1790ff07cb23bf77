#include "layout/lookup_builder.h"

#include <string.h>

/* ---- sets and classes of glyphs ------------------------------------------------------------------------ */

/* The end of the run from `i` on whose glyphs follow one another (and, with `classes`, share a class). */
static int coverage_run(const uint16_t *glyphs, int count, int i) {
    int end = i + 1;
    while (end < count && glyphs[end] == glyphs[end - 1] + 1) end++;
    return end;
}

void mt_table_coverage(mt_table *table, const uint16_t *glyphs, int count) {
    int runs = 0;
    for (int i = 0; i < count; i = coverage_run(glyphs, count, i)) runs++;
    bool ranges = 3 * runs < count;
    mt_table_16(table, ranges ? 2 : 1);
    mt_table_16(table, ranges ? runs : count);
    for (int i = 0, end; i < count; i = end) {
        end = ranges ? coverage_run(glyphs, count, i) : i + 1;
        mt_table_16(table, glyphs[i]);
        if (!ranges) continue;
        mt_table_16(table, glyphs[end - 1]);
        mt_table_16(table, i);
    }
}

static int class_run(const mt_glyph_class *glyphs, int count, int i) {
    int end = i + 1;
    while (end < count && glyphs[end].glyph == glyphs[end - 1].glyph + 1 &&
           glyphs[end].class == glyphs[i].class)
        end++;
    return end;
}

static void write_class_ranges(mt_table *table, const mt_glyph_class *glyphs, int count, int runs) {
    mt_table_16(table, 2);
    mt_table_16(table, runs);
    for (int i = 0, end; i < count; i = end) {
        end = class_run(glyphs, count, i);
        if (!glyphs[i].class) continue;
        mt_table_16(table, glyphs[i].glyph);
        mt_table_16(table, glyphs[end - 1].glyph);
        mt_table_16(table, glyphs[i].class);
    }
}

void mt_table_classes(mt_table *table, const mt_glyph_class *glyphs, int count) {
    int runs = 0;
    for (int i = 0; i < count; i = class_run(glyphs, count, i)) runs += glyphs[i].class != 0;
    int span = count ? glyphs[count - 1].glyph - glyphs[0].glyph + 1 : 0;
    if (3 * runs <= span + 1) {
        write_class_ranges(table, glyphs, count, runs);
        return;
    }
    mt_table_16(table, 1);
    mt_table_16(table, glyphs[0].glyph);
    mt_table_16(table, span);
    for (int i = 0, at = 0; at < span; at++) {
        bool here = glyphs[i].glyph == glyphs[0].glyph + at;
        mt_table_16(table, here ? glyphs[i].class : 0);
        i += here;
    }
}

mt_status mt_table_keep(mt_table *table, mt_arena *arena, mt_bytes *bytes) {
    uint8_t *kept = table->failed ? NULL : mt_arena_new(arena, table->length + 1, 1);
    if (kept && table->length) memcpy(kept, table->bytes, table->length);
    size_t length = table->length;
    mt_table_free(table);
    if (!kept) return MT_NO_MEMORY;
    *bytes = (mt_bytes){kept, length};
    return MT_OK;
}

mt_status mt_subtables_add(mt_table *table, mt_arena *arena, mt_subtables *subtables) {
    mt_bytes kept;
    mt_status status = mt_table_keep(table, arena, &kept);
    if (status != MT_OK) return status;
    mt_bytes *grown =
        mt_arena_grow_list(arena, subtables->list, subtables->count, &subtables->room, sizeof *grown);
    if (!grown) return MT_NO_MEMORY;
    subtables->list = grown;
    subtables->list[subtables->count++] = kept;
    return MT_OK;
}

/* ---- lookups ------------------------------------------------------------------------------------------- */

/* Counts only where `members` is NULL. */
static int list_members(const mt_layout *layout, const bool *has, mt_member *members) {
    int count = 0;
    for (int s = 0; s < layout->system_count; s++) {
        const mt_system *system = &layout->systems[s];
        for (int i = 0; i <= system->feature_count; i++) {
            int feature = mt_system_feature(layout, system, i);
            if (feature < 0 || !has[feature]) continue;
            if (members) members[count] = (mt_member){s, mt_feature_tag(layout, feature)};
            count++;
        }
    }
    return count;
}

mt_status mt_members_of(const mt_layout *layout, int lookup, mt_arena *arena, mt_member **members,
                        int *count) {
    bool *has = mt_arena_new(arena, (size_t)layout->feature_count + 1, sizeof *has);
    if (!has) return MT_NO_MEMORY;
    for (int i = 0; i < layout->feature_count; i++) has[i] = mt_feature_has(layout, i, lookup);
    int all = list_members(layout, has, NULL);
    mt_member *made = mt_arena_new(arena, (size_t)all + 1, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    *count = list_members(layout, has, made);
    *members = made;
    return MT_OK;
}

mt_status mt_lookup_builders_add(mt_lookup_builders *made, const mt_lookup_builder *lookup, mt_arena *arena) {
    mt_lookup_builder *grown =
        mt_arena_grow_list(arena, made->lookups, made->count, &made->room, sizeof *grown);
    if (!grown) return MT_NO_MEMORY;
    made->lookups = grown;
    made->lookups[made->count++] = *lookup;
    return MT_OK;
}
