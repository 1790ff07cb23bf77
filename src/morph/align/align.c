/* Dynamic programming over pairs of views (lifted.h), once around both rings. A step advances one ring or both; w and w' are what the
 * views weigh that it leads to:
 *
 *     (i-1, j-1)   (i-1, j)      both advance: (w + w') · cost(i, j)
 *               ╲     │          only A does:  w · (cost(i, j) + WAIT_COST)
 *     (i, j-1) ────▶ (i, j)      only B does:  w' · (cost(i, j) + WAIT_COST)
 *
 * so that every alignment has the weight 2, however many steps it has (after the symmetric form of H. Sakoe and S. Chiba, "Dynamic
 * programming algorithm optimization for spoken word recognition", 1978). The rings are closed: the path leads from
 * (start_a, start_b) around to the same pair. start_a is the view with the cheapest pair of all; each of its STARTS cheapest partners,
 * none beside a cheaper one, is tried as start_b.
 *
 *     (0, 0) ████▒                 A cell is left out (·) where what it cost to come there, and what the views that are left cost
 *            ▒█████▒  · ·          with their best partners, is more than a path may: so the rows hold a band (█). What a path may
 *            · ▒█████▒  ·          cost is that of the start before; for the first, it is guessed, and doubled until there is a
 *            · · · ▒████ (n, m)    path. The path found is the one that the whole grid has.
 *
 * Invariants: every sample of both rings is in a step; the steps run in the order of both rings; the rings are put in an order of their
 * own first, so that swapping them swaps the result. O(n · m) for the costs, and at most STARTS times that for the bands. */
#include "morph/align/align.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <string.h>

#include "arithmetic/angles.h"
#include "geometry/limits.h"
#include "morph/align/lifted.h"

/* Added to the cost of every other pair of a pinned sample: by its weight, more than any alignment costs. */
#define PIN_COST 1e4F

/* From a hint's place to the boundary, at most, 1/1000 em: a person points to within a stroke's width. */
#define PIN_REACH 25.0

/* Views of B tried as the start. */
#define STARTS 8

/* What a path is first thought to cost over what its views cost at least: by that share of it, or by that. */
#define GUESS_SHARE 0.25F
#define GUESS_LEAST 0.02F

/* Added to the cost of a step by which one ring advances while the other waits. */
#define WAIT_COST ((float)MT_WAIT_COST)

/* ---- dynamic programming ------------------------------------------------------------------------------- */

enum { BOTH, A_ADVANCES, B_ADVANCES };

typedef struct mt_grid {
    mt_lifted_ring a, b;
    int n, m; /* views of A, of B */
    int start_a, start_b;
    float *costs;   /* n × m: of each pair of views */
    float *least_a; /* of each view of A, what its best partner costs by its weight … */
    float *least_b; /* … and of each of B */
    float *rest_a;  /* of each row, the sum of those least costs over the rows after it */
    float *rest_b;  /* of each column, over the columns after it */
    float *rotated; /* a row of `costs` from start_b on, and its first again: m + 1 */
    float *weights; /* of the views of B, likewise */
    float *row;     /* m + 1 least costs of reaching row i's cells; INFINITY before and behind */
    float *last;    /* … and those of the row before */
    float *down;    /* least costs by a last step from the row before */
    int first, end; /* the cells of `row` through which a path may still be cheap enough */
    float most;     /* what a path may cost */
    uint8_t *moves; /* (n + 1) × (m + 1): the last step to each cell */
} mt_grid;

static mt_status fill_costs(mt_grid *g, const mt_cost_weights *weights, mt_arena *arena) {
    mt_columns columns;
    mt_status status = mt_columns_of(g->b.views, g->m, arena, &columns);
    for (int i = 0; status == MT_OK && i < g->n; i++)
        mt_step_costs(weights, &g->a.views[i], &columns, 0, g->m, g->costs + (size_t)i * (size_t)g->m);
    return status;
}

