#include "gsub/gsub.h"

#include "layout/at_place.h"
#include "layout/calls.h"
#include "layout/open.h"

#include "geometry/limits.h"
#include "sfnt/sfnt.h"

static mt_status read_lookup(mt_gsub_reader *reader, const mt_lookup *from, mt_gsub_lookup *lookup) {
    *lookup = (mt_gsub_lookup){.type = from->type, .flag = from->flag, .mark_set = from->mark_set};
    reader->left -= from->subtable_count;
    if (reader->left < 0) return MT_OK;
    lookup->subtables =
        mt_arena_new(reader->arena, (size_t)from->subtable_count + 1, sizeof *lookup->subtables);
    if (!lookup->subtables) return MT_NO_MEMORY;
    lookup->subtable_count = from->subtable_count;
    mt_status status = MT_OK;
    for (int i = 0; i < from->subtable_count && status == MT_OK; i++) {
        mt_gsub_subtable *subtable = &lookup->subtables[i];
        subtable->table = mt_lookup_subtable(from, i);
        status = mt_gsub_read(reader, from->type, subtable->table, subtable);
    }
    return status;
}

static mt_status read_lookups(mt_gsub *gsub, mt_arena *arena) {
    int count = gsub->layout.lookup_count;
    mt_gsub_reader reader = {arena, gsub->glyph_count, MT_SUBSTITUTIONS_MAX};
    gsub->lookups = mt_arena_new(arena, (size_t)count + 1, sizeof *gsub->lookups);
    mt_status status = gsub->lookups ? MT_OK : MT_NO_MEMORY;
    for (int i = 0; i < count && status == MT_OK; i++) {
        mt_lookup lookup = mt_layout_lookup(&gsub->layout, i);
        status = read_lookup(&reader, &lookup, &gsub->lookups[i]);
    }
    return status;
}

mt_status mt_gsub_open(const mt_font *font, mt_arena *arena, mt_gsub *gsub) {
    const int32_t *place;
    int axes = mt_font_place(font, &place);
    mt_bytes table;
    mt_status status = mt_font_table(font, MT_TAG('G', 'S', 'U', 'B'), arena, &table);
    if (status == MT_OK) status = mt_layout_place(table, place, axes, arena, &table);
    return status == MT_OK ? mt_gsub_open_table(table, mt_font_glyph_count(font), arena, gsub) : status;
}

mt_status mt_gsub_open_table(mt_bytes table, int glyph_count, mt_arena *arena, mt_gsub *gsub) {
    mt_gsub made = {.table = table, .glyph_count = glyph_count};
    mt_status status = mt_layout_open(made.table, MT_EXTENSION_GSUB, arena, &made.layout);
    if (status == MT_OK) status = read_lookups(&made, arena);
    if (status == MT_OK) *gsub = made;
    return status;
}

void mt_gsub_mark(const mt_gsub *gsub, int feature, bool *marked) {
    int count = mt_feature_lookup_count(&gsub->layout, feature);
    for (int i = 0; i < count; i++) {
        int lookup = mt_feature_lookup(&gsub->layout, feature, i);
        if (lookup < 0 || marked[lookup]) continue;
        marked[lookup] = true;
        mt_calls_mark(&gsub->layout.calls, lookup, marked);
    }
}
