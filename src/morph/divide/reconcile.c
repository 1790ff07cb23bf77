/* Rounds of division. A glyph that is joined differently in two places misleads its matches: the match of one part runs into the ink of
 * the other. So pairs that align well are set aside, and the rest of both sides is divided again, by itself:
 *
 *     round 1   A: a b c d   B: p q r       a–p aligns well; b, c, d and q, r: no partner, or a cost above POOR_MATCH
 *     round 2   A: b c d     B: q r         divided without a and p; the parts come after those of round 1
 *     at last   A: c'        B: r'          one part or more left on both sides: paired at any cost
 *
 * There are at most ROUNDS of them, and none where nothing was paired or nothing is left on a side. Invariants: parts have the ink of
 * their side; partners are mutual. O(ROUNDS) divisions. */
#include "morph/divide/reconcile.h"

#include <assert.h>
#include <math.h>

#include "geometry/inside.h"
#include "geometry/limits.h"
#include "morph/align/pairing.h"

/* Rounds of division: a glyph that is joined differently in two places needs two. */
enum { ROUNDS = 3 };

/* Partners whose alignment costs more (align/pairing.h) are divided again. */
#define POOR_MATCH 0.45

/* One side in a round: its parts, and those of them that are left for the next round. */
typedef struct mt_round_side {
    const mt_side *side;
    mt_cut_side made, next;
    bool *left;
    int left_count;
    int *place; /* of each part that is not left, its number in the result */
} mt_round_side;

/* ---- the parts left ---------------------------------------------------------------------------------------------- */

static mt_status is_poor_match(const mt_round_side sides[2], int i, const mt_settings *settings,
                               mt_arena *arena, bool *poor) {
    double cost = 0;
    const mt_ring *p = &sides[0].made.parts.components[i].rings[0],
                  *q = &sides[1].made.parts.components[sides[0].made.partner[i]].rings[0];
    mt_status status =
        mt_pair_cost(p, &sides[0].side->frame, q, &sides[1].side->frame, settings, arena, &cost);
    *poor = cost > POOR_MATCH;
    return status;
}

static mt_status mark_left(mt_round_side sides[2], const mt_settings *settings, mt_arena *arena) {
    for (int s = 0; s < 2; s++) {
        const mt_cut_side *made = &sides[s].made;
        sides[s].left = mt_arena_new(arena, (size_t)made->parts.count, sizeof(bool));
        sides[s].place = mt_arena_new(arena, (size_t)made->parts.count, sizeof(int));
        if (!sides[s].left || !sides[s].place) return MT_NO_MEMORY;
        for (int i = 0; i < made->parts.count; i++) sides[s].left[i] = made->partner[i] < 0;
    }
    for (int i = 0; i < sides[0].made.parts.count; i++) {
        bool poor = false;
        if (sides[0].left[i]) continue;
        mt_status status = is_poor_match(sides, i, settings, arena, &poor);
        if (status != MT_OK) return status;
        sides[0].left[i] = sides[1].left[sides[0].made.partner[i]] = poor;
    }
    for (int s = 0; s < 2; s++)
        for (int i = 0; i < sides[s].made.parts.count; i++) sides[s].left_count += sides[s].left[i];
    return MT_OK;
}

/* Whether a part has no partner, and another round would begin with other parts than this one. */
static bool is_worth_another(const mt_round_side sides[2]) {
    bool unpaired = false, changed = false;
    for (int s = 0; s < 2; s++) {
        for (int i = 0; i < sides[s].made.parts.count; i++)
            unpaired = unpaired || sides[s].made.partner[i] < 0;
        changed = changed || sides[s].left_count != sides[s].side->shape.count;
    }
    return unpaired && changed && sides[0].left_count > 0 && sides[1].left_count > 0;
}

/* The hints whose places both lie in parts that are left. */
static mt_status hints_left(const mt_hints *hints, const mt_round_side sides[2], mt_arena *arena,
                            mt_hints *left) {
    mt_hint *kept = mt_arena_new(arena, (size_t)hints->count, sizeof *kept);
    if (!kept) return MT_NO_MEMORY;
    int count = 0;
    for (int i = 0; i < hints->count; i++) {
        int p = mt_component_at(&sides[0].made.parts, hints->hints[i].a),
            q = mt_component_at(&sides[1].made.parts, hints->hints[i].b);
        if (sides[0].left[p] && sides[1].left[q]) kept[count++] = hints->hints[i];
    }
    *left = (mt_hints){count, kept};
    return MT_OK;
}

