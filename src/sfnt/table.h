/* An sfnt table in the making: big-endian bytes that grow.
 *
 * A table that could not grow has failed and takes no more bytes; that is looked at once, when all tables are
 * written. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct mt_table {
    uint8_t *bytes;
    size_t length, room;
    bool failed;
} mt_table; /* all zero is an empty table */

void mt_table_free(mt_table *table);

void mt_table_bytes(mt_table *table, const void *bytes, size_t length);
void mt_table_u8(mt_table *table, unsigned value);
/* The low 16 bits, for signed and unsigned fields alike. */
void mt_table_16(mt_table *table, int value);
void mt_table_32(mt_table *table, uint32_t value);
void mt_table_64(mt_table *table, int64_t value);
void mt_table_zeros(mt_table *table, int count);
/* 16.16 */
void mt_table_fixed(mt_table *table, double value);
/* The nearest whole number, at the end of the field's range where it is beyond. */
void mt_table_i16_of(mt_table *table, double value);
void mt_table_u16_of(mt_table *table, double value);
