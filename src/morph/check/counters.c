/* Keeping holes closed that break open in between though both ends have them. The contour of an open hole is displaced half-way by the one of
 * the displacements (contour_origin.c) that leaves the least error. Invariants: those of mend.c. */
#include "morph/check/counters.h"

#include "geometry/limits.h"
#include "geometry/outline.h"
#include "morph/check/contour_origin.h"
#include "morph/fit/contour_pair.h"

/* ---- a place ------------------------------------------------------------------------------------------------- */

/* Holes as they are meant (MT_POSITIVE). */
static mt_status holes_at(mt_mending *m, double t, mt_shape *shape, int *holes) {
    mt_status status = mt_mend_shape(m, t, MT_POSITIVE, shape);
    if (status == MT_OK) *holes = mt_topology_of(shape).holes;
    return status;
}

static bool has_hole_of_area(const mt_shape *shape, int64_t area2) {
    for (int k = 0; k < shape->count; k++)
        for (int i = 1; i < shape->components[k].count; i++)
            if (mt_ring_area2(&shape->components[k].rings[i]) == area2) return true;
    return false;
}

/* Whether a contour bounds a hole, and the area within is not just a hole at this place. */
static mt_status is_open(const mt_mending *m, int contour, double t, const mt_shape *shape, bool *open) {
    const mt_contour_pair *masters = &m->morph->contours[contour];
    mt_contour mixed;
    mt_rings rings;
    *open = false;
    if (mt_contour_pair_area(masters) >= 0) return MT_OK;
    mt_status status = mt_contour_pair_mix(masters, mt_weights_at(t), m->arena, &mixed);
    if (status == MT_OK)
        status = mt_flatten(&(mt_outline){1, &mixed}, mt_grid_units(m->params->tolerance), m->arena, &rings);
    if (status == MT_OK) *open = !has_hole_of_area(shape, mt_ring_area2(&rings.rings[0]));
    return status;
}

/* ---- keeping clear ------------------------------------------------------------------------------------------- */

/* *better: there are more than `holes` at the place now, and the morph has less error. */
static mt_status look(mt_mending *m, double t, int holes, bool *better) {
    mt_arena_place before = mt_arena_mark(m->arena);
    mt_shape shape;
    int now = 0;
    mt_status status = holes_at(m, t, &shape, &now);
    mt_arena_rewind(m->arena, before);
    *better = false;
    return status == MT_OK && now > holes ? mt_mend_compare(m, better) : status;
}

/* Displaces a hole's contour as leaves the least error. */
static mt_status keep_clear(mt_mending *m, int hole, double t, int holes) {
    mt_contour_pair *contour = &m->morph->contours[hole];
    mt_point best = {0, 0};
    for (int i = 0; i < MT_DISPLACEMENTS && mt_mend_goes_on(m); i++) {
        bool better;
        mt_point way = mt_displacement(i);
        mt_shift_contour(contour, way);
        mt_status status = look(m, t, holes, &better);
        mt_shift_contour(contour, (mt_point){-way.x, -way.y});
        if (status != MT_OK) return status;
        if (better) best = way;
    }
    mt_shift_contour(contour, best);
    return MT_OK;
}

/* Keeps the holes that are open at a place. *closed: none are missing there, or there is less error now. */
static mt_status keep_at(mt_mending *m, const void *stage, double t, bool *closed) {
    const int *least = stage; /* the least holes that an end has */
    mt_shape shape;
    int holes, before = m->error.parts;
    mt_status status = holes_at(m, t, &shape, &holes);
    for (int i = 0; status == MT_OK && holes < *least && i < m->morph->contour_count; i++) {
        bool open;
        status = is_open(m, i, t, &shape, &open);
        if (status == MT_OK && open) status = keep_clear(m, i, t, holes);
    }
    *closed = status == MT_OK && (holes >= *least || m->error.parts < before);
    return status;
}

mt_status mt_keep_counters(mt_mending *m) {
    int in_a = mt_topology_of(&m->morph->a.whole).holes, in_b = mt_topology_of(&m->morph->b.whole).holes;
    int least = in_a < in_b ? in_a : in_b;
    return mt_mend_outwards(m, keep_at, &least);
}
