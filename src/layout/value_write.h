/* Value records that are written, with VariationIndex tables for what varies (OpenType spec, "GPOS": Value record;
 * "Layout tables": Device and VariationIndex tables). */
#pragma once

#include "layout/value.h"
#include "sfnt/table.h"
#include "sfnt/var_store.h"

/* The VariationIndex tables of a subtable, each once. What fails is told at the end, by `status`. */
typedef struct mt_variation_pool {
    mt_var_store *store;
    mt_interned indices;
    mt_status status;
} mt_variation_pool;

enum { MT_VARIATION_SIZE = 6 }; /* bytes of a VariationIndex table */

/* An empty pool. It is for mt_variation_pool_free; without a store, it stays empty. */
mt_variation_pool mt_variation_pool_make(mt_var_store *store);
void mt_variation_pool_free(mt_variation_pool *pool);

/* Where the table of values, one a stop, lies: bytes from the start of the pool; -1 where all are the same. */
int mt_variation_pool_add(mt_variation_pool *pool, const int32_t *values);
size_t mt_variation_pool_size(const mt_variation_pool *pool);
void mt_variation_pool_write(const mt_variation_pool *pool, mt_table *table);

/* How values are kept until they are written: a row has, for each of its parts, the value at each place. */
typedef struct mt_value_rows {
    int part_count, place_count;
    const uint8_t *parts; /* ascending: bits of a value format; 4 and up for a second record */
} mt_value_rows;

int mt_value_row_width(const mt_value_rows *rows);

/* What values need: a bit for each part that is not 0 by default in all of them, and for each that varies in any. */
typedef struct mt_value_format {
    unsigned plain, varying;
} mt_value_format;

mt_value_format mt_value_format_of(const mt_value_rows *rows, const int32_t *values, int count);
mt_value_format mt_value_format_join(mt_value_format one, mt_value_format other);
/* The valueFormat field of the record of the parts from `first` on (0 or MT_VALUE_PARTS), and the bytes of all records. */
int mt_value_format_field(mt_value_format format, int first);
size_t mt_value_format_size(mt_value_format format);

/* Writes all records of a row. The pool starts `to_pool` bytes from what the records' offsets count from. */
void mt_value_write(mt_table *table, const mt_value_rows *rows, mt_value_format format, const int32_t *row,
                    mt_variation_pool *pool, size_t to_pool);
