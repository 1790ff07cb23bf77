/* Repairing the topology of a morph: the state and the steps that its stages share. */
#pragma once

#include "geometry/union.h"
#include "morph/check/topology.h"

typedef struct mt_mending {
    mt_morph *morph;
    const mt_params *params;
    mt_arena *arena;
    mt_topology_error error; /* of the morph as it is */
    int64_t effort;          /* corners of blends that may still be looked at */
} mt_mending;

/* Finds the error to begin with. As mt_morph_blend. */
mt_status mt_mend_begin(mt_mending *m);

/* Whether there is error left, and effort. */
bool mt_mend_goes_on(const mt_mending *m);

/* *better: the morph, changed since, has less error, which is in m->error then. As mt_morph_blend. */
mt_status mt_mend_compare(mt_mending *m, bool *better);

/* A union, and the ink at a place, both without marks, counted as effort. As mt_union_unmarked and mt_morph_blend. */
mt_status mt_mend_union(mt_mending *m, const mt_rings *rings, mt_rule rule, mt_shape *shape);
mt_status mt_mend_shape(mt_mending *m, double t, mt_rule rule, mt_shape *shape);

/* A stage at one place. *closed: its kind of error is gone there, or less. */
typedef mt_status (*mt_mend_place)(mt_mending *m, const void *stage, double t, bool *closed);

/* A stage at one place after the other: from half-way, where displacements are largest, outwards, as long as places are closed. */
mt_status mt_mend_outwards(mt_mending *m, mt_mend_place mend, const void *stage);
