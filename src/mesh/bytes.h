/* Numbers in bytes, in either order. */
#pragma once

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

static inline uint64_t mt_get_unsigned(const uint8_t *bytes, int size, bool big) {
    uint64_t value = 0;
    for (int i = 0; i < size; i++) value = value << 8 | bytes[big ? i : size - 1 - i];
    return value;
}

static inline uint32_t mt_get_u32_little(const uint8_t *bytes) {
    return (uint32_t)mt_get_unsigned(bytes, 4, false);
}

/* IEEE 754 binary32. */
static inline float mt_get_float(const uint8_t *bytes, bool big) {
    uint32_t bits = (uint32_t)mt_get_unsigned(bytes, 4, big);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* IEEE 754 binary64. */
static inline double mt_get_double(const uint8_t *bytes, bool big) {
    uint64_t bits = mt_get_unsigned(bytes, 8, big);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}
