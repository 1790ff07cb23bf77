/* The steps of repairing a morph's topology: a stage displaces contours half-way, and a displacement stays only where the error of the whole
 * morph is less then. Invariants: the error never grows; effort falls with each corner of a blend looked at, and nothing is looked at
 * without effort left, so that the work is bounded on any glyph and the same on any machine. */
#include "morph/check/mend.h"

#include <limits.h>

#include "geometry/limits.h"
#include "morph/between/instance.h"

static mt_status look(mt_mending *m, int enough, mt_topology_error *error) {
    mt_status status = mt_morph_topology_error(m->morph, enough, m->params, m->arena, error);
    if (status == MT_OK) m->effort -= error->corners;
    return status;
}

mt_status mt_mend_begin(mt_mending *m) {
    return look(m, INT_MAX, &m->error);
}

bool mt_mend_goes_on(const mt_mending *m) {
    return m->error.parts > 0 && m->effort > 0;
}

mt_status mt_mend_compare(mt_mending *m, bool *better) {
    mt_topology_error error;
    mt_status status = look(m, m->error.parts, &error);
    *better = status == MT_OK && error.parts < m->error.parts;
    if (*better) m->error = error;
    return status;
}

mt_status mt_mend_union(mt_mending *m, const mt_rings *rings, mt_rule rule, mt_shape *shape) {
    m->effort -= mt_rings_corners(rings);
    return mt_union_unmarked(rings, rule, m->arena, shape);
}

mt_status mt_mend_shape(mt_mending *m, double t, mt_rule rule, mt_shape *shape) {
    mt_rings rings;
    mt_status status = mt_morph_rings(m->morph, mt_weights_at(t), m->params, m->arena, &rings);
    return status == MT_OK ? mt_mend_union(m, &rings, rule, shape) : status;
}

mt_status mt_mend_outwards(mt_mending *m, mt_mend_place mend, const void *stage) {
    mt_status status = MT_OK;
    bool closed = true;
    for (int i = 0; status == MT_OK && closed && mt_mend_goes_on(m) && i < MT_TOPOLOGY_STEPS; i++)
        status = mend(m, stage, mt_topology_position(m->morph, i), &closed);
    return status;
}
