/* Prepared glyphs that stay from run to run: found by all that they depend on (cache/key.h), kept in a directory (cache/store.h). */
#pragma once

#include "cache/key.h"
#include "cache/prepared.h"

/* An mt_cache (morphotype.h) is used by many threads at once. */

/* Whether the pair of this key was kept: *prepared then, in the arena. */
bool mt_cache_find(mt_cache *cache, const mt_digest *key, mt_arena *arena, mt_prepared *prepared);
/* Keeps what was made, unless it would not last. */
void mt_cache_keep(mt_cache *cache, const mt_digest *key, const mt_prepared *prepared);