static mt_status side_left(const mt_round_side *r, mt_arena *arena, mt_side *side) {
    *side = (mt_side){.box = r->side->box, .frame = r->side->frame};
    side->shape.components = mt_arena_new(arena, (size_t)r->left_count, sizeof(mt_component));
    if (!side->shape.components) return MT_NO_MEMORY;
    for (int i = 0; i < r->made.parts.count; i++)
        if (r->left[i]) side->shape.components[side->shape.count++] = r->made.parts.components[i];
    return MT_OK;
}

/* ---- rounds ------------------------------------------------------------------------------------------------------ */

/* The pairs of this round, and after them the parts of the next. */
static mt_status merge_rounds(mt_round_side sides[2], mt_arena *arena, mt_cut_side *cuts[2]) {
    mt_cut_side all[2] = {0};
    for (int s = 0; s < 2; s++) {
        const mt_round_side *r = &sides[s];
        size_t room = (size_t)r->made.parts.count + (size_t)r->next.parts.count;
        all[s].parts.components = mt_arena_new(arena, room, sizeof(mt_component));
        all[s].partner = mt_arena_new(arena, room, sizeof(int));
        if (!all[s].parts.components || !all[s].partner) return MT_NO_MEMORY;
        for (int i = 0; i < r->made.parts.count; i++) {
            if (r->left[i]) continue;
            r->place[i] = all[s].parts.count;
            all[s].parts.components[all[s].parts.count++] = r->made.parts.components[i];
        }
    }
    int kept = all[0].parts.count; /* as many on both sides: they are pairs */
    for (int s = 0; s < 2; s++) {
        const mt_round_side *r = &sides[s];
        for (int i = 0; i < r->made.parts.count; i++)
            if (!r->left[i]) all[s].partner[r->place[i]] = sides[1 - s].place[r->made.partner[i]];
        for (int i = 0; i < r->next.parts.count; i++) {
            int partner = r->next.partner[i];
            all[s].partner[kept + i] = partner < 0 ? -1 : kept + partner;
            all[s].parts.components[kept + i] = r->next.parts.components[i];
        }
        all[s].parts.count = kept + r->next.parts.count;
        *cuts[s] = all[s];
    }
    return MT_OK;
}

static mt_status do_rounds(const mt_side *a, const mt_side *b, const mt_hints *hints,
                           const mt_settings *settings, int rounds, mt_arena *arena, mt_cut_side *cuts[2]) {
    mt_round_side sides[2] = {{.side = a}, {.side = b}};
    mt_side left[2];
    mt_hints further;
    mt_status status = mt_divide(a, b, hints, settings, arena, &sides[0].made, &sides[1].made);
    if (status == MT_OK) status = mark_left(sides, settings, arena);
    if (status != MT_OK) return status;
    if (rounds == 1 || !is_worth_another(sides)) {
        for (int s = 0; s < 2; s++) *cuts[s] = sides[s].made;
        return MT_OK;
    }
    status = hints_left(hints, sides, arena, &further);
    for (int s = 0; status == MT_OK && s < 2; s++) status = side_left(&sides[s], arena, &left[s]);
    mt_cut_side *next[2] = {&sides[0].next, &sides[1].next};
    if (status == MT_OK) status = do_rounds(&left[0], &left[1], &further, settings, rounds - 1, arena, next);
    return status == MT_OK ? merge_rounds(sides, arena, cuts) : status;
}

/* ---- all of it --------------------------------------------------------------------------------------------------- */

/* Pairs the parts left on both sides at any cost: it is high where one has a hole that will be slit open later. */
static mt_status pair_rest(const mt_side *a, const mt_side *b, const mt_settings *settings, mt_arena *arena,
                           mt_cut_side *cuts[2]) {
    mt_ring_list in_a, in_b;
    mt_status status = mt_outer_rings(&cuts[0]->parts, &a->frame, arena, &in_a);
    if (status == MT_OK) status = mt_outer_rings(&cuts[1]->parts, &b->frame, arena, &in_b);
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
    assert(mt_cut_side_is_valid(cut_a, cut_b) && mt_cut_side_is_valid(cut_b, cut_a));
    return MT_OK;
}
