/* SHA-256 (FIPS 180-4): a digest that no two different inputs share. */
#pragma once

#include <stddef.h>
#include <stdint.h>

enum { MT_DIGEST_BYTES = 32 };

typedef struct mt_digest {
    uint8_t bytes[MT_DIGEST_BYTES];
} mt_digest;

/* The digest of all parts one after the other. */
typedef struct mt_hashing {
    uint32_t state[8];
    uint8_t block[64];
    size_t used;     /* bytes of the block */
    uint64_t length; /* of all parts so far, bytes */
} mt_hashing;

mt_hashing mt_hashing_begin(void);
void mt_hashing_add(mt_hashing *hashing, const void *bytes, size_t length);
mt_digest mt_hashing_end(mt_hashing *hashing);
