/* Costs and contour pairs of rings that were aligned before: from one division, and from one set of settings, to the next most rings
 * stay the same. */
#pragma once

#include <stdint.h>

#include "geometry/ring.h"
#include "morph/model/frame.h"
#include "morph/model/morph.h"
#include "morph/model/settings.h"

/* Everything that an alignment without pins depends on. */
typedef struct mt_cache_key {
    const mt_ring *p, *q;
    mt_frame frame_p, frame_q;
    mt_cost_weights weights;
    bool joined; /* aligned finely and fitted into a contour pair; otherwise only the cost was found */
} mt_cache_key;

typedef struct mt_cache_entry {
    mt_cache_key key; /* its rings have to outlive the cache */
    uint64_t hash;
    double cost;          /* the alignment's mean step cost */
    mt_contour_pair pair; /* where key.joined */
    struct mt_cache_entry *next;
} mt_cache_entry;

enum { MT_CACHE_BUCKETS = 256 };

/* All zero: empty. */
struct mt_alignment_cache {
    mt_cache_entry *buckets[MT_CACHE_BUCKETS];
};

/* The entry with the same points, marks, frames and weights; NULL where there is none, or `cache` is NULL. */
const mt_cache_entry *mt_alignment_cache_find(const mt_alignment_cache *cache, const mt_cache_key *key);

/* Adds an entry; `pair` is NULL for a cost alone. Does nothing where `cache` is NULL. MT_NO_MEMORY. */
mt_status mt_alignment_cache_add(mt_alignment_cache *cache, const mt_cache_key *key, double cost,
                                 const mt_contour_pair *pair, mt_arena *arena);
