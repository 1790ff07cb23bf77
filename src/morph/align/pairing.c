/* Pairs of rings by assignment (assign.h): the costs of a matrix are the mean step costs of alignments over SAMPLES coarse samples a
 * ring, found once for each pair and kept in the cache. Rings whose middles lie further apart than APART_MOST boxes are not aligned at
 * all. Leaving two rings unpaired costs `most`, so that no pair costs more. O(k l m² + k² l) for k and l rings of m samples. */
#include "morph/align/pairing.h"

#include <math.h>

#include "arithmetic/angles.h"
#include "morph/align/assign.h"
#include "morph/align/cache.h"

#define SAMPLES 60.0    /* of a ring, at least: enough to tell rings apart, not to draw them */
#define APART_MOST 0.35 /* between the middles of two rings, at most, in boxes */
#define FORBIDDEN 100.0 /* cost of a pair that may not be: more than any alignment costs */

/* The distance between the middles of two rings, each seen in its frame. */
static double apart(const mt_ring *p, const mt_frame *frame_p, const mt_ring *q, const mt_frame *frame_q) {
    mt_box a = mt_ring_box(p), b = mt_ring_box(q);
    mt_sample_view u =
        mt_view_of_place(frame_p, (a.min.x + (double)a.max.x) / 2, (a.min.y + (double)a.max.y) / 2);
    mt_sample_view v =
        mt_view_of_place(frame_q, (b.min.x + (double)b.max.x) / 2, (b.min.y + (double)b.max.y) / 2);
    return mt_hypot(u.x - v.x, u.y - v.y);
}

static mt_status find_cost(const mt_cache_key *key, double flatness, mt_arena *arena, double *cost) {
    mt_arena_place before = mt_arena_mark(arena);
    mt_ring_samples a, b;
    mt_alignment alignment;
    mt_status status = mt_ring_samples_at_least(key->p, flatness, SAMPLES, arena, &a);
    if (status == MT_OK) status = mt_ring_samples_at_least(key->q, flatness, SAMPLES, arena, &b);
    if (status == MT_OK)
        status =
            mt_align(&a, &key->frame_p, &b, &key->frame_q, &key->weights, &(mt_links){0}, arena, &alignment);
    if (status == MT_OK) *cost = alignment.cost;
    mt_arena_rewind(arena, before);
    return status;
}

mt_status mt_pair_cost(const mt_ring *p, const mt_frame *frame_p, const mt_ring *q, const mt_frame *frame_q,
                       const mt_settings *settings, mt_arena *arena, double *cost) {
    mt_cache_key key = {p, q, *frame_p, *frame_q, settings->align, false};
    const mt_cache_entry *found = mt_alignment_cache_find(settings->cache, &key);
    if (found) {
        *cost = found->cost;
        return MT_OK;
    }
    mt_status status = find_cost(&key, settings->flatness, arena, cost);
    return status == MT_OK ? mt_alignment_cache_add(settings->cache, &key, *cost, NULL, arena) : status;
}

typedef struct mt_pairing_costs {
    int rows, columns;
    double *costs; /* rows × columns; INFINITY for a pair that may not be */
} mt_pairing_costs;

static mt_status cost_all(const mt_ring_list *a, const mt_ring_list *b, double most,
                          const mt_settings *settings, mt_arena *arena, mt_pairing_costs *p) {
    *p = (mt_pairing_costs){a->count, b->count, NULL};
    p->costs = mt_arena_new(arena, (size_t)a->count * (size_t)b->count, sizeof *p->costs);
    if (!p->costs) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (int i = 0; i < p->rows; i++)
        for (int j = 0; status == MT_OK && j < p->columns; j++) {
            double *cost = &p->costs[(size_t)i * (size_t)p->columns + (size_t)j];
            *cost = INFINITY;
            if (!mt_arena_spend(arena, a->rings[i]->count + b->rings[j]->count)) return MT_TOO_LARGE;
            if (apart(a->rings[i], &a->frame, b->rings[j], &b->frame) > APART_MOST) continue;
            status = mt_pair_cost(a->rings[i], &a->frame, b->rings[j], &b->frame, settings, arena, cost);
            if (*cost > most) *cost = INFINITY;
        }
    return status;
}

/* The cost of a pair in the assignment: no more than that of leaving both unpaired. */
static double capped_cost(double cost, double most) {
    return fmin(cost, fmin(most, FORBIDDEN));
}

static mt_status assign_rest(const mt_pairing_costs *p, double most, mt_arena *arena, int *partner_a,
                             int *partner_b) {
    size_t cells = (size_t)p->rows * (size_t)p->columns;
    int fewer = p->rows < p->columns ? p->rows : p->columns;
    if (!mt_arena_spend(arena, (int64_t)cells * fewer)) return MT_TOO_LARGE;
    double *costs = mt_arena_new(arena, cells, sizeof *costs);
    int *column_of = mt_arena_new(arena, (size_t)p->rows, sizeof *column_of);
    if (!costs || !column_of) return MT_NO_MEMORY;
    for (int i = 0; i < p->rows; i++)
        for (int j = 0; j < p->columns; j++) {
            size_t cell = (size_t)i * (size_t)p->columns + (size_t)j;
            bool open = partner_a[i] < 0 && partner_b[j] < 0;
            costs[cell] = capped_cost(open ? p->costs[cell] : INFINITY, most);
        }
    mt_status status = mt_assign(costs, p->rows, p->columns, arena, column_of);
    for (int i = 0; status == MT_OK && i < p->rows; i++) {
        int j = column_of[i];
        if (j < 0 || partner_a[i] >= 0 || partner_b[j] >= 0) continue;
        if (p->costs[(size_t)i * (size_t)p->columns + (size_t)j] == INFINITY) continue;
        partner_a[i] = j;
        partner_b[j] = i;
    }
    return status;
}

mt_status mt_pair_rings(const mt_ring_list *a, const mt_ring_list *b, double most,
                        const mt_settings *settings, mt_arena *arena, int *partner_a, int *partner_b) {
    if (a->count == 0 || b->count == 0) return MT_OK;
    mt_pairing_costs costs;
    mt_status status = cost_all(a, b, most, settings, arena, &costs);
    return status == MT_OK ? assign_rest(&costs, most, arena, partner_a, partner_b) : status;
}

mt_status mt_outer_rings(const mt_shape *shape, const mt_frame *frame, mt_arena *arena, mt_ring_list *list) {
    *list =
        (mt_ring_list){shape->count, mt_arena_new(arena, (size_t)shape->count, sizeof(mt_ring *)), *frame};
    if (!list->rings) return MT_NO_MEMORY;
    for (int i = 0; i < shape->count; i++) list->rings[i] = &shape->components[i].rings[0];
    return MT_OK;
}
