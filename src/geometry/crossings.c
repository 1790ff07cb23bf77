/* A sweep upwards over edges that are listed by their lower ends: each is compared with those that reach its height. */
#include "geometry/crossings.h"

#include <stdlib.h>

#include "geometry/limits.h"

/* What a corner, a crossing and a pair of edges at one height cost a union, in steps (base/memory.h). */
enum { CORNER_STEPS = 64, CROSSING_STEPS = 128, COMPARED_STEPS = 32 };

/* Pairs of edges that may be at one height, by bands; what each is taken to cost where these are few enough not to be counted, and the
 * share of the steps left up to which they are few. Most do not cross. */
enum { BANDS = 64, PAIR_STEPS = 8, PAIRS_SHARE = 4096 };

typedef struct mt_edge {
    mt_point low, high; /* by y */
} mt_edge;

static int compare_edges(const void *a, const void *b) {
    const mt_edge *p = a, *q = b;
    return (p->low.y > q->low.y) - (p->low.y < q->low.y);
}

static bool boxes_meet(const mt_edge *e, const mt_edge *f) {
    int32_t e_left = e->low.x < e->high.x ? e->low.x : e->high.x, e_right = e->low.x ^ e->high.x ^ e_left;
    int32_t f_left = f->low.x < f->high.x ? f->low.x : f->high.x, f_right = f->low.x ^ f->high.x ^ f_left;
    return e_left <= f_right && f_left <= e_right;
}

static int side_of(const mt_edge *e, mt_point p) {
    int64_t cross = mt_cross(e->low, e->high, e->low, p);
    return (cross > 0) - (cross < 0);
}

static bool cross(const mt_edge *e, const mt_edge *f) {
    return boxes_meet(e, f) && side_of(e, f->low) * side_of(e, f->high) < 0 &&
           side_of(f, e->low) * side_of(f, e->high) < 0;
}

static mt_status list_edges(const mt_rings *rings, mt_arena *arena, mt_edge **edges, size_t *count) {
    size_t made = 0;
    mt_edge *list = mt_arena_new(arena, (size_t)mt_rings_corners(rings) + 1, sizeof *list);
    if (!list) return MT_NO_MEMORY;
    for (int i = 0; i < rings->count; i++) {
        const mt_ring *ring = &rings->rings[i];
        for (int k = 0; k < ring->count; k++) {
            mt_point p = ring->points[k], q = ring->points[(k + 1) % ring->count];
            list[made++] = p.y <= q.y ? (mt_edge){p, q} : (mt_edge){q, p};
        }
    }
    qsort(list, made, sizeof *list, compare_edges);
    *edges = list;
    *count = made;
    return MT_OK;
}

/* To the nearest whole number, halves upwards; `below` > 0. */
static int32_t rounded_quotient(mt_wide above, mt_wide below) {
    mt_wide twice = 2 * above + below, quotient = twice / (2 * below);
    return (int32_t)(quotient - (twice % (2 * below) < 0));
}

/* Where two edges cross, rounded to the grid. */
static mt_point crossing_of(const mt_edge *e, const mt_edge *f) {
    mt_wide part = mt_cross(e->low, f->low, f->low, f->high),
            whole = mt_cross(e->low, e->high, f->low, f->high);
    if (whole < 0) {
        part = -part;
        whole = -whole;
    }
    mt_wide width = (mt_wide)e->high.x - e->low.x, height = (mt_wide)e->high.y - e->low.y;
    return (mt_point){e->low.x + rounded_quotient(width * part, whole),
                      e->low.y + rounded_quotient(height * part, whole)};
}

typedef struct mt_places {
    mt_arena *arena;
    mt_point *points;
    int count, room;
} mt_places;

static bool add_place(mt_places *places, mt_point p) {
    mt_point *points =
        mt_arena_grow_list(places->arena, places->points, places->count, &places->room, sizeof *points);
    if (!points) return false;
    places->points = points;
    points[places->count++] = p;
    return true;
}

