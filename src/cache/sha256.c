/* The standard's own words: sections 4.1.2 (functions), 5.1.1 (padding), 5.3.3 (initial value) and 6.2.2 (a block). The constants are the
 * first 32 bits of the fractions of the roots of the first primes: square roots of eight, cube roots of 64. */
#include "cache/sha256.h"

#include <string.h>

enum { BLOCK = 64, ROUNDS = 64, WORDS = 16 };

static const uint32_t constants[ROUNDS] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2,
};

mt_hashing mt_hashing_begin(void) {
    return (mt_hashing){.state = {
                            0x6a09e667,
                            0xbb67ae85,
                            0x3c6ef372,
                            0xa54ff53a,
                            0x510e527f,
                            0x9b05688c,
                            0x1f83d9ab,
                            0x5be0cd19,
                        }};
}

static uint32_t turn(uint32_t word, int by) {
    return word >> by | word << (32 - by);
}

static uint32_t word_at(const uint8_t *bytes) {
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

static void schedule(const uint8_t *block, uint32_t w[ROUNDS]) {
    for (int t = 0; t < WORDS; t++) w[t] = word_at(block + 4 * t);
    for (int t = WORDS; t < ROUNDS; t++) {
        uint32_t x = w[t - 2], y = w[t - 15];
        uint32_t sigma1 = turn(x, 17) ^ turn(x, 19) ^ x >> 10, sigma0 = turn(y, 7) ^ turn(y, 18) ^ y >> 3;
        w[t] = sigma1 + w[t - 7] + sigma0 + w[t - 16];
    }
}

static void take_block(uint32_t state[8], const uint8_t *block) {
    uint32_t w[ROUNDS], s[8];
    schedule(block, w);
    memcpy(s, state, sizeof s);
    for (int t = 0; t < ROUNDS; t++) {
        uint32_t a = s[0], e = s[4];
        uint32_t sum1 = turn(e, 6) ^ turn(e, 11) ^ turn(e, 25), choice = (e & s[5]) ^ (~e & s[6]);
        uint32_t sum0 = turn(a, 2) ^ turn(a, 13) ^ turn(a, 22);
        uint32_t majority = (a & s[1]) ^ (a & s[2]) ^ (s[1] & s[2]);
        uint32_t first = s[7] + sum1 + choice + constants[t] + w[t];
        memmove(s + 1, s, 7 * sizeof *s);
        s[4] += first;
        s[0] = first + sum0 + majority;
    }
    for (int i = 0; i < 8; i++) state[i] += s[i];
}

void mt_hashing_add(mt_hashing *hashing, const void *bytes, size_t length) {
    const uint8_t *at = bytes;
    hashing->length += length;
    while (length > 0) {
        size_t part = BLOCK - hashing->used < length ? BLOCK - hashing->used : length;
        memcpy(hashing->block + hashing->used, at, part);
        hashing->used += part;
        at += part;
        length -= part;
        if (hashing->used < BLOCK) break;
        take_block(hashing->state, hashing->block);
        hashing->used = 0;
    }
}

/* A bit of one, zeros, and the length in bits as 64 bits, up to the end of a block. */
mt_digest mt_hashing_end(mt_hashing *hashing) {
    uint8_t padding[BLOCK + 8] = {0x80}, *length_at;
    uint64_t bits = 8 * hashing->length;
    size_t zeros = (2 * BLOCK - 8 - 1 - hashing->used) % BLOCK;
    mt_digest digest;
    length_at = padding + 1 + zeros;
    for (int i = 0; i < 8; i++) length_at[i] = (uint8_t)(bits >> (56 - 8 * i));
    mt_hashing_add(hashing, padding, 1 + zeros + 8);
    for (int i = 0; i < MT_DIGEST_BYTES; i++)
        digest.bytes[i] = (uint8_t)(hashing->state[i / 4] >> (24 - 8 * (i % 4)));
    return digest;
}