static float cost_at(const mt_grid *g, int i, int j) {
    return g->costs[(size_t)i * (size_t)g->m + (size_t)j];
}

/* Values of the views of B, from start_b on, for the columns from `first` up to `end`. */
static void rotate(const mt_grid *g, const float *values, int first, int end, float *rotated) {
    for (int j = first; j < end;) {
        int view = (g->start_b + j) % g->m, behind = g->m - view, count = end - j < behind ? end - j : behind;
        memcpy(rotated + j, values + view, (size_t)count * sizeof *values);
        j += count;
    }
}

/* What is left to pay, at least, after each row or column: the sum of what the views after it cost. */
static void sum_rests(const float *least, int count, int start, float *rests) {
    double sum = 0;
    for (int i = count; i >= 0; i--) {
        rests[i] = (float)sum;
        sum += least[(start + i) % count];
    }
}

/* Whether a path that reaches a cell of row i at this cost can't end at `most`, whatever comes. */
static bool is_too_much(const mt_grid *g, float cost, int i, int j) {
    return cost + g->rest_a[i] + g->rest_b[j] > g->most;
}

/* From the row before, whose cells end at `end`: A's view advances, alone or with B's. */
static void advance_a(const mt_grid *g, int first, int end, float weight, uint8_t *restrict moves) {
    const float *restrict costs = g->rotated, *restrict weights = g->weights, *restrict last = g->last;
    float *restrict down = g->down;
    for (int j = first; j < end; j++) {
        float above = last[j] + weight * (WAIT_COST + costs[j]),
              both = last[j - 1] + (weight + weights[j]) * costs[j];
        down[j] = above < both ? above : both;
        moves[j] = above < both ? A_ADVANCES : BOTH;
    }
}

/* Along the row: B's view advances alone, where that is cheaper. Each cost waits for the one before it, so that little else is done in
 * that loop. */
static void advance_b(const mt_grid *g, int first, int end, uint8_t *restrict moves) {
    const float *restrict costs = g->rotated, *restrict weights = g->weights, *restrict down = g->down;
    float *restrict row = g->row, best = INFINITY;
    for (int j = first; j < end; j++) {
        float left = best + weights[j] * (WAIT_COST + costs[j]);
        best = left < down[j] ? left : down[j];
        row[j] = best;
    }
    for (int j = first; j < end; j++) moves[j] = row[j] < down[j] ? B_ADVANCES : moves[j];
}

/* Goes on along row i behind the cells that the row before leads to; the cells that are too much are left out on either side. */
static void trim(mt_grid *g, int i, int first, int end, uint8_t *moves) {
    float *row = g->row;
    const float *costs = g->costs + (size_t)((g->start_a + i) % g->n) * (size_t)g->m;
    for (; end <= g->m; end++) {
        row[end] = row[end - 1] + g->weights[end] * (WAIT_COST + costs[(g->start_b + end) % g->m]);
        moves[end] = B_ADVANCES;
        if (is_too_much(g, row[end], i, end)) break;
    }
    while (end > first && is_too_much(g, row[end - 1], i, end - 1)) end--;
    while (first < end && is_too_much(g, row[first], i, first)) first++;
    row[first - 1] = row[end] = INFINITY;
    g->first = first;
    g->end = end;
}

/* The least cost of a path from (start_a, start_b) once around both rings; INFINITY where it is more than `most`. */
static float fill(mt_grid *g) {
    g->row[0] = 0;
    trim(g, 0, 0, 1, g->moves);
    for (int i = 1; i <= g->n && g->first < g->end; i++) {
        int view = (g->start_a + i) % g->n, first = g->first, end = g->end < g->m ? g->end + 1 : g->m + 1;
        uint8_t *moves = g->moves + (size_t)i * (size_t)(g->m + 1);
        float *swap = g->last;
        g->last = g->row;
        g->row = swap;
        rotate(g, g->costs + (size_t)view * (size_t)g->m, first, end, g->rotated);
        advance_a(g, first, end, g->a.weight[view], moves);
        advance_b(g, first, end, moves);
        trim(g, i, first, end, moves);
    }
    return g->end > g->m ? g->row[g->m] : INFINITY;
}

