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
 * none beside a cheaper one, is tried as start_b. Invariants: every sample of both rings is in a step; the steps run in the order of
 * both rings; the rings are put in an order of their own first, so that swapping them swaps the result. O(STARTS · n · m). */
#include "morph/align/align.h"

#include <assert.h>
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

/* Added to the cost of a step by which one ring advances while the other waits. */
#define WAIT_COST ((float)MT_WAIT_COST)

/* ---- dynamic programming ------------------------------------------------------------------------------- */

enum { BOTH, A_ADVANCES, B_ADVANCES };

typedef struct mt_grid {
    mt_lifted_ring a, b;
    int n, m; /* views of A, of B */
    int start_a, start_b;
    float *costs;   /* n × m: of each pair of views */
    float *rotated; /* a row of `costs` from start_b on, and its first again: m + 1 */
    float *weights; /* of the views of B, likewise */
    float *row;     /* m + 1 least costs of reaching row i's cells … */
    float *last;    /* … and those of the row before */
    float *down;    /* least costs by a last step from the row before */
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

/* Values of the views of B, from start_b on. */
static void rotate(const mt_grid *g, const float *values, float *rotated) {
    size_t behind = (size_t)(g->m - g->start_b);
    memcpy(rotated, values + g->start_b, behind * sizeof *values);
    memcpy(rotated + behind, values, (size_t)g->start_b * sizeof *values);
    rotated[g->m] = values[g->start_b];
}

/* From the row before: A's view advances, alone or with B's. */
static void advance_a(const mt_grid *g, float weight, uint8_t *restrict moves) {
    const float *restrict costs = g->rotated, *restrict weights = g->weights, *restrict last = g->last;
    float *restrict down = g->down;
    down[0] = last[0] + weight * (WAIT_COST + costs[0]);
    moves[0] = A_ADVANCES;
    for (int j = 1; j <= g->m; j++) {
        float above = last[j] + weight * (WAIT_COST + costs[j]),
              both = last[j - 1] + (weight + weights[j]) * costs[j];
        down[j] = above < both ? above : both;
        moves[j] = above < both ? A_ADVANCES : BOTH;
    }
}

/* Along the row: B's view advances alone, where that is cheaper. Returns the least cost in the row. Each cost waits for the one before
 * it, so that little else is done in that loop. */
static float advance_b(const mt_grid *g, uint8_t *restrict moves) {
    const float *restrict costs = g->rotated, *restrict weights = g->weights, *restrict down = g->down;
    float *restrict row = g->row, best = INFINITY, least = INFINITY;
    for (int j = 0; j <= g->m; j++) {
        float left = best + weights[j] * (WAIT_COST + costs[j]);
        best = left < down[j] ? left : down[j];
        row[j] = best;
    }
    for (int j = 0; j <= g->m; j++) moves[j] = row[j] < down[j] ? B_ADVANCES : moves[j];
    for (int j = 0; j <= g->m; j++) least = row[j] < least ? row[j] : least;
    return least;
}

/* The least cost of a path from (start_a, start_b) once around both rings; INFINITY as soon as it is at least `most`. */
static float fill(mt_grid *g, float most) {
    rotate(g, g->b.weight, g->weights);
    for (int i = 0; i <= g->n; i++) {
        int view = (g->start_a + i) % g->n;
        uint8_t *moves = g->moves + (size_t)i * (size_t)(g->m + 1);
        float *swap = g->last;
        g->last = g->row;
        g->row = swap;
        rotate(g, g->costs + (size_t)view * (size_t)g->m, g->rotated);
        if (i > 0) advance_a(g, g->a.weight[view], moves);
        for (int j = 0; i == 0 && j <= g->m; j++) g->down[j] = j ? INFINITY : 0;
        if (advance_b(g, moves) >= most) return INFINITY; /* every path crosses this row */
    }
    return g->row[g->m];
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

static int cheapest_view(const mt_grid *g) {
    float least = INFINITY;
    int cheapest = 0;
    for (int i = 0; i < g->n; i++)
        for (int j = 0; j < g->m; j++)
            if (cost_at(g, i, j) < least) {
                least = cost_at(g, i, j);
                cheapest = i;
            }
    return cheapest;
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
    g->rotated = mt_arena_new(arena, 5 * row, sizeof(float));
    g->moves = mt_arena_new(arena, cells, 1);
    if (!g->costs || !g->rotated || !g->moves) return MT_NO_MEMORY;
    g->weights = g->rotated + row;
    g->row = g->weights + row;
    g->last = g->row + row;
    g->down = g->last + row;
    mt_status status = fill_costs(g, weights, arena);
    if (status != MT_OK) return status;
    pin(g, pins);
    g->start_a = cheapest_view(g);
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
        float cost = fill(&grid, least);
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
