#include "morph/check/reconnect.h"

#include <math.h>

#include "geometry/inside.h"
#include "geometry/limits.h"
#include "morph/check/contour_origin.h"
#include "morph/fit/contour_pair.h"

/* How far contours may be drawn half-way, 1/1000 em. More would be seen. */
#define FARTHEST 32.0

/* By how much more than the gap, 1/1000 em. The more, the firmer the join; the less, the less else is touched. */
static const double laps[] = {1, 4, 12};
enum { LAPS = sizeof laps / sizeof *laps };

/* What does not change with the place. */
typedef struct mt_whole {
    mt_contour_origins origins;
    int most; /* the most components that an end has */
} mt_whole;

/* The morph at one place. */
typedef struct mt_scene {
    mt_mending *m;
    const mt_whole *whole;
    double t;
    mt_shape shape;
    int *part_of; /* of each contour, the component of the shape that it is in */
} mt_scene;

/* Two parts of a scene that an end has in one. */
typedef struct mt_rift {
    int part;     /* the one that is to come nearer */
    mt_point way; /* from it to the other, where they are nearest */
    double gap;   /* its length, grid units */
} mt_rift;

/* ---- a place ------------------------------------------------------------------------------------------------- */

static mt_status look(mt_mending *m, const mt_whole *whole, double t, mt_scene *scene) {
    size_t count = (size_t)m->morph->contour_count;
    *scene =
        (mt_scene){.m = m, .whole = whole, .t = t, .part_of = mt_arena_new(m->arena, count, sizeof(int))};
    if (!scene->part_of) return MT_NO_MEMORY;
    mt_status status = mt_mend_shape(m, t, MT_NONZERO, &scene->shape);
    for (int i = 0; status == MT_OK && i < m->morph->contour_count; i++) {
        mt_contour contour;
        status = mt_contour_pair_mix(&m->morph->contours[i], mt_weights_at(t), m->arena, &contour);
        if (status == MT_OK) scene->part_of[i] = mt_component_at(&scene->shape, contour.segments[0].end);
    }
    return status;
}

/* Whether two parts have contours of one component of an end. */
static bool belong_together(const mt_scene *s, int part, int other) {
    for (int i = 0; i < s->m->morph->contour_count; i++)
        for (int k = 0; k < s->m->morph->contour_count; k++)
            if (s->part_of[i] == part && s->part_of[k] == other && mt_same_origin(&s->whole->origins, i, k))
                return true;
    return false;
}

static mt_rift rift_between(const mt_scene *s, int part, int other) {
    const mt_component *p = &s->shape.components[part], *q = &s->shape.components[other];
    mt_rift rift = {part, {0, 0}, INFINITY};
    for (int i = 0; i < p->count; i++)
        for (int k = 0; k < q->count; k++) {
            mt_point way;
            double gap = mt_ring_gap(&p->rings[i], &q->rings[k], &way);
            if (gap < rift.gap) rift = (mt_rift){part, way, gap};
        }
    return rift;
}

/* ---- drawing nearer ------------------------------------------------------------------------------------------ */

static bool may_shift(const mt_scene *s, int part, mt_point by) {
    for (int i = 0; i < s->m->morph->contour_count; i++) {
        mt_point at = s->m->morph->contours[i].displacement;
        double x = (double)at.x + by.x, y = (double)at.y + by.y;
        if (s->part_of[i] == part && x * x + y * y > mt_grid_units(FARTHEST) * mt_grid_units(FARTHEST))
            return false;
    }
    return true;
}

/* How far a part has to come half-way, that the gap is closed at the scene's place. */
static mt_point closing(const mt_scene *s, const mt_rift *rift, double lap) {
    double times = (1 + mt_grid_units(lap) / rift->gap) / (2 * fmin(s->t, 1 - s->t));
    return (mt_point){(int32_t)lround(rift->way.x * times), (int32_t)lround(rift->way.y * times)};
}

/* Whether there are fewer parts at the scene's place now. */
static mt_status is_closed(const mt_scene *s, bool *closed) {
    mt_shape shape;
    mt_arena_place before = mt_arena_mark(s->m->arena);
    mt_status status = mt_mend_shape(s->m, s->t, MT_NONZERO, &shape);
    *closed = status == MT_OK && mt_topology_of(&shape).components < mt_topology_of(&s->shape).components;
    mt_arena_rewind(s->m->arena, before);
    return status;
}

/* Draws the one part to the other, if the gap is closed then and the glyph strays less. */
static mt_status draw(const mt_scene *s, const mt_rift *rift) {
    for (int i = 0; i < LAPS && mt_mend_goes_on(s->m); i++) {
        bool closed, better = false;
        mt_point to = closing(s, rift, laps[i]);
        if (!may_shift(s, rift->part, to)) continue;
        mt_shift(s->m->morph, s->part_of, rift->part, to);
        mt_status status = is_closed(s, &closed);
        if (status == MT_OK && closed) status = mt_mend_compare(s->m, &better);
        if (status != MT_OK || better) return status;
        mt_shift(s->m->morph, s->part_of, rift->part, (mt_point){-to.x, -to.y});
    }
    return MT_OK;
}

/* Closes one rift of a scene: the smaller part comes nearer or, where that does not help, the larger. */
static mt_status close_one(const mt_scene *s) {
    mt_status status = MT_OK;
    int before = s->m->by.parts;
    for (int p = 0; p < s->shape.count; p++)
        for (int q = 0; q < s->shape.count; q++) {
            const mt_component *part = &s->shape.components[p], *other = &s->shape.components[q];
            if (p == q || mt_component_area2(part) > mt_component_area2(other) || !belong_together(s, p, q))
                continue;
            mt_rift rift = rift_between(s, p, q);
            if (rift.gap <= 0) continue;
            status = draw(s, &rift);
            rift = (mt_rift){q, {-rift.way.x, -rift.way.y}, rift.gap};
            if (status == MT_OK && s->m->by.parts == before) status = draw(s, &rift);
            if (status != MT_OK || s->m->by.parts < before) return status;
        }
    return MT_OK;
}

/* *closed: no rift is left at a place. */
static mt_status close_at(mt_mending *m, const void *stage, double t, bool *closed) {
    const mt_whole *whole = stage;
    int before;
    do {
        mt_scene scene;
        before = m->by.parts;
        mt_status status = look(m, whole, t, &scene);
        if (status != MT_OK) return status;
        *closed = mt_topology_of(&scene.shape).components <= whole->most;
        if (!*closed) status = close_one(&scene);
        if (status != MT_OK) return status;
    } while (m->by.parts < before);
    return MT_OK;
}

mt_status mt_reconnect_parts(mt_mending *m) {
    int in_a = mt_topology_of(&m->morph->a.whole).components,
        in_b = mt_topology_of(&m->morph->b.whole).components;
    mt_whole whole = {.most = in_a > in_b ? in_a : in_b};
    mt_status status = mt_contour_origins_of(m->morph, m->arena, &whole.origins);
    return status == MT_OK ? mt_mend_outwards(m, close_at, &whole) : status;
}
