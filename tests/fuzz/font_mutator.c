/* Fonts, mutated inside of their tables: the directory stays consistent, so that most of what comes out is opened. Layout, variation and
 * outline tables are chosen more often. What is no sfnt is mutated as bytes. */
#include "fuzz.h"

#include <stdlib.h>
#include <string.h>

size_t LLVMFuzzerMutate(uint8_t *bytes, size_t length, size_t most);
size_t LLVMFuzzerCustomMutator(uint8_t *bytes, size_t length, size_t most, unsigned seed);

enum { HEADER = 12, ENTRY = 16, TABLES_MOST = 64 };

typedef struct table {
    uint32_t tag;
    size_t offset, length;
} table;

static uint32_t next(unsigned *seed, uint32_t below) {
    *seed = *seed * 1664525u + 1013904223u;
    return (*seed >> 8) % below;
}

static uint32_t read_32(const uint8_t *at) {
    return (uint32_t)at[0] << 24 | (uint32_t)at[1] << 16 | (uint32_t)at[2] << 8 | at[3];
}

static void write_32(uint8_t *at, size_t value) {
    for (int i = 0; i < 4; i++) at[i] = (uint8_t)(value >> (24 - 8 * i));
}

/* The tables of an sfnt; 0 where it is none, or a damaged one. */
static int list_tables(const uint8_t *bytes, size_t length, table tables[TABLES_MOST]) {
    if (length < HEADER) return 0;
    int count = bytes[4] << 8 | bytes[5];
    if (count == 0 || count > TABLES_MOST || length < HEADER + (size_t)count * ENTRY) return 0;
    for (int i = 0; i < count; i++) {
        const uint8_t *entry = bytes + HEADER + i * ENTRY;
        tables[i] = (table){read_32(entry), read_32(entry + 8), read_32(entry + 12)};
        if (tables[i].offset > length || tables[i].length > length - tables[i].offset) return 0;
    }
    return count;
}

/* How often a table is chosen: layout most, what has no say in anything least. */
static uint32_t weight_of(uint32_t tag) {
    static const char often[] = "GPOSGSUBGDEFMATHgvarHVARMVARavarfvarglyfCFF CFF2kern";
    static const char seldom[] = "nameheadpostOS/2DSIGgaspcvt fpgmprep";
    char text[5] = {(char)(tag >> 24), (char)(tag >> 16), (char)(tag >> 8), (char)tag};
    return strstr(often, text) ? 12 : strstr(seldom, text) ? 1 : 4;
}

static int choose(const table *tables, int count, unsigned *seed) {
    uint32_t all = 0;
    for (int i = 0; i < count; i++) all += weight_of(tables[i].tag);
    uint32_t left = next(seed, all);
    for (int i = 0; i < count; i++) {
        if (left < weight_of(tables[i].tag)) return i;
        left -= weight_of(tables[i].tag);
    }
    return 0;
}

/* A number of 16 bits, of those that counts and offsets go wrong with. */
static void set_number(uint8_t *bytes, size_t length, unsigned *seed) {
    static const uint16_t values[] = {0, 1, 2, 3, 0x7FFF, 0x8000, 0xFFFF, 0x0100};
    if (length < 2) return;
    size_t at = next(seed, (uint32_t)(length - 1)) & ~(size_t)1;
    uint16_t old = (uint16_t)(bytes[at] << 8 | bytes[at + 1]);
    uint32_t way = next(seed, 11);
    uint16_t value = way < 8    ? values[way]
                     : way == 8 ? (uint16_t)(old + 1)
                     : way == 9 ? (uint16_t)(old - 1)
                                : (uint16_t)next(seed, (uint32_t)length);
    bytes[at] = (uint8_t)(value >> 8);
    bytes[at + 1] = (uint8_t)value;
}

/* The table's new bytes, in a buffer with room for `room`; their length. */
static size_t mutate_table(uint8_t *buffer, size_t length, size_t room, unsigned *seed) {
    if (length == 0 || next(seed, 2)) return LLVMFuzzerMutate(buffer, length, room);
    for (uint32_t times = 1 + next(seed, 4); times > 0; times--) set_number(buffer, length, seed);
    return length;
}

/* Puts the table in place of the old one: behind the others where it is longer. */
static size_t put_table(uint8_t *bytes, size_t length, int number, const table *old, const uint8_t *made,
                        size_t made_length, size_t most) {
    size_t at = made_length <= old->length ? old->offset : length;
    if (made_length > most - at) return length;
    memcpy(bytes + at, made, made_length);
    write_32(bytes + HEADER + number * ENTRY + 8, at);
    write_32(bytes + HEADER + number * ENTRY + 12, made_length);
    return at + made_length > length ? at + made_length : length;
}

size_t LLVMFuzzerCustomMutator(uint8_t *bytes, size_t length, size_t most, unsigned seed) {
    table tables[TABLES_MOST];
    int count = list_tables(bytes, length, tables);
    if (count == 0 || next(&seed, 50) == 0) return LLVMFuzzerMutate(bytes, length, most);
    int chosen = choose(tables, count, &seed);
    size_t room = tables[chosen].length + 64;
    uint8_t *buffer = malloc(room);
    fuzz_require(buffer);
    memcpy(buffer, bytes + tables[chosen].offset, tables[chosen].length);
    size_t made = mutate_table(buffer, tables[chosen].length, room, &seed);
    length = put_table(bytes, length, chosen, &tables[chosen], buffer, made, most);
    free(buffer);
    return length;
}
