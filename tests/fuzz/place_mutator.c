/* Records of places (fuzz.h), mutated so that geometry gets what is hard for it: places that come together, lie on edges of others, move by
 * one unit, and rings that are there twice. */
#include "fuzz.h"

#include <string.h>

size_t LLVMFuzzerMutate(uint8_t *bytes, size_t length, size_t most);
size_t LLVMFuzzerCustomMutator(uint8_t *bytes, size_t length, size_t most, unsigned seed);

static uint32_t next(unsigned *seed, uint32_t below) {
    *seed = *seed * 1664525u + 1013904223u;
    return (*seed >> 8) % below;
}

static int read_16(const uint8_t *at) {
    return (int16_t)(at[0] << 8 | at[1]);
}

static void write_16(uint8_t *at, int value) {
    at[0] = (uint8_t)(value >> 8);
    at[1] = (uint8_t)value;
}

static void move(uint8_t *record, unsigned *seed) {
    static const int steps[] = {-1000, -10, -1, 0, 1, 10, 1000};
    write_16(record + 1, read_16(record + 1) + steps[next(seed, 7)]);
    write_16(record + 3, read_16(record + 3) + steps[next(seed, 7)]);
}

/* A place between two others. */
static void put_between(uint8_t *record, const uint8_t *p, const uint8_t *q) {
    write_16(record + 1, (read_16(p + 1) + read_16(q + 1)) / 2);
    write_16(record + 3, (read_16(p + 3) + read_16(q + 3)) / 2);
}

/* Copies up to eight records behind the last, in order or in reverse. */
static size_t repeat(uint8_t *bytes, size_t length, size_t most, size_t count, unsigned *seed) {
    uint8_t *records = bytes + 1;
    size_t first = next(seed, (uint32_t)count), copied = 1 + next(seed, 8);
    bool reversed = next(seed, 2);
    if (copied > count - first) copied = count - first;
    if (1 + (count + copied) * FUZZ_RECORD > most) return length;
    for (size_t i = 0; i < copied; i++)
        memmove(records + (count + i) * FUZZ_RECORD,
                records + (first + (reversed ? copied - 1 - i : i)) * FUZZ_RECORD, FUZZ_RECORD);
    records[count * FUZZ_RECORD] |= FUZZ_STARTS;
    return 1 + (count + copied) * FUZZ_RECORD;
}

size_t LLVMFuzzerCustomMutator(uint8_t *bytes, size_t length, size_t most, unsigned seed) {
    size_t count = length > 1 ? (length - 1) / FUZZ_RECORD : 0;
    if (count < 3) return LLVMFuzzerMutate(bytes, length, most);
    uint8_t *at = bytes + 1 + next(&seed, (uint32_t)count) * FUZZ_RECORD;
    const uint8_t *p = bytes + 1 + next(&seed, (uint32_t)count) * FUZZ_RECORD,
                  *q = bytes + 1 + next(&seed, (uint32_t)count) * FUZZ_RECORD;
    switch (next(&seed, 7)) {
    case 0: memmove(at + 1, p + 1, FUZZ_RECORD - 1); return length;
    case 1: put_between(at, p, q); return length;
    case 2: at[0] ^= (uint8_t)(1u << next(&seed, 4)); return length;
    case 3: return repeat(bytes, length, most, count, &seed);
    case 4: return LLVMFuzzerMutate(bytes, length, most);
    default: move(at, &seed); return length;
    }
}
