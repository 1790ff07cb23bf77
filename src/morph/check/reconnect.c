/* Reconnecting parts of an in-between that separate though an end has them in one component.
 *
 *     A ┌───────┐     T = 0.5  ┌──┐ ┌───┐      the smaller part is displaced across the gap, and 1, 4 or 12/1000 em further, so that
 *       └───────┘              └──┘ └───┘      the two overlap; where that does not help, the larger part
 *
 * The displacement half-way is the gap over 2 · min(T, 1 − T), and at most FARTHEST. It stays where the place has fewer components and the
 * morph less error. Invariants: those of mend.c. O(n²) for the gap between borders of n points. */
#include "morph/check/reconnect.h"

#include <math.h>

#include "geometry/inside.h"
#include "geometry/limits.h"
#include "morph/check/contour_origin.h"
#include "morph/fit/contour_pair.h"

/* The longest displacement half-way, 1/1000 em. A longer one would be seen. */
#define FARTHEST 32.0

/* Added to the gap, 1/1000 em: a longer overlap connects more safely, a shorter one changes less. */
static const double overlaps[] = {1, 4, 12};
enum { OVERLAPS = sizeof overlaps / sizeof *overlaps };

/* The same at all places. */
typedef struct mt_connections {
    mt_contour_origins origins;
    int most; /* the most components that an end has */
} mt_connections;

/* The morph at one place. */
typedef struct mt_place {
    mt_mending *m;
    const mt_connections *connections;
    double t;
    mt_shape shape;
    int *part_of; /* of each contour, the component of the shape that it is in */
} mt_place;

/* The gap between two parts that an end has in one. */
typedef struct mt_gap {
    int part;      /* the one that is displaced */
    mt_point way;  /* from it to the other, where they are nearest */
    double length; /* of the way, grid units */
} mt_gap;

/* ---- a place ------------------------------------------------------------------------------------------------- */

static mt_status look(mt_mending *m, const mt_connections *connections, double t, mt_place *place) {
    size_t count = (size_t)m->morph->contour_count;
    *place = (mt_place){
        .m = m, .connections = connections, .t = t, .part_of = mt_arena_new(m->arena, count, sizeof(int))};
    if (!place->part_of) return MT_NO_MEMORY;
    mt_status status = mt_mend_shape(m, t, MT_NONZERO, &place->shape);
    for (int i = 0; status == MT_OK && i < m->morph->contour_count; i++) {
        mt_contour contour;
        status = mt_contour_pair_mix(&m->morph->contours[i], mt_weights_at(t), m->arena, &contour);
        if (status == MT_OK) place->part_of[i] = mt_component_at(&place->shape, contour.segments[0].end);
    }
    return status;
}

/* Whether two parts have contours of one component of an end. */
static bool belong_together(const mt_place *s, int part, int other) {
    for (int i = 0; i < s->m->morph->contour_count; i++)
        for (int k = 0; s->part_of[i] == part && k < s->m->morph->contour_count; k++)
            if (s->part_of[k] == other && mt_same_origin(&s->connections->origins, i, k)) return true;
    return false;
}

static mt_gap gap_between(const mt_place *s, int part, int other) {
    const mt_component *p = &s->shape.components[part], *q = &s->shape.components[other];
    mt_gap gap = {part, {0, 0}, INFINITY};
    for (int i = 0; i < p->count; i++)
        for (int k = 0; k < q->count; k++) {
            mt_point way;
            double length = mt_ring_gap(&p->rings[i], &q->rings[k], &way);
            if (length < gap.length) gap = (mt_gap){part, way, length};
        }
    return gap;
}

/* ---- displacing ---------------------------------------------------------------------------------------------- */

static bool may_shift(const mt_place *s, int part, mt_point by) {
    for (int i = 0; i < s->m->morph->contour_count; i++) {
        mt_point at = s->m->morph->contours[i].displacement;
        double x = (double)at.x + by.x, y = (double)at.y + by.y;
        if (s->part_of[i] == part && x * x + y * y > mt_grid_units(FARTHEST) * mt_grid_units(FARTHEST))
            return false;
    }
    return true;
}

/* The displacement half-way that closes the gap at this place. */
static mt_point closing(const mt_place *s, const mt_gap *gap, double overlap) {
    double times = (1 + mt_grid_units(overlap) / gap->length) / (2 * fmin(s->t, 1 - s->t));
    return (mt_point){(int32_t)lround(gap->way.x * times), (int32_t)lround(gap->way.y * times)};
}

/* Whether there are fewer parts at this place now. */
static mt_status is_closed(const mt_place *s, bool *closed) {
    mt_shape shape;
    mt_arena_place before = mt_arena_mark(s->m->arena);
    mt_status status = mt_mend_shape(s->m, s->t, MT_NONZERO, &shape);
    *closed = status == MT_OK && mt_topology_of(&shape).components < mt_topology_of(&s->shape).components;
    mt_arena_rewind(s->m->arena, before);
    return status;
}

/* Displaces one part to the other, if that closes the gap and leaves less error. */
static mt_status bring_nearer(const mt_place *s, const mt_gap *gap) {
    for (int i = 0; i < OVERLAPS && mt_mend_goes_on(s->m); i++) {
        bool closed, better = false;
        mt_point to = closing(s, gap, overlaps[i]);
        if (!may_shift(s, gap->part, to)) continue;
        mt_shift(s->m->morph, s->part_of, gap->part, to);
        mt_status status = is_closed(s, &closed);
        if (status == MT_OK && closed) status = mt_mend_compare(s->m, &better);
        if (better) return status;
        mt_shift(s->m->morph, s->part_of, gap->part, (mt_point){-to.x, -to.y});
        if (status != MT_OK) return status;
    }
    return MT_OK;
}

/* Closes one gap of a place: the smaller part is displaced or, where that does not help, the larger. */
static mt_status close_one(const mt_place *s) {
    mt_status status = MT_OK;
    int before = s->m->error.parts;
    for (int p = 0; p < s->shape.count; p++)
        for (int q = 0; q < s->shape.count; q++) {
            const mt_component *part = &s->shape.components[p], *other = &s->shape.components[q];
            if (p == q || mt_component_area2(part) > mt_component_area2(other) || !belong_together(s, p, q))
                continue;
            mt_gap gap = gap_between(s, p, q);
            if (gap.length <= 0) continue;
            status = bring_nearer(s, &gap);
            gap = (mt_gap){q, {-gap.way.x, -gap.way.y}, gap.length};
            if (status == MT_OK && s->m->error.parts == before) status = bring_nearer(s, &gap);
            if (status != MT_OK || s->m->error.parts < before) return status;
        }
    return MT_OK;
}

/* *closed: no gap is left at a place. */
static mt_status close_at(mt_mending *m, const void *stage, double t, bool *closed) {
    const mt_connections *connections = stage;
    int before;
    do {
        mt_place place;
        before = m->error.parts;
        mt_status status = look(m, connections, t, &place);
        if (status != MT_OK) return status;
        *closed = mt_topology_of(&place.shape).components <= connections->most;
        if (!*closed) status = close_one(&place);
        if (status != MT_OK) return status;
    } while (m->error.parts < before);
    return MT_OK;
}

mt_status mt_reconnect_parts(mt_mending *m) {
    int in_a = mt_topology_of(&m->morph->a.whole).components,
        in_b = mt_topology_of(&m->morph->b.whole).components;
    mt_connections connections = {.most = in_a > in_b ? in_a : in_b};
    mt_status status = mt_contour_origins_of(m->morph, m->arena, &connections.origins);
    return status == MT_OK ? mt_mend_outwards(m, close_at, &connections) : status;
}
