/* What was found of pairs of rings before: while cuts and settings are tried, most rings stay what they were. */
#ifndef MT_MORPH_ALIGN_CACHE_H
#define MT_MORPH_ALIGN_CACHE_H

#include <stdint.h>

#include "geometry/ring.h"
#include "morph/model/morph.h"
#include "morph/model/settings.h"

/* What an alignment without pins depends on. */
typedef struct mt_cache_key {
    const mt_ring *p, *q;
    mt_box box_p, box_q;
    mt_cost_weights weights;
    bool joined; /* aligned finely and fitted, not only costed */
} mt_cache_key;

typedef struct mt_cache_entry {
    mt_cache_key of; /* the rings have to stay */
    uint64_t hash;
    double cost;             /* of the alignment, the mean of its steps */
    mt_contour_pair masters; /* where it was joined */
    struct mt_cache_entry *next;
} mt_cache_entry;

enum { MT_CACHE_BUCKETS = 256 };

/* All zero: nothing known yet. */
struct mt_alignment_cache {
    mt_cache_entry *buckets[MT_CACHE_BUCKETS];
};

/* What is known of a case with the same points, marks, boxes and weights; NULL: nothing, or there is no `known`. */
const mt_cache_entry *mt_alignment_cache_find(const mt_alignment_cache *known, const mt_cache_key *of);

/* Nothing where there is no `known`. `masters` is NULL for a cost. MT_NO_MEMORY. */
mt_status mt_alignment_cache_add(mt_alignment_cache *known, const mt_cache_key *of, double cost,
                                 const mt_contour_pair *masters, mt_arena *arena);

#endif
