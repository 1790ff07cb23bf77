#include "sfnt/var_store.h"

#include "base/memory.h"

mt_var_store mt_var_store_make(const mt_stops *stops) {
    return (mt_var_store){.stops = *stops, .rows = {.width = stops->count - 1}};
}

void mt_var_store_free(mt_var_store *store) {
    for (int i = 0; i < store->data_count; i++) mt_table_free(&store->data[i].deltas);
    mt_interned_free(&store->rows);
    mt_free(store->indices);
    mt_free(store->data);
    *store = (mt_var_store){0};
}

/* ---- rows ---------------------------------------------------------------------------------------------- */

static int size_of(int32_t delta) {
    if (delta >= INT8_MIN && delta <= INT8_MAX) return 1;
    return delta >= INT16_MIN && delta <= INT16_MAX ? 2 : 4;
}

/* What a row needs; one of zeros goes with those of the first region. */
static mt_var_data kind_of(const int32_t *deltas, int count) {
    mt_var_data kind = {.size = 1};
    for (int i = 0; i < count; i++) {
        if (deltas[i]) kind.regions |= (uint64_t)1 << i;
        if (size_of(deltas[i]) > kind.size) kind.size = size_of(deltas[i]);
    }
    if (!kind.regions) kind.regions = 1;
    return kind;
}

enum { ROWS_MAX = 0xFFFF, DATA_MAX = 0xFFFF };

/* The ItemVariationData of that kind that takes another row; a new one where there is none. */
static mt_status find_data(mt_var_store *store, const mt_var_data *kind, int *number) {
    for (int i = store->data_count - 1; i >= 0; i--) {
        const mt_var_data *data = &store->data[i];
        if (data->regions != kind->regions || data->size != kind->size || data->count == ROWS_MAX) continue;
        *number = i;
        return MT_OK;
    }
    if (store->data_count == DATA_MAX) return MT_TOO_LARGE;
    mt_var_data *grown = mt_grow_list(store->data, store->data_count, &store->data_room, sizeof *grown);
    if (!grown) return MT_NO_MEMORY;
    store->data = grown;
    store->data[store->data_count] = *kind;
    *number = store->data_count++;
    return MT_OK;
}

static void write_delta(mt_table *table, int size, int32_t delta) {
    if (size == 1) mt_table_u8(table, (unsigned)delta & 0xFF);
    if (size == 2) mt_table_16(table, delta);
    if (size == 4) mt_table_32(table, (uint32_t)delta);
}

static mt_status place_row(mt_var_store *store, const int32_t *deltas, uint32_t *index) {
    int number;
    mt_var_data kind = kind_of(deltas, store->rows.width);
    mt_status status = find_data(store, &kind, &number);
    if (status != MT_OK) return status;
    mt_var_data *data = &store->data[number];
    for (int i = 0; i < store->rows.width; i++)
        if (data->regions >> i & 1) write_delta(&data->deltas, data->size, deltas[i]);
    if (data->deltas.failed) return MT_NO_MEMORY;
    *index = (uint32_t)number << 16 | (uint32_t)data->count++;
    return MT_OK;
}

static mt_status keep_index(mt_var_store *store, int row, uint32_t index) {
    uint32_t *grown = mt_grow_list(store->indices, row, &store->index_room, sizeof *grown);
    if (!grown) return MT_NO_MEMORY;
    store->indices = grown;
    store->indices[row] = index;
    return MT_OK;
}

mt_status mt_var_store_add_row(mt_var_store *store, const int32_t *values, uint32_t *index) {
    int32_t deltas[MT_STOPS_MAX];
    int row, known = store->rows.count;
    uint32_t made;
    for (int i = 1; i < store->stops.count; i++) deltas[i - 1] = values[i] - values[0];
    mt_status status = mt_intern(&store->rows, deltas, &row);
    if (status == MT_OK && row == known) status = place_row(store, deltas, &made);
    if (status == MT_OK && row == known) status = keep_index(store, row, made);
    if (status == MT_OK) *index = store->indices[row];
    return status;
}

