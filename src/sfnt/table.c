#include "sfnt/table.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"

void mt_table_free(mt_table *table) {
    mt_free(table->bytes);
    *table = (mt_table){0};
}

/* Room for `more` bytes. */
static bool reserve(mt_table *table, size_t more) {
    if (table->failed) return false;
    if (more <= table->room - table->length) return true;
    size_t room = table->room ? table->room : 256;
    while (room - table->length < more && room <= SIZE_MAX / 2) room *= 2;
    uint8_t *bytes = room - table->length < more ? NULL : mt_grow(table->bytes, room, 1);
    table->failed = !bytes;
    if (!bytes) return false;
    table->bytes = bytes;
    table->room = room;
    return true;
}

void mt_table_bytes(mt_table *table, const void *bytes, size_t length) {
    if (length == 0 || !reserve(table, length)) return;
    memcpy(table->bytes + table->length, bytes, length);
    table->length += length;
}

static void put(mt_table *table, uint64_t value, int size) {
    uint8_t bytes[8];
    for (int i = 0; i < size; i++) bytes[i] = (uint8_t)(value >> 8 * (size - 1 - i));
    mt_table_bytes(table, bytes, (size_t)size);
}

void mt_table_u8(mt_table *table, unsigned value) {
    put(table, value, 1);
}

void mt_table_16(mt_table *table, int value) {
    put(table, (uint64_t)value, 2);
}

void mt_table_32(mt_table *table, uint32_t value) {
    put(table, value, 4);
}

void mt_table_64(mt_table *table, int64_t value) {
    put(table, (uint64_t)value, 8);
}

void mt_table_zeros(mt_table *table, int count) {
    for (int i = 0; i < count; i++) put(table, 0, 1);
}

/* Rounded and kept in the range; what is no number becomes 0, which every range here holds. */
static int64_t clamp(double value, double low, double high) {
    return isnan(value) ? 0 : (int64_t)fmin(fmax(floor(value + 0.5), low), high);
}

void mt_table_fixed(mt_table *table, double value) {
    put(table, (uint64_t)clamp(value * 65536.0, INT32_MIN, INT32_MAX), 4);
}

void mt_table_i16_of(mt_table *table, double value) {
    put(table, (uint64_t)clamp(value, INT16_MIN, INT16_MAX), 2);
}

void mt_table_u16_of(mt_table *table, double value) {
    put(table, (uint64_t)clamp(value, 0, UINT16_MAX), 2);
}
