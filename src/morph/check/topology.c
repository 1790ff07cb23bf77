/* Counting components and holes at MT_TOPOLOGY_STEPS places between the ends, and comparing them with both ends'.
 *
 *     A: 2 components       in-between: 3       B: 1 component       error 1: the range of the ends is 1 … 2
 *     A: 1 hole             in-between: 0       B: 1 hole            error 1, of which 1 opened
 *
 * A place with an error is looked at again with chords MT_OVERLAP_CARE times as fine, since chords may touch where curves do not. Seams
 * and crumbs do not count. Invariant: 0 for a morph from a shape to itself. O(n log n) in practice for n corners at each place. */
#include "morph/check/topology.h"

#include <math.h>

#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/between/instance.h"

/* ---- one shape ------------------------------------------------------------------------------------------- */

/* Twice an area in grid units squared, in square thousandths of the em. */
static double thousandths(int64_t area2) {
    return (double)area2 / 2 / (MT_EM / 1000.0) / (MT_EM / 1000.0);
}

static bool is_seam(const mt_ring *ring) {
    return fabs((double)mt_ring_area2(ring)) < MT_SEAM_WIDTH * mt_ring_length(ring);
}

static void count_part(int64_t area2, int *parts, int *crumbs) {
    if (thousandths(area2) >= MT_CRUMB)
        ++*parts;
    else
        ++*crumbs;
}

mt_topology mt_topology_of(const mt_shape *shape) {
    mt_topology topology = {.area = thousandths(mt_shape_area2(shape)) / 1e6};
    for (int k = 0; k < shape->count; k++) {
        const mt_component *component = &shape->components[k];
        if (!is_seam(&component->rings[0]))
            count_part(mt_component_area2(component), &topology.components, &topology.crumbs);
        for (int i = 1; i < component->count; i++)
            if (!is_seam(&component->rings[i]))
                count_part(-mt_ring_area2(&component->rings[i]), &topology.holes, &topology.crumbs);
    }
    return topology;
}

/* ---- on the way ------------------------------------------------------------------------------------------ */

int mt_count_excess(int count, int a, int b) {
    int least = a < b ? a : b, most = a < b ? b : a;
    return count > most ? count - most : count < least ? least - count : 0;
}

double mt_area_excess(double area, double a, double b) {
    double most = fmax(a, b), least = fmin(a, b);
    return most > 0 ? fmax(0, fmax(area - most, least - area)) / most : 0;
}

double mt_topology_position(const mt_morph *morph, int number) {
    int from_half = (number + 1) / 2, half = (MT_TOPOLOGY_STEPS + 1) / 2;
    bool before = (number % 2 != 0) == (mt_shape_area2(&morph->a.whole) >= mt_shape_area2(&morph->b.whole));
    return (double)(before ? half - from_half : half + from_half) / (MT_TOPOLOGY_STEPS + 1);
}

static int fewer_than_both(int count, int a, int b) {
    return count < a && count < b ? mt_count_excess(count, a, b) : 0;
}

static mt_topology_error error_of(const mt_topology *at, const mt_topology *a, const mt_topology *b) {
    return (mt_topology_error){.parts = mt_count_excess(at->components, a->components, b->components) +
                                        mt_count_excess(at->holes, a->holes, b->holes),
                               .merged = fewer_than_both(at->components, a->components, b->components),
                               .opened = fewer_than_both(at->holes, a->holes, b->holes),
                               .ink = mt_area_excess(at->area, a->area, b->area)};
}

static mt_topology_error worse(mt_topology_error p, mt_topology_error q) {
    return q.parts > p.parts ? q : p;
}

/* At one place, flattened within the params' tolerance: as it is drawn and, where rings lie over one another, as it is meant. */
static mt_status error_at(const mt_morph *morph, const mt_topology ends[2], double t, const mt_params *params,
                          mt_arena *arena, mt_topology_error *error) {
    mt_arena_place before = mt_arena_mark(arena);
    mt_rings rings;
    mt_shape drawn, meant;
    mt_topology at;
    mt_status status = mt_morph_rings(morph, mt_weights_at(t), params, arena, &rings);
    if (status == MT_OK) status = mt_union_unmarked(&rings, MT_NONZERO, arena, &drawn);
    if (status == MT_OK) {
        at = mt_topology_of(&drawn);
        *error = error_of(&at, &ends[0], &ends[1]);
    }
    if (status == MT_OK && mt_component_area2(&rings) != mt_shape_area2(&drawn)) {
        status = mt_union_unmarked(&rings, MT_POSITIVE, arena, &meant);
        if (status == MT_OK) at = mt_topology_of(&meant);
        if (status == MT_OK) *error = worse(*error, error_of(&at, &ends[0], &ends[1]));
    }
    if (status == MT_OK) error->corners = mt_rings_corners(&rings);
    mt_arena_rewind(arena, before);
    return status;
}

/* Chords may touch where the curves do not: what strays is looked at again, more finely. */
mt_status mt_morph_topology_error(const mt_morph *morph, int enough, const mt_params *params, mt_arena *arena,
                                  mt_topology_error *error) {
    const mt_topology ends[] = {mt_topology_of(&morph->a.whole), mt_topology_of(&morph->b.whole)};
    mt_params fine = *params;
    mt_topology_error all = {0};
    fine.tolerance /= MT_OVERLAP_CARE;
    for (int i = 0; all.parts < enough && i < MT_TOPOLOGY_STEPS; i++) {
        mt_topology_error here;
        double t = mt_topology_position(morph, i);
        mt_status status = error_at(morph, ends, t, params, arena, &here);
        if (status == MT_OK) all.corners += here.corners;
        if (status == MT_OK && here.parts > 0) {
            status = error_at(morph, ends, t, &fine, arena, &here);
            all.corners += here.corners;
        }
        if (status != MT_OK) return status;
        all.parts += here.parts;
        all.merged += here.merged;
        all.opened += here.opened;
        all.ink = fmax(all.ink, here.ink);
    }
    *error = all;
    return MT_OK;
}