/* Counts crossings, and lists their places unless `places` is NULL; what is compared for a list is paid. */
static mt_status sweep(const mt_rings *rings, int64_t most, mt_arena *arena, mt_places *places,
                       mt_crossings *crossings) {
    mt_edge *edges;
    size_t count, active_count = 0;
    mt_crossings met = {0};
    mt_status status = list_edges(rings, arena, &edges, &count);
    if (status != MT_OK) return status;
    const mt_edge **active = mt_arena_new(arena, count + 1, sizeof *active);
    if (!active) return MT_NO_MEMORY;
    for (size_t i = 0; i < count; i++) {
        size_t kept = 0;
        for (size_t k = 0; k < active_count; k++) {
            if (active[k]->high.y < edges[i].low.y) continue;
            active[kept++] = active[k];
            if (!cross(active[k], &edges[i])) continue;
            met.count++;
            if (places && !add_place(places, crossing_of(active[k], &edges[i]))) return MT_NO_MEMORY;
        }
        met.compared += (int64_t)active_count;
        if (places && !mt_arena_spend(arena, (int64_t)active_count)) return MT_TOO_LARGE;
        active[kept] = &edges[i];
        active_count = kept + 1;
        if (met.count > most || met.compared > MT_COMPARED_MAX) return MT_TOO_LARGE;
    }
    *crossings = met;
    return MT_OK;
}

mt_status mt_count_crossings(const mt_rings *rings, int64_t most, mt_arena *arena, mt_crossings *crossings) {
    return sweep(rings, most, arena, NULL, crossings);
}

mt_status mt_list_crossings(const mt_rings *rings, mt_arena *arena, mt_point **places, int *count) {
    mt_places found = {.arena = arena};
    mt_crossings met;
    mt_status status = sweep(rings, MT_POINTS_MAX, arena, &found, &met);
    if (status != MT_OK) return status;
    *places = found.points;
    *count = found.count;
    return MT_OK;
}

/* ---- what a union costs ------------------------------------------------------------------------------------- */

typedef struct mt_heights {
    int32_t low;
    int64_t each;         /* the height of a band */
    int64_t edges[BANDS]; /* that reach into each band */
} mt_heights;

static mt_heights heights_of(const mt_rings *rings) {
    int32_t low = INT32_MAX, high = INT32_MIN;
    for (int i = 0; i < rings->count; i++)
        for (int k = 0; k < rings->rings[i].count; k++) {
            int32_t y = rings->rings[i].points[k].y;
            low = y < low ? y : low;
            high = y > high ? y : high;
        }
    return (mt_heights){.low = low, .each = ((int64_t)high - low) / BANDS + 1};
}

static int band_of(const mt_heights *heights, int32_t y) {
    return (int)(((int64_t)y - heights->low) / heights->each);
}

/* The most pairs of edges that can be at one height: both of a pair reach into one band. O(n BANDS). */
static int64_t most_compared(const mt_rings *rings) {
    mt_heights heights = heights_of(rings);
    for (int i = 0; i < rings->count; i++) {
        const mt_ring *ring = &rings->rings[i];
        for (int k = 0; k < ring->count; k++) {
            int from = band_of(&heights, ring->points[k].y),
                to = band_of(&heights, ring->points[k + 1 < ring->count ? k + 1 : 0].y);
            for (int b = from < to ? from : to; b <= (from < to ? to : from); b++) heights.edges[b]++;
        }
    }
    int64_t pairs = 0;
    for (int b = 0; b < BANDS; b++) pairs += heights.edges[b] * (heights.edges[b] - 1) / 2;
    return pairs;
}

/* What a union costs beside its corners, in steps. Where there is little to cross it is not counted. */
static mt_status crossing_steps(const mt_rings *rings, mt_arena *arena, int64_t *steps) {
    int64_t pairs = most_compared(rings);
    mt_crossings met;
    if (pairs <= arena->steps / PAIRS_SHARE) {
        *steps = PAIR_STEPS * pairs;
        return MT_OK;
    }
    mt_arena_place before = mt_arena_mark(arena);
    mt_status status = mt_count_crossings(rings, arena->steps / CROSSING_STEPS, arena, &met);
    mt_arena_rewind(arena, before);
    *steps = status == MT_OK ? CROSSING_STEPS * met.count + COMPARED_STEPS * met.compared : INT64_MAX / 2;
    return status == MT_TOO_LARGE ? MT_OK : status;
}

mt_status mt_pay_for_union(const mt_rings *rings, mt_arena *arena) {
    int64_t steps;
    if (!arena->bounded || mt_rings_corners(rings) == 0) return MT_OK;
    if (mt_arena_is_spent(arena)) return MT_TOO_LARGE;
    mt_status status = crossing_steps(rings, arena, &steps);
    if (status != MT_OK) return status;
    bool paid = mt_arena_spend(arena, steps + CORNER_STEPS * (int64_t)mt_rings_corners(rings));
    return paid ? MT_OK : MT_TOO_LARGE;
}