/* Allows for what rounding adds to a sum of a step for each view. */
static float rounded_up(const mt_grid *g, float most) {
    return most + (float)(g->n + g->m) * FLT_EPSILON * (most + WAIT_COST);
}

/* The least cost of a path from the start, when that is less than `most`; INFINITY otherwise. What a path may cost is guessed first, and
 * doubled until one is found: the less it may, the fewer cells can be on it. */
static float find_cheapest(mt_grid *g, float most) {
    rotate(g, g->b.weight, 0, g->m + 1, g->weights);
    sum_rests(g->least_a, g->n, g->start_a, g->rest_a);
    sum_rests(g->least_b, g->m, g->start_b, g->rest_b);
    float least = g->rest_a[0] + g->rest_b[0], over = fmaxf(least * GUESS_SHARE, GUESS_LEAST), cost;
    do {
        g->most = rounded_up(g, fminf(most, least + over));
        cost = fill(g);
        over *= 2;
    } while (cost == INFINITY && g->most < most);
    return cost;
}

/* Reads the way back from the filled grid: the steps after the start, the last of which is the start again. */
static void read_back(const mt_grid *g, mt_alignment *alignment) {
    int i = g->n, j = g->m, count = 0;
    while (i > 0 || j > 0) {
        alignment->steps[count++] = (mt_link){(g->start_a + i) % g->n, (g->start_b + j) % g->m};
        uint8_t move = g->moves[(size_t)i * (size_t)(g->m + 1) + (size_t)j];
        i -= move != B_ADVANCES;
        j -= move != A_ADVANCES;
    }
    for (int k = 0; k < count / 2; k++) {
        mt_link swap = alignment->steps[k];
        alignment->steps[k] = alignment->steps[count - 1 - k];
        alignment->steps[count - 1 - k] = swap;
    }
    alignment->count = count;
}

/* ---- the start ----------------------------------------------------------------------------------------- */

/* What advancing over each view costs at least, and the view of A with the cheapest pair, to start at. */
static void find_least(mt_grid *g) {
    float cheapest = INFINITY;
    for (int j = 0; j < g->m; j++) g->least_b[j] = INFINITY;
    for (int i = 0; i < g->n; i++) {
        const float *restrict row = g->costs + (size_t)i * (size_t)g->m;
        float *restrict column = g->least_b, least = INFINITY;
        for (int j = 0; j < g->m; j++) least = row[j] < least ? row[j] : least;
        for (int j = 0; j < g->m; j++) column[j] = row[j] < column[j] ? row[j] : column[j];
        g->least_a[i] = least * g->a.weight[i];
        if (least >= cheapest) continue;
        cheapest = least;
        g->start_a = i;
    }
    for (int j = 0; j < g->m; j++) g->least_b[j] *= g->b.weight[j];
}

/* Whether a view of B suits a view of A better than those beside it do. */
static bool is_least(const mt_grid *g, int i, int j) {
    int before = j > 0 ? j - 1 : g->m - 1, after = j + 1 < g->m ? j + 1 : 0;
    return cost_at(g, i, j) <= cost_at(g, i, before) && cost_at(g, i, j) < cost_at(g, i, after);
}

/* The STARTS best partners of a view of A that are truly different, best first; -1 where B has no more. */
static void cheapest_partners(const mt_grid *g, int i, int partners[STARTS]) {
    int best = 0;
    for (int j = 1; j < g->m; j++)
        if (cost_at(g, i, j) < cost_at(g, i, best)) best = j;
    partners[0] = best;
    for (int k = 1; k < STARTS; k++) partners[k] = -1;
    for (int j = 0; j < g->m; j++) {
        int k = STARTS;
        if (j == best || !is_least(g, i, j)) continue;
        while (k > 1 && (partners[k - 1] < 0 || cost_at(g, i, j) < cost_at(g, i, partners[k - 1]))) k--;
        for (int l = STARTS - 1; l > k; l--) partners[l] = partners[l - 1];
        if (k < STARTS) partners[k] = j;
    }
}

