/* What was found of pairs of rings before: while cuts and manners are tried, most rings stay what they were. */
#ifndef MT_KNOWN_H
#define MT_KNOWN_H

#include <stdint.h>

#include "geometry/ring.h"
#include "morph/model/morph.h"
#include "morph/model/settings.h"

/* What an alignment without pins depends on. */
typedef struct mt_known_case {
    const mt_ring *p, *q;
    mt_box box_p, box_q;
    mt_tariff tariff;
    bool joined; /* aligned finely and fitted, not only priced */
} mt_known_case;

typedef struct mt_known_pair {
    mt_known_case of; /* the rings have to stay */
    uint64_t hash;
    double cost;        /* of the alignment, the mean of its steps */
    mt_masters masters; /* where it was joined */
    struct mt_known_pair *next;
} mt_known_pair;

enum { MT_KNOWN_SHELVES = 256 };

/* All zero: nothing known yet. */
struct mt_known {
    mt_known_pair *shelves[MT_KNOWN_SHELVES];
};

/* What is known of a case with the same points, marks, boxes and tariff; NULL: nothing, or there is no `known`. */
const mt_known_pair *mt_known_find(const mt_known *known, const mt_known_case *of);

/* Nothing where there is no `known`. `masters` is NULL for a price. MT_NO_MEMORY. */
mt_status mt_known_add(mt_known *known, const mt_known_case *of, double cost, const mt_masters *masters,
                       mt_arena *arena);

#endif
