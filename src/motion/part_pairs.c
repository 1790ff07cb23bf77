/* The cheapest pairing in order, by a table: cell (i, k) is the least cost of A's first i parts and B's first k. Only parts of the figure
 * that has more may be left over. */
#include "motion/part_pairs.h"

#include <math.h>
#include <string.h>

#include "geometry/limits.h"

/* The cost of a pair of different texts, in em of way: more than any line is long. */
#define OTHER_TEXT 1e6

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
        pairs->pairs[--room] = (mt_part_pair){of_a ? --i : -1, of_b ? --k : -1};
    }
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
    mt_arena_rewind(arena, before);
    *pairs = made;
    return MT_OK;
}
