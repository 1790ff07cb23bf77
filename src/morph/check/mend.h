/* Mending a morph that strays on the way: what the stages of it part. */
#ifndef MT_MORPH_CHECK_MEND_H
#define MT_MORPH_CHECK_MEND_H

#include "geometry/union.h"
#include "morph/check/topology.h"

typedef struct mt_mending {
    mt_morph *morph;
    const mt_params *params;
    mt_arena *arena;
    mt_topology_error by; /* how the morph strays as it is */
    int64_t effort;       /* how many corners of blends may still be looked at */
} mt_mending;

/* Finds how the morph strays to begin with. As mt_morph_blend. */
mt_status mt_mend_begin(mt_mending *m);

/* Whether there is something left to mend, and effort to do it with. */
bool mt_mend_goes_on(const mt_mending *m);

/* *better: the morph, changed since, strays less; m->by says how then. As mt_morph_blend. */
mt_status mt_mend_compare(mt_mending *m, bool *better);

/* A union, and the ink at a place, that the effort is charged with, both without marks. As mt_union_unmarked and mt_morph_blend. */
mt_status mt_mend_union(mt_mending *m, const mt_rings *rings, mt_rule rule, mt_shape *shape);
mt_status mt_mend_shape(mt_mending *m, double t, mt_rule rule, mt_shape *shape);

/* What a stage does at one place. *closed: what it is for is not amiss there any more, or less than it was. */
typedef mt_status (*mt_mend_place)(mt_mending *m, const void *stage, double t, bool *closed);

/* Does it at one place after the other: from half-way, where contours stand aside the most, outwards; as long as that goes. */
mt_status mt_mend_outwards(mt_mending *m, mt_mend_place mend, const void *stage);

#endif
