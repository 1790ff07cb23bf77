/* Advances along the axis (OpenType spec, "HVAR" and "VVAR"). */
#include "layout/lookup_builder.h"
#include "sfnt/var_store.h"
#include "write/varying.h"

typedef struct mt_advances {
    mt_glyf *const *glyphs; /* at each stop */
    int glyph_count;
    bool vertical;
    mt_var_store store;
    uint32_t *indices; /* of each glyph's row */
} mt_advances;

static mt_status find_rows(mt_advances *advances) {
    mt_status status = MT_OK;
    for (int i = 0; i < advances->glyph_count && status == MT_OK; i++) {
        int32_t values[MT_STOPS_MAX];
        for (int k = 0; k < advances->store.stops.count; k++) {
            const mt_glyf *glyph = &advances->glyphs[k][i];
            values[k] = advances->vertical ? glyph->height : glyph->advance;
        }
        status = mt_var_store_add_row(&advances->store, values, &advances->indices[i]);
    }
    return status;
}

/* The header of either table, the map, and the store. */
static mt_status write_table(const mt_advances *advances, mt_table *table) {
    uint32_t header = advances->vertical ? 24 : 20;
    mt_table map = {0};
    mt_table_index_map(&map, advances->indices, advances->glyph_count);
    mt_table_32(table, 0x00010000);
    mt_table_32(table, header + (uint32_t)map.length);
    mt_table_32(table, header);
    mt_table_zeros(table, (int)header - 12); /* no maps of the bearings, nor of VVAR's origins */
    mt_table_bytes(table, map.bytes, map.length);
    table->failed |= map.failed;
    mt_table_free(&map);
    return mt_var_store_write(&advances->store, table);
}

static mt_status write_advances(mt_glyf *const *glyphs, const mt_stops *stops, int glyph_count, bool vertical,
                                mt_arena *arena, mt_bytes *bytes) {
    mt_advances advances = {glyphs, glyph_count, vertical, mt_var_store_make(stops), NULL};
    mt_table table = {0};
    advances.indices = mt_new((size_t)glyph_count, sizeof *advances.indices);
    mt_status status = advances.indices ? find_rows(&advances) : MT_NO_MEMORY;
    if (status == MT_OK) status = write_table(&advances, &table);
    if (status == MT_OK) status = mt_table_keep(&table, arena, bytes);
    mt_table_free(&table);
    mt_var_store_free(&advances.store);
    mt_free(advances.indices);
    return status;
}

mt_status mt_hvar_write(mt_glyf *const *glyphs, const mt_stops *stops, int glyph_count, mt_arena *arena,
                        mt_bytes *hvar) {
    return write_advances(glyphs, stops, glyph_count, false, arena, hvar);
}

mt_status mt_vvar_write(mt_glyf *const *glyphs, const mt_stops *stops, int glyph_count, mt_arena *arena,
                        mt_bytes *vvar) {
    return write_advances(glyphs, stops, glyph_count, true, arena, vvar);
}
