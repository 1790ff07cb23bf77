#include "write/gvar_pack.h"

/* ---- point numbers ------------------------------------------------------------------------------------- */

enum { POINTS_ARE_WORDS = 0x80, POINT_RUN_MAX = 128 };

static int next_told(const bool *told, int count, int i) {
    do i++;
    while (i < count && !told[i]);
    return i;
}

/* A run of differences that are all bytes, or all words, from point i on, which follows point `last`; returns the point after it. */
static int pack_point_run(const bool *told, int count, int i, int *last, mt_table *table) {
    bool words = i - *last > UINT8_MAX;
    int length = 0;
    for (int k = i, before = *last; k < count && length < POINT_RUN_MAX && (k - before > UINT8_MAX) == words;
         before = k, k = next_told(told, count, k))
        length++;
    mt_table_u8(table, (words ? POINTS_ARE_WORDS : 0u) | (unsigned)(length - 1));
    for (; length > 0; length--) {
        if (words)
            mt_table_16(table, i - *last);
        else
            mt_table_u8(table, (unsigned)(i - *last));
        *last = i;
        i = next_told(told, count, i);
    }
    return i;
}

void mt_pack_points(const bool *told, int count, mt_table *table) {
    enum { ALL = 0, COUNT_IS_WORD = 0x8000, BYTE_COUNT_MAX = 127 };
    int told_count = 0, last = 0;
    for (int i = 0; i < count; i++) told_count += told[i];
    if (told_count == count) {
        mt_table_u8(table, ALL);
        return;
    }
    if (told_count > BYTE_COUNT_MAX)
        mt_table_16(table, COUNT_IS_WORD | told_count);
    else
        mt_table_u8(table, (unsigned)told_count);
    for (int i = next_told(told, count, -1); i < count;) i = pack_point_run(told, count, i, &last, table);
}

/* ---- deltas -------------------------------------------------------------------------------------------- */

enum { DELTAS_ARE_ZERO = 0x80, DELTAS_ARE_WORDS = 0x40, DELTA_RUN_MAX = 64 };

static bool is_byte(int delta) {
    return delta >= INT8_MIN && delta <= INT8_MAX;
}

/* How many deltas a run of zeros has from here. */
static int zeros_at(const int16_t *deltas, int count) {
    int length = 0;
    while (length < count && length < DELTA_RUN_MAX && deltas[length] == 0) length++;
    return length;
}

/* A run of bytes ends where a word comes, or two zeros do, which are shorter by themselves. */
static int bytes_at(const int16_t *deltas, int count) {
    int length = 0;
    while (length < count && length < DELTA_RUN_MAX && is_byte(deltas[length]) &&
           zeros_at(deltas + length, count - length) < 2)
        length++;
    return length;
}

/* A run of words ends where zeros come, or two bytes. */
static int words_at(const int16_t *deltas, int count) {
    int length = 0;
    while (length < count && length < DELTA_RUN_MAX && deltas[length] != 0) {
        bool two_bytes = is_byte(deltas[length]) && (length + 1 == count || is_byte(deltas[length + 1]));
        if (two_bytes) break;
        length++;
    }
    return length;
}

/* One run; returns its length. */
static int pack_run(const int16_t *deltas, int count, mt_table *table) {
    int zeros = zeros_at(deltas, count);
    if (zeros > 1 || (zeros == 1 && count == 1)) {
        mt_table_u8(table, DELTAS_ARE_ZERO | (unsigned)(zeros - 1));
        return zeros;
    }
    bool words = !is_byte(deltas[0]);
    int length = words ? words_at(deltas, count) : bytes_at(deltas, count);
    mt_table_u8(table, (words ? DELTAS_ARE_WORDS : 0u) | (unsigned)(length - 1));
    for (int i = 0; i < length; i++) {
        if (words)
            mt_table_16(table, deltas[i]);
        else
            mt_table_u8(table, (unsigned)deltas[i] & 0xFF);
    }
    return length;
}

void mt_pack_deltas(const int16_t *deltas, int count, mt_table *table) {
    for (int i = 0; i < count;) i += pack_run(deltas + i, count - i, table);
}
