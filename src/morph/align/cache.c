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

static uint64_t hash_of(const mt_cache_key *of) {
    return add_ring(add_ring(UINT64_C(0xcbf29ce484222325), of->p), of->q);
}

static bool same_ring(const mt_ring *p, const mt_ring *q) {
    if (p->count != q->count) return false;
    size_t count = (size_t)p->count;
    return memcmp(p->points, q->points, count * sizeof *p->points) == 0 &&
           memcmp(p->marks, q->marks, count * sizeof *p->marks) == 0;
}

static bool same_box(mt_box a, mt_box b) {
    return mt_point_equal(a.min, b.min) && mt_point_equal(a.max, b.max);
}

static bool same_case(const mt_cache_key *a, const mt_cache_key *b) {
    return a->joined == b->joined && a->weights.direction == b->weights.direction &&
           a->weights.distance == b->weights.distance && a->weights.corner == b->weights.corner &&
           same_box(a->box_p, b->box_p) && same_box(a->box_q, b->box_q) && same_ring(a->p, b->p) &&
           same_ring(a->q, b->q);
}

const mt_cache_entry *mt_alignment_cache_find(const mt_alignment_cache *known, const mt_cache_key *of) {
    if (!known) return NULL;
    uint64_t hash = hash_of(of);
    for (const mt_cache_entry *k = known->buckets[hash % MT_CACHE_BUCKETS]; k; k = k->next)
        if (k->hash == hash && same_case(&k->of, of)) return k;
    return NULL;
}

mt_status mt_alignment_cache_add(mt_alignment_cache *known, const mt_cache_key *of, double cost,
                                 const mt_contour_pair *masters, mt_arena *arena) {
    if (!known) return MT_OK;
    mt_cache_entry *made = mt_arena_new(arena, 1, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    uint64_t hash = hash_of(of);
    *made = (mt_cache_entry){.of = *of, .hash = hash, .cost = cost};
    if (masters) made->masters = *masters;
    made->next = known->buckets[hash % MT_CACHE_BUCKETS];
    known->buckets[hash % MT_CACHE_BUCKETS] = made;
    return MT_OK;
}