/* A pinned sample goes with its counterpart and with no other. */
static void pin(mt_grid *g, const mt_links *pins) {
    for (int k = 0; k < pins->count; k++)
        for (int i = 0; i < g->n; i++)
            for (int j = 0; j < g->m; j++)
                if ((g->a.of[i] == pins->links[k].a) != (g->b.of[j] == pins->links[k].b))
                    g->costs[(size_t)i * (size_t)g->m + (size_t)j] += PIN_COST;
}

static mt_status start_grid(const mt_cost_weights *weights, const mt_links *pins, mt_arena *arena,
                            mt_grid *grid) {
    mt_grid *g = grid;
    g->n = g->a.count;
    g->m = g->b.count;
    size_t cells = ((size_t)g->n + 1) * ((size_t)g->m + 1), row = (size_t)g->m + 1;
    if (cells > MT_ALIGNMENT_MAX || !mt_arena_spend(arena, (int64_t)cells * STARTS)) return MT_TOO_LARGE;
    g->costs = mt_arena_new(arena, cells, sizeof(float));
    g->rotated = mt_arena_new(arena, 7 * row + 4 + 2 * (size_t)g->n + 1, sizeof(float));
    g->moves = mt_arena_new(arena, cells, 1);
    if (!g->costs || !g->rotated || !g->moves) return MT_NO_MEMORY;
    g->weights = g->rotated + row;
    g->down = g->weights + row;
    g->rest_b = g->down + row;
    g->least_b = g->rest_b + row;
    g->row = g->least_b + row + 1; /* with a cell before and one behind, as `last` has */
    g->last = g->row + row + 2;
    g->least_a = g->last + row + 1;
    g->rest_a = g->least_a + g->n;
    mt_status status = fill_costs(g, weights, arena);
    if (status != MT_OK) return status;
    pin(g, pins);
    find_least(g);
    return MT_OK;
}

/* The steps between samples, from those between views. */
static void drop_views(const mt_grid *g, mt_alignment *alignment) {
    int kept = 0;
    mt_link *steps = alignment->steps;
    for (int k = 0; k < alignment->count; k++) {
        mt_link step = {g->a.of[steps[k].a], g->b.of[steps[k].b]};
        if (kept == 0 || steps[kept - 1].a != step.a || steps[kept - 1].b != step.b) steps[kept++] = step;
    }
    while (kept > 1 && steps[0].a == steps[kept - 1].a && steps[0].b == steps[kept - 1].b) kept--;
    alignment->count = kept;
}

static mt_status align(const mt_ring_samples *samples_a, const mt_frame *frame_a,
                       const mt_ring_samples *samples_b, const mt_frame *frame_b,
                       const mt_cost_weights *weights, const mt_links *pins, mt_arena *arena,
                       mt_alignment *alignment) {
    mt_grid grid = {0};
    mt_status status = mt_lift_ring(samples_a, frame_a, arena, &grid.a);
    if (status == MT_OK) status = mt_lift_ring(samples_b, frame_b, arena, &grid.b);
    if (status == MT_OK) status = start_grid(weights, pins, arena, &grid);
    if (status != MT_OK) return status;
    mt_alignment made = {.steps = mt_arena_new(arena, (size_t)grid.n + (size_t)grid.m, sizeof(mt_link))};
    if (!made.steps) return MT_NO_MEMORY;
    int partners[STARTS];
    float least = INFINITY;
    cheapest_partners(&grid, grid.start_a, partners);
    for (int k = 0; k < STARTS && partners[k] >= 0; k++) {
        grid.start_b = partners[k];
        float cost = find_cheapest(&grid, least);
        if (cost >= least) continue;
        least = cost;
        read_back(&grid, &made);
    }
    made.cost = fmax(0, (double)least / 2); /* of what is alike, rounding may leave less */
    drop_views(&grid, &made);
    assert(mt_alignment_is_valid(&made));
    *alignment = made;
    return MT_OK;
}

