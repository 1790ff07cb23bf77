#include "layout/value_write.h"

/* ---- what varies --------------------------------------------------------------------------------------- */

mt_variation_pool mt_variation_pool_make(mt_var_store *store) {
    return (mt_variation_pool){.store = store, .indices = {.width = 1}};
}

void mt_variation_pool_free(mt_variation_pool *pool) {
    mt_interned_free(&pool->indices);
}

int mt_variation_pool_add(mt_variation_pool *pool, const int32_t *values) {
    uint32_t index = MT_NO_VARIATION;
    int number = 0;
    if (pool->status == MT_OK && pool->store) pool->status = mt_var_store_add(pool->store, values, &index);
    if (pool->status != MT_OK || index == MT_NO_VARIATION) return -1;
    pool->status = mt_intern(&pool->indices, &(int32_t){(int32_t)index}, &number);
    return MT_VARIATION_SIZE * number;
}

size_t mt_variation_pool_size(const mt_variation_pool *pool) {
    return MT_VARIATION_SIZE * (size_t)pool->indices.count;
}

void mt_variation_pool_write(const mt_variation_pool *pool, mt_table *table) {
    for (int i = 0; i < pool->indices.count; i++) {
        mt_table_32(table, (uint32_t)*mt_interned_row(&pool->indices, i));
        mt_table_16(table, 0x8000); /* the format of a VariationIndex table */
    }
}

/* ---- formats ------------------------------------------------------------------------------------------- */

int mt_value_row_width(const mt_value_rows *rows) {
    return rows->part_count * rows->place_count;
}

static bool varies(const mt_value_rows *rows, const int32_t *values) {
    for (int i = 1; i < rows->place_count; i++)
        if (values[i] != values[0]) return true;
    return false;
}

mt_value_format mt_value_format_of(const mt_value_rows *rows, const int32_t *values, int count) {
    mt_value_format format = {0, 0};
    for (int i = 0; i < count; i++)
        for (int k = 0; k < rows->part_count; k++, values += rows->place_count) {
            if (values[0]) format.plain |= 1u << rows->parts[k];
            if (varies(rows, values)) format.varying |= 1u << rows->parts[k];
        }
    return format;
}

mt_value_format mt_value_format_join(mt_value_format one, mt_value_format other) {
    return (mt_value_format){one.plain | other.plain, one.varying | other.varying};
}

int mt_value_format_field(mt_value_format format, int first) {
    unsigned all = (1u << MT_VALUE_PARTS) - 1;
    return (int)((format.plain >> first & all) | (format.varying >> first & all) << MT_VALUE_PARTS);
}

size_t mt_value_format_size(mt_value_format format) {
    return 2 * (size_t)(__builtin_popcount(format.plain) + __builtin_popcount(format.varying));
}

/* ---- records ------------------------------------------------------------------------------------------- */

static bool is_in(unsigned bits, int part, int first) {
    return part >= first && part < first + MT_VALUE_PARTS && bits >> part & 1;
}

static void write_record(mt_table *table, const mt_value_rows *rows, mt_value_format format, int first,
                         const int32_t *row, mt_variation_pool *pool, size_t to_pool) {
    for (int k = 0; k < rows->part_count; k++)
        if (is_in(format.plain, rows->parts[k], first)) mt_table_16(table, row[k * rows->place_count]);
    for (int k = 0; k < rows->part_count; k++) {
        if (!is_in(format.varying, rows->parts[k], first)) continue;
        int at = mt_variation_pool_add(pool, row + k * rows->place_count);
        mt_table_16(table, at < 0 ? 0 : (int)to_pool + at);
    }
}

void mt_value_write(mt_table *table, const mt_value_rows *rows, mt_value_format format, const int32_t *row,
                    mt_variation_pool *pool, size_t to_pool) {
    write_record(table, rows, format, 0, row, pool, to_pool);
    write_record(table, rows, format, MT_VALUE_PARTS, row, pool, to_pool);
}
