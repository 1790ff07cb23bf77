#include "morph/divide/reconcile.h"

#include <math.h>

#include "geometry/inside.h"
#include "geometry/limits.h"
#include "morph/align/pairing.h"

/* Rounds of cutting: a glyph that is joined otherwise in both fonts in two places needs two. */
enum { ROUNDS = 3 };

/* Parts whose alignment costs more (pairing.h) are not in order. */
#define POOR_MATCH 0.45

/* One side in a round: what it was cut into, and which of it is left for the next. */
typedef struct mt_round {
    const mt_side *side;
    mt_cut_side made, next;
    bool *left;
    int left_count;
    int *place; /* of each part that is not left, where it stands in the end */
} mt_round;

/* ---- what is left ------------------------------------------------------------------------------------------------ */

static mt_status is_dear(const mt_round heaps[2], int i, const mt_settings *settings, mt_arena *arena,
                         bool *costly) {
    double cost = 0;
    const mt_ring *p = &heaps[0].made.parts.components[i].rings[0],
                  *q = &heaps[1].made.parts.components[heaps[0].made.partner[i]].rings[0];
    mt_status status = mt_pair_cost(p, heaps[0].side->box, q, heaps[1].side->box, settings, arena, &cost);
    *costly = cost > POOR_MATCH;
    return status;
}

static mt_status tell_left(mt_round heaps[2], const mt_settings *settings, mt_arena *arena) {
    for (int s = 0; s < 2; s++) {
        const mt_cut_side *made = &heaps[s].made;
        heaps[s].left = mt_arena_new(arena, (size_t)made->parts.count, sizeof(bool));
        heaps[s].place = mt_arena_new(arena, (size_t)made->parts.count, sizeof(int));
        if (!heaps[s].left || !heaps[s].place) return MT_NO_MEMORY;
        for (int i = 0; i < made->parts.count; i++) heaps[s].left[i] = made->partner[i] < 0;
    }
    for (int i = 0; i < heaps[0].made.parts.count; i++) {
        bool costly = false;
        if (heaps[0].left[i]) continue;
        mt_status status = is_dear(heaps, i, settings, arena, &costly);
        if (status != MT_OK) return status;
        heaps[0].left[i] = heaps[1].left[heaps[0].made.partner[i]] = costly;
    }
    for (int s = 0; s < 2; s++)
        for (int i = 0; i < heaps[s].made.parts.count; i++) heaps[s].left_count += heaps[s].left[i];
    return MT_OK;
}

/* Whether another round would begin with something else than this one. */
static bool is_worth_while(const mt_round heaps[2]) {
    bool lonely = false, other = false;
    for (int s = 0; s < 2; s++) {
        for (int i = 0; i < heaps[s].made.parts.count; i++) lonely = lonely || heaps[s].made.partner[i] < 0;
        other = other || heaps[s].left_count != heaps[s].side->shape.count;
    }
    return lonely && other && heaps[0].left_count > 0 && heaps[1].left_count > 0;
}

/* The hints that both lead to something that is left. */
static mt_status hints_left(const mt_hints *hints, const mt_round heaps[2], mt_arena *arena, mt_hints *left) {
    mt_hint *kept = mt_arena_new(arena, (size_t)hints->count, sizeof *kept);
    if (!kept) return MT_NO_MEMORY;
    int count = 0;
    for (int i = 0; i < hints->count; i++) {
        int p = mt_component_at(&heaps[0].made.parts, hints->hints[i].a),
            q = mt_component_at(&heaps[1].made.parts, hints->hints[i].b);
        if (heaps[0].left[p] && heaps[1].left[q]) kept[count++] = hints->hints[i];
    }
    *left = (mt_hints){count, kept};
    return MT_OK;
}

static mt_status side_left(const mt_round *heap, mt_arena *arena, mt_side *side) {
    *side = (mt_side){.box = heap->side->box};
    side->shape.components = mt_arena_new(arena, (size_t)heap->left_count, sizeof(mt_component));
    if (!side->shape.components) return MT_NO_MEMORY;
    for (int i = 0; i < heap->made.parts.count; i++)
        if (heap->left[i]) side->shape.components[side->shape.count++] = heap->made.parts.components[i];
    return MT_OK;
}

