/* An ItemVariationStore in the making (OpenType spec, "OpenType Font Variations Common Table Formats").
 *
 * A varying font has its sources as stops on one axis (stops.h); the first stop is the default. What some value is at each stop is a
 * row, and between two neighbours on the axis it runs straight: region r (0 …) peaks at stop r + 1 and ends at the fonts beside it,
 * so that a row's delta there is its value at that stop less the first. */
#pragma once

#include "sfnt/intern.h"
#include "sfnt/stops.h"
#include "sfnt/table.h"

/* The index of what is the same at all stops: it needs no row. Other indices have the number of an
 * ItemVariationData in the upper 16 bits, and of a row in it in the lower. */
#define MT_NO_VARIATION 0xFFFFFFFFu

/* Rows whose deltas are 0 but in these regions, in as many bytes each as one of them needs. */
typedef struct mt_var_data {
    uint64_t regions; /* a bit each */
    int size;         /* of a delta: 1, 2 or 4 bytes */
    int count;
    mt_table deltas;
} mt_var_data;

typedef struct mt_var_store {
    mt_stops stops;
    mt_interned rows;  /* the deltas of each region; each row once */
    uint32_t *indices; /* of each row */
    int index_room;
    int data_count, data_room;
    mt_var_data *data;
} mt_var_store;

/* An empty store. Whatever becomes of it, it is for mt_var_store_free. */
mt_var_store mt_var_store_make(const mt_stops *stops);
void mt_var_store_free(mt_var_store *store);

/* The index of a row of values, one a stop, each within ±2³⁰; of rows that differ by a constant it is the same.
 * MT_NO_VARIATION for values that are all equal. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_var_store_add(mt_var_store *store, const int32_t *values, uint32_t *index);
/* The same, but with a row even for values that are all equal. */
mt_status mt_var_store_add_row(mt_var_store *store, const int32_t *values, uint32_t *index);

/* The store as a table; only with rows in it. MT_TOO_LARGE; a table that could not grow has failed. */
mt_status mt_var_store_write(const mt_var_store *store, mt_table *table);

/* A DeltaSetIndexMap of rows: the index of each of `count` things, 1 … 65535. */
void mt_table_index_map(mt_table *table, const uint32_t *indices, int count);
