#include "cache/cache.h"

#include <stdatomic.h>

#include "cache/store.h"

struct mt_cache {
    mt_store *store;
    atomic_int found, made, lost;
};

mt_status mt_cache_open(const char *directory, uint64_t most, mt_cache **cache) {
    if (most == 0) most = MT_CACHE_BYTES;
    if (most < MT_CACHE_BYTES_LEAST) return MT_BAD_PARAMETER;
    mt_cache *made = mt_new(1, sizeof *made);
    mt_status status = made ? mt_store_open(directory, most, &made->store) : MT_NO_MEMORY;
    if (status == MT_OK)
        *cache = made;
    else
        mt_free(made);
    return status;
}

void mt_cache_close(mt_cache *cache) {
    if (cache) mt_store_close(cache->store);
    mt_free(cache);
}

mt_cache_counts mt_cache_count(const mt_cache *cache) {
    return (mt_cache_counts){atomic_load(&cache->found), atomic_load(&cache->made),
                             atomic_load(&cache->lost)};
}

bool mt_cache_find(mt_cache *cache, const mt_digest *key, mt_arena *arena, mt_prepared *prepared) {
    const uint8_t *bytes;
    size_t length;
    bool found = mt_store_read(cache->store, key, arena, &bytes, &length) &&
                 mt_prepared_unpack(bytes, length, arena, prepared) == MT_OK;
    if (found) atomic_fetch_add(&cache->found, 1);
    return found;
}

void mt_cache_keep(mt_cache *cache, const mt_digest *key, const mt_prepared *prepared) {
    mt_buffer bytes = {0};
    bool kept = mt_prepared_is_lasting(prepared) && mt_prepared_pack(prepared, &bytes) == MT_OK &&
                mt_store_write(cache->store, key, bytes.bytes, bytes.length);
    atomic_fetch_add(&cache->made, 1);
    if (!kept) atomic_fetch_add(&cache->lost, 1);
    mt_buffer_free(&bytes);
}
