/* The cheapest pairing in order, by a table: cell (i, k) is the least cost of A's first i parts and B's first k. Only parts of the figure
 * that has more may be left over; they join a pair beside them that is of two texts: the letters of a word become one sign together. */
#include "motion/part_pairs.h"

#include <math.h>
#include <string.h>

#include "geometry/limits.h"

/* The cost of a pair of different texts, in em of way: more than any line is long. */
#define OTHER_TEXT 1e6

/* Parts whose middles are further apart than so many em do not go together. */
#define TOGETHER_WITHIN 8.0

typedef struct mt_pairing_table {
    const mt_figure *a, *b;
    double *cost; /* (a->count + 1) × (b->count + 1) */
} mt_pairing_table;

static double *cell(const mt_pairing_table *table, int i, int k) {
    return &table->cost[(size_t)i * ((size_t)table->b->count + 1) + (size_t)k];
}

static double middle(const mt_figure_part *part) {
    mt_box box = mt_shape_box(&part->shape);
    return part->place.x + ((double)box.min.x + box.max.x) / 2;
}

static bool same_text(const mt_figure_part *a, const mt_figure_part *b) {
    if (!a->text || !b->text || a->text_length != b->text_length) return false;
    return memcmp(a->text, b->text, (size_t)a->text_length * sizeof *a->text) == 0;
}

static double pair_cost(const mt_figure_part *a, const mt_figure_part *b) {
    return (same_text(a, b) ? 0 : OTHER_TEXT) + fabs(middle(a) - middle(b)) / MT_EM;
}

/* The cost of leaving a part over: none where its figure has more parts. */
static double left_over(int own, int other) {
    return own > other ? 0 : INFINITY;
}

static void fill(const mt_pairing_table *table) {
    int n = table->a->count, m = table->b->count;
    for (int i = 0; i <= n; i++)
        for (int k = 0; k <= m; k++) {
            double least = i == 0 && k == 0 ? 0 : INFINITY;
            if (i > 0) least = fmin(least, *cell(table, i - 1, k) + left_over(n, m));
            if (k > 0) least = fmin(least, *cell(table, i, k - 1) + left_over(m, n));
            if (i > 0 && k > 0)
                least = fmin(least, *cell(table, i - 1, k - 1) +
                                        pair_cost(&table->a->parts[i - 1], &table->b->parts[k - 1]));
            *cell(table, i, k) = least;
        }
}

/* Goes back from the last cell, by a pair where that is among the cheapest. */
static void trace(const mt_pairing_table *table, mt_part_pairs *pairs) {
    int i = table->a->count, k = table->b->count, room = i > k ? i : k;
    pairs->count = room;
    while (room > 0) {
        double cost = *cell(table, i, k);
        bool paired =
            i > 0 && k > 0 &&
            cost == *cell(table, i - 1, k - 1) + pair_cost(&table->a->parts[i - 1], &table->b->parts[k - 1]);
        bool of_a = paired || table->a->count > table->b->count, of_b = paired || !of_a;
        i -= of_a;
        k -= of_b;
        pairs->pairs[--room] = (mt_part_pair){{i, of_a}, {k, of_b}};
    }
}

/* ---- what is left over ----------------------------------------------------------------------------------- */

static bool is_whole(const mt_part_pair *pair) {
    return pair->a.count > 0 && pair->b.count > 0;
}

/* How far a part that is left over is from that of a pair which it may go with, em; INFINITY for one that it may not go with. */
static double way_to(const mt_figure *a, const mt_figure *b, const mt_part_pair *left,
                     const mt_part_pair *pair) {
    const mt_figure_part *of_a = &a->parts[pair->a.first], *of_b = &b->parts[pair->b.first];
    const mt_figure_part *own = left->a.count > 0 ? &a->parts[left->a.first] : &b->parts[left->b.first];
    double way = fabs(middle(own) - middle(left->a.count > 0 ? of_a : of_b)) / MT_EM;
    return same_text(of_a, of_b) || way > TOGETHER_WITHIN ? INFINITY : way;
}

/* The nearer of the whole pairs before and after; -1 for none. */
static int partner_of(const mt_figure *a, const mt_figure *b, const mt_part_pairs *pairs, int left) {
    int before = left - 1, after = left + 1;
    while (before >= 0 && !is_whole(&pairs->pairs[before])) before--;
    while (after < pairs->count && !is_whole(&pairs->pairs[after])) after++;
    double to_before = before < 0 ? INFINITY : way_to(a, b, &pairs->pairs[left], &pairs->pairs[before]);
    double to_after =
        after == pairs->count ? INFINITY : way_to(a, b, &pairs->pairs[left], &pairs->pairs[after]);
    if (isinf(to_before) && isinf(to_after)) return -1;
    return to_after < to_before ? after : before;
}

static void take_in(mt_part_run *run, const mt_part_run *more) {
    if (more->count > 0 && more->first < run->first) run->first = more->first;
    run->count += more->count;
}

/* Parts that are left over join the pairs beside them: of those between two pairs the first ones go with the pair before, and as soon as
 * one is nearer to the pair after, so do all that follow. */
static mt_status join_left_over(const mt_figure *a, const mt_figure *b, mt_arena *arena,
                                mt_part_pairs *pairs) {
    int *partner = mt_arena_new(arena, (size_t)pairs->count + 1, sizeof *partner), kept = 0;
    if (!partner) return MT_NO_MEMORY;
    for (int i = 0; i < pairs->count; i++) {
        bool whole = is_whole(&pairs->pairs[i]);
        partner[i] = whole ? i : partner_of(a, b, pairs, i);
        if (!whole && i > 0 && partner[i - 1] > i) partner[i] = partner[i - 1];
    }
    for (int i = 0; i < pairs->count; i++) {
        if (partner[i] < 0 || partner[i] == i) continue;
        take_in(&pairs->pairs[partner[i]].a, &pairs->pairs[i].a);
        take_in(&pairs->pairs[partner[i]].b, &pairs->pairs[i].b);
    }
    for (int i = 0; i < pairs->count; i++)
        if (partner[i] < 0 || partner[i] == i) pairs->pairs[kept++] = pairs->pairs[i];
    pairs->count = kept;
    return MT_OK;
}

mt_status mt_pair_parts(const mt_figure *a, const mt_figure *b, mt_arena *arena, mt_part_pairs *pairs) {
    size_t most = (size_t)(a->count > b->count ? a->count : b->count);
    mt_part_pairs made = {0, mt_arena_new(arena, most, sizeof *made.pairs)};
    mt_arena_place before = mt_arena_mark(arena);
    mt_pairing_table table = {
        a, b, mt_arena_new(arena, ((size_t)a->count + 1) * ((size_t)b->count + 1), sizeof *table.cost)};
    if (!made.pairs || !table.cost) return MT_NO_MEMORY;
    fill(&table);
    trace(&table, &made);
    mt_status status = join_left_over(a, b, arena, &made);
    mt_arena_rewind(arena, before);
    if (status == MT_OK) *pairs = made;
    return status;
}
