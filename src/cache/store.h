/* A directory of entries, each found by its key, for several processes at once.
 *
 *     DIRECTORY/3f/a90c…   256 folders by the first byte of the key; an entry is named by the rest of it
 *
 * An entry is written under another name and renamed. It begins with its key and a digest of the rest, so that one that is torn,
 * damaged or in another's place is as none. Nothing is locked between processes: who comes first writes, and others write the same.
 *
 * Each folder may have a 256th of the bytes: keys are spread evenly. When more is written, those that were used longest ago are removed. */
#pragma once

#include "base/memory.h"
#include "cache/sha256.h"

typedef struct mt_store mt_store;

/* Opens a directory, which is made where none is. Of `most` bytes at most, disk blocks of 4096; several processes may each go an eighth
 * beyond that before they look again. MT_CANNOT_WRITE (errno says why), MT_NO_MEMORY. */
mt_status mt_store_open(const char *directory, uint64_t most, mt_store **store);
void mt_store_close(mt_store *store);

/* Whether there is a sound entry: its bytes then, in the arena. From any thread. */
bool mt_store_read(mt_store *store, const mt_digest *key, mt_arena *arena, const uint8_t **bytes,
                   size_t *length);
/* Whether an entry could be written. From any thread. */
bool mt_store_write(mt_store *store, const mt_digest *key, const uint8_t *bytes, size_t length);