/* ---- order of the rings -------------------------------------------------------------------------------- */

/* Orders two rings by their contents alone: < 0, 0, > 0. */
static double compare(const mt_ring_samples *p, const mt_ring_samples *q) {
    if (p->count != q->count) return p->count - q->count;
    for (int i = 0; i < p->count; i++) {
        if (p->samples[i].x != q->samples[i].x) return p->samples[i].x - q->samples[i].x;
        if (p->samples[i].y != q->samples[i].y) return p->samples[i].y - q->samples[i].y;
    }
    return 0;
}

static void swap_all(mt_link *links, int count) {
    for (int i = 0; i < count; i++) links[i] = (mt_link){links[i].b, links[i].a};
}

mt_status mt_align(const mt_ring_samples *a, const mt_frame *frame_a, const mt_ring_samples *b,
                   const mt_frame *frame_b, const mt_cost_weights *weights, const mt_links *pins,
                   mt_arena *arena, mt_alignment *alignment) {
    if (compare(a, b) <= 0) return align(a, frame_a, b, frame_b, weights, pins, arena, alignment);
    mt_links swapped = {pins->count, mt_arena_new(arena, (size_t)pins->count, sizeof(mt_link))};
    if (!swapped.links) return MT_NO_MEMORY;
    for (int i = 0; i < pins->count; i++) swapped.links[i] = (mt_link){pins->links[i].b, pins->links[i].a};
    mt_status status = align(b, frame_b, a, frame_a, weights, &swapped, arena, alignment);
    if (status == MT_OK) swap_all(alignment->steps, alignment->count);
    return status;
}

/* ---- pins ---------------------------------------------------------------------------------------------- */

static int nearest_sample(const mt_ring_samples *samples, mt_point place, double *least) {
    int nearest = 0;
    *least = INFINITY;
    for (int i = 0; i < samples->count; i++) {
        double distance = mt_hypot(samples->samples[i].x - place.x, samples->samples[i].y - place.y);
        if (distance >= *least) continue;
        *least = distance;
        nearest = i;
    }
    return nearest;
}

mt_status mt_pins_of(const mt_hints *hints, const mt_ring_samples *a, const mt_ring_samples *b,
                     mt_arena *arena, mt_links *pins) {
    *pins = (mt_links){0, mt_arena_new(arena, (size_t)hints->count, sizeof(mt_link))};
    if (!pins->links) return MT_NO_MEMORY;
    for (int i = 0; i < hints->count; i++) {
        if (hints->hints[i].kind != MT_HINT_POINT) continue;
        double in_a, in_b;
        mt_link pin = {nearest_sample(a, hints->hints[i].a, &in_a),
                       nearest_sample(b, hints->hints[i].b, &in_b)};
        if (fmax(in_a, in_b) <= mt_grid_units(PIN_REACH)) pins->links[pins->count++] = pin;
    }
    return MT_OK;
}

/* ---- invariants ---------------------------------------------------------------------------------------- */

static bool advances(int from, int to, int *rounds) {
    *rounds += to < from;
    return to == from || to == from + 1 || to == 0;
}

bool mt_alignment_is_valid(const mt_alignment *alignment) {
    int rounds_a = 0, rounds_b = 0;
    bool valid = alignment->count >= 1;
    for (int k = 0; valid && k < alignment->count; k++) {
        mt_link p = alignment->steps[k], q = alignment->steps[(k + 1) % alignment->count];
        bool stays = p.a == q.a && p.b == q.b && alignment->count > 1;
        valid = advances(p.a, q.a, &rounds_a) && advances(p.b, q.b, &rounds_b) && !stays;
    }
    return valid && rounds_a <= 1 && rounds_b <= 1;
}
