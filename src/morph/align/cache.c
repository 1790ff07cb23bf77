/* A hash table with chains, keyed by the contents of two rings (FNV-1a of G. Fowler, L. C. Noll and K.-P. Vo), so that a ring which
 * a later division cuts anew is found although it lies elsewhere in memory. Looking up takes O(n) for n points of both rings; the
 * alignment that it saves takes O(n²). An entry never changes: equal keys give equal results, so results do not depend on the cache. */
#include "morph/align/cache.h"

#include <string.h>

/* FNV-1a, word by word. */
static uint64_t add_word(uint64_t hash, uint32_t word) {
    return (hash ^ word) * UINT64_C(0x100000001b3);
}

static uint64_t add_ring(uint64_t hash, const mt_ring *ring) {
    hash = add_word(hash, (uint32_t)ring->count);
    for (int i = 0; i < ring->count; i++)
        hash = add_word(add_word(hash, (uint32_t)ring->points[i].x), (uint32_t)ring->points[i].y);
    return hash;
}

static uint64_t hash_of(const mt_cache_key *key) {
    return add_ring(add_ring(UINT64_C(0xcbf29ce484222325), key->p), key->q);
}

static bool same_ring(const mt_ring *p, const mt_ring *q) {
    if (p->count != q->count) return false;
    size_t count = (size_t)p->count;
    return memcmp(p->points, q->points, count * sizeof *p->points) == 0 &&
           memcmp(p->marks, q->marks, count * sizeof *p->marks) == 0;
}

static bool same_frame(const mt_frame *a, const mt_frame *b) {
    bool same = mt_point_equal(a->box.min, b->box.min) && mt_point_equal(a->box.max, b->box.max);
    for (int i = 0; i < 4; i++)
        same = same && a->x[i] == b->x[i] && a->y[i] == b->y[i] && a->heading[i] == b->heading[i];
    return same;
}

static bool same_key(const mt_cache_key *a, const mt_cache_key *b) {
    return a->joined == b->joined && a->weights.direction == b->weights.direction &&
           a->weights.distance == b->weights.distance && a->weights.corner == b->weights.corner &&
           same_frame(&a->frame_p, &b->frame_p) && same_frame(&a->frame_q, &b->frame_q) &&
           same_ring(a->p, b->p) && same_ring(a->q, b->q);
}

const mt_cache_entry *mt_alignment_cache_find(const mt_alignment_cache *cache, const mt_cache_key *key) {
    if (!cache) return NULL;
    uint64_t hash = hash_of(key);
    for (const mt_cache_entry *k = cache->buckets[hash % MT_CACHE_BUCKETS]; k; k = k->next)
        if (k->hash == hash && same_key(&k->key, key)) return k;
    return NULL;
}

mt_status mt_alignment_cache_add(mt_alignment_cache *cache, const mt_cache_key *key, double cost,
                                 const mt_contour_pair *pair, mt_arena *arena) {
    if (!cache) return MT_OK;
    mt_cache_entry *made = mt_arena_new(arena, 1, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    uint64_t hash = hash_of(key);
    *made = (mt_cache_entry){.key = *key, .hash = hash, .cost = cost};
    if (pair) made->pair = *pair;
    made->next = cache->buckets[hash % MT_CACHE_BUCKETS];
    cache->buckets[hash % MT_CACHE_BUCKETS] = made;
    return MT_OK;
}
