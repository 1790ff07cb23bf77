#include "write/mirror.h"

#include <string.h>

#include "layout/ot.h"

/* Where the table's ItemVariationStore starts; 0 where it has none. */
static size_t store_of(uint32_t tag, mt_bytes table) {
    if (tag == MT_TAG('H', 'V', 'A', 'R') || tag == MT_TAG('V', 'V', 'A', 'R')) return mt_ot_u32(table, 4);
    if (tag == MT_TAG('M', 'V', 'A', 'R')) return mt_ot_u16(table, 10);
    bool varies = tag == MT_TAG('G', 'D', 'E', 'F') && mt_ot_u32(table, 0) >= 0x00010003;
    return varies ? mt_ot_u32(table, 14) : 0;
}

static void put(uint8_t *at, int value) {
    at[0] = (uint8_t)(value >> 8 & 0xFF);
    at[1] = (uint8_t)(value & 0xFF);
}

/* start, peak, end of 2.14 each become -end, -peak, -start. */
static void mirror_region(mt_bytes table, size_t at, uint8_t *copy) {
    put(copy + at, -mt_ot_i16(table, at + 4));
    put(copy + at + 2, -mt_ot_i16(table, at + 2));
    put(copy + at + 4, -mt_ot_i16(table, at));
}

mt_status mt_mirror_table(uint32_t tag, mt_arena *arena, mt_bytes *table) {
    enum { REGION = 6 };
    size_t store = store_of(tag, *table);
    if (!store) return MT_OK;
    size_t list = store + mt_ot_u32(*table, store + 2), count = mt_ot_u16(*table, list + 2);
    if (list + 4 + REGION * count > table->length) return MT_OK;
    uint8_t *copy = mt_arena_new(arena, table->length, 1);
    if (!copy) return MT_NO_MEMORY;
    memcpy(copy, table->bytes, table->length);
    for (size_t i = 0; i < count; i++) mirror_region(*table, list + 4 + REGION * i, copy);
    table->bytes = copy;
    return MT_OK;
}