/* ---- rounds ------------------------------------------------------------------------------------------------------ */

/* What was in order, and after it what the next round made. */
static mt_status put_together(mt_round heaps[2], mt_arena *arena, mt_cut_side *cuts[2]) {
    mt_cut_side all[2] = {0};
    for (int s = 0; s < 2; s++) {
        const mt_round *heap = &heaps[s];
        size_t room = (size_t)heap->made.parts.count + (size_t)heap->next.parts.count;
        all[s].parts.components = mt_arena_new(arena, room, sizeof(mt_component));
        all[s].partner = mt_arena_new(arena, room, sizeof(int));
        if (!all[s].parts.components || !all[s].partner) return MT_NO_MEMORY;
        for (int i = 0; i < heap->made.parts.count; i++) {
            if (heap->left[i]) continue;
            heap->place[i] = all[s].parts.count;
            all[s].parts.components[all[s].parts.count++] = heap->made.parts.components[i];
        }
    }
    int kept = all[0].parts.count; /* as many on both sides: they are pairs */
    for (int s = 0; s < 2; s++) {
        const mt_round *heap = &heaps[s];
        for (int i = 0; i < heap->made.parts.count; i++)
            if (!heap->left[i]) all[s].partner[heap->place[i]] = heaps[1 - s].place[heap->made.partner[i]];
        for (int i = 0; i < heap->next.parts.count; i++) {
            int partner = heap->next.partner[i];
            all[s].partner[kept + i] = partner < 0 ? -1 : kept + partner;
            all[s].parts.components[kept + i] = heap->next.parts.components[i];
        }
        all[s].parts.count = kept + heap->next.parts.count;
        *cuts[s] = all[s];
    }
    return MT_OK;
}

static mt_status do_rounds(const mt_side *a, const mt_side *b, const mt_hints *hints,
                           const mt_settings *settings, int rounds, mt_arena *arena, mt_cut_side *cuts[2]) {
    mt_round heaps[2] = {{.side = a}, {.side = b}};
    mt_side left[2];
    mt_hints further;
    mt_status status = mt_divide(a, b, hints, settings, arena, &heaps[0].made, &heaps[1].made);
    if (status == MT_OK) status = tell_left(heaps, settings, arena);
    if (status != MT_OK) return status;
    if (rounds == 1 || !is_worth_while(heaps)) {
        for (int s = 0; s < 2; s++) *cuts[s] = heaps[s].made;
        return MT_OK;
    }
    status = hints_left(hints, heaps, arena, &further);
    for (int s = 0; status == MT_OK && s < 2; s++) status = side_left(&heaps[s], arena, &left[s]);
    mt_cut_side *next[2] = {&heaps[0].next, &heaps[1].next};
    if (status == MT_OK) status = do_rounds(&left[0], &left[1], &further, settings, rounds - 1, arena, next);
    return status == MT_OK ? put_together(heaps, arena, cuts) : status;
}

/* ---- all of it --------------------------------------------------------------------------------------------------- */

/* What is left of both sides goes together at any cost: where one is slit open and the other is not, yet, it is high. */
static mt_status pair_rest(const mt_side *a, const mt_side *b, const mt_settings *settings, mt_arena *arena,
                           mt_cut_side *cuts[2]) {
    mt_ring_list in_a, in_b;
    mt_status status = mt_outer_rings(&cuts[0]->parts, a->box, arena, &in_a);
    if (status == MT_OK) status = mt_outer_rings(&cuts[1]->parts, b->box, arena, &in_b);
    if (status != MT_OK) return status;
    return mt_pair_rings(&in_a, &in_b, INFINITY, settings, arena, cuts[0]->partner, cuts[1]->partner);
}

mt_status mt_reconcile(const mt_side *a, const mt_side *b, const mt_hints *hints, const mt_settings *settings,
                       mt_arena *arena, mt_cut_side *cut_a, mt_cut_side *cut_b) {
    mt_cut_side made[2], *cuts[2] = {&made[0], &made[1]};
    mt_status status = do_rounds(a, b, hints, settings, ROUNDS, arena, cuts);
    if (status == MT_OK) status = pair_rest(a, b, settings, arena, cuts);
    if (status != MT_OK) return status;
    *cut_a = made[0];
    *cut_b = made[1];
    return MT_OK;
}