mt_status mt_var_store_add(mt_var_store *store, const int32_t *values, uint32_t *index) {
    bool varies = false;
    for (int i = 1; i < store->stops.count; i++) varies |= values[i] != values[0];
    if (varies) return mt_var_store_add_row(store, values, index);
    *index = MT_NO_VARIATION;
    return MT_OK;
}

/* ---- the table ----------------------------------------------------------------------------------------- */

/* A VariationRegionList of one axis. */
static void write_regions(const mt_var_store *store, mt_table *table) {
    const mt_stops *stops = &store->stops;
    int last = stops->count - 1;
    mt_table_16(table, 1);
    mt_table_16(table, last);
    for (int stop = 1; stop <= last; stop++) {
        int font = mt_stops_font(stops, stop);
        mt_table_16(table, stops->at[font > 0 ? font - 1 : 0]);
        mt_table_16(table, stops->at[font]);
        mt_table_16(table, stops->at[font < last ? font + 1 : last]);
    }
}

static int region_count(const mt_var_data *data) {
    return __builtin_popcountll(data->regions);
}

static size_t data_size(const mt_var_data *data) {
    return 6 + 2 * (size_t)region_count(data) + data->deltas.length;
}

/* An ItemVariationData: all its deltas are words (of 16 bits, or of 32 with the flag), or none is. */
static void write_data(const mt_var_data *data, mt_table *table) {
    enum { LONG_WORDS = 0x8000 };
    int regions = region_count(data);
    mt_table_16(table, data->count);
    mt_table_16(table, data->size == 1 ? 0 : data->size == 2 ? regions : LONG_WORDS | regions);
    mt_table_16(table, regions);
    for (int i = 0; i < MT_STOPS_MAX; i++)
        if (data->regions >> i & 1) mt_table_16(table, i);
    mt_table_bytes(table, data->deltas.bytes, data->deltas.length);
}

mt_status mt_var_store_write(const mt_var_store *store, mt_table *table) {
    size_t regions = 8 + 4 * (size_t)store->data_count,
           at = regions + 4 + 6 * (size_t)(store->stops.count - 1);
    size_t length = at;
    for (int i = 0; i < store->data_count; i++) length += data_size(&store->data[i]);
    if (length > INT32_MAX) return MT_TOO_LARGE;
    mt_table_16(table, 1);
    mt_table_32(table, (uint32_t)regions);
    mt_table_16(table, store->data_count);
    for (int i = 0; i < store->data_count; i++) {
        mt_table_32(table, (uint32_t)at);
        at += data_size(&store->data[i]);
    }
    write_regions(store, table);
    for (int i = 0; i < store->data_count; i++) write_data(&store->data[i], table);
    return MT_OK;
}

/* ---- maps ---------------------------------------------------------------------------------------------- */

static int bits_of(uint32_t value) {
    int bits = 0;
    for (; value; value >>= 1) bits++;
    return bits;
}

/* An index is written in as few bits as all of them need; those after the last that is written are as that one. */
void mt_table_index_map(mt_table *table, const uint32_t *indices, int count) {
    uint32_t outer = 0, inner = 1;
    while (count > 1 && indices[count - 1] == indices[count - 2]) count--;
    for (int i = 0; i < count; i++) {
        outer |= indices[i] >> 16;
        inner |= indices[i] & 0xFFFF;
    }
    int inner_bits = bits_of(inner), size = (bits_of(outer) + inner_bits + 7) / 8;
    mt_table_u8(table, 0); /* format */
    mt_table_u8(table, (unsigned)((size - 1) << 4 | (inner_bits - 1)));
    mt_table_16(table, count);
    for (int i = 0; i < count; i++) {
        uint32_t entry = indices[i] >> 16 << inner_bits | (indices[i] & 0xFFFF);
        for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) mt_table_u8(table, entry >> shift & 0xFF);
    }
}
