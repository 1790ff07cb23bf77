/* Dynamic programming over pairs of samples, once around both rings. A step advances one ring or both:
 *
 *     (i-1, j-1)   (i-1, j)      both advance: 2 · cost(i, j)
 *               ╲     │          only A does:  cost(i, j) + MT_WAIT_COST
 *     (i, j-1) ────▶ (i, j)      only B does:  cost(i, j) + MT_WAIT_COST
 *
 * A step of both counts twice, so that every alignment has the weight n + m, however many steps it has (H. Sakoe and S. Chiba,
 * "Dynamic programming algorithm optimization for spoken word recognition", 1978, the symmetric form). The rings are closed: the path
 * leads from (start_a, start_b) around to the same pair. start_a is the sample with the cheapest pair of all; each of its STARTS
 * cheapest partners is tried as start_b. Invariants: every sample of both rings is in a step; the steps run in the order of both
 * rings; the rings are put in an order of their own first, so that swapping them swaps the result. O(STARTS · n · m). */
#include "morph/align/align.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "geometry/limits.h"

/* Added to the cost of every other pair of a pinned sample: more than any alignment costs. */
#define PIN_COST 100.0F

/* From a hint's place to the boundary, at most, 1/1000 em: a person points to within a stroke's width. */
#define PIN_REACH 25.0

/* Samples of B tried as the start; with all of them no glyph's topology came out otherwise. */
#define STARTS 4

typedef struct mt_views {
    int count;
    mt_sample_view *views;
} mt_views;

static mt_status views_of(const mt_ring_samples *samples, mt_box box, mt_arena *arena, mt_views *views) {
    *views = (mt_views){samples->count, mt_arena_new(arena, (size_t)samples->count, sizeof(mt_sample_view))};
    if (!views->views) return MT_NO_MEMORY;
    for (int i = 0; i < samples->count; i++) views->views[i] = mt_sample_view_of(&samples->samples[i], box);
    return MT_OK;
}

/* ---- dynamic programming ------------------------------------------------------------------------------- */

enum { BOTH, A_ADVANCES, B_ADVANCES };

typedef struct mt_grid {
    int n, m; /* samples of A, of B */
    int start_a, start_b;
    float *costs;   /* n × m: of each pair of samples */
    float *rotated; /* a row of `costs` from start_b on, and its first again: m + 1 */
    float *row;     /* m + 1 least costs of reaching row i's cells … */
    float *last;    /* … and those of the row before */
    float *down;    /* least costs by a last step from the row before */
    uint8_t *moves; /* (n + 1) × (m + 1): the last step to each cell */
} mt_grid;

static mt_status fill_costs(mt_grid *g, const mt_cost_weights *weights, const mt_views *a, const mt_views *b,
                            mt_arena *arena) {
    mt_columns columns;
    mt_status status = mt_columns_of(b->views, b->count, arena, &columns);
    for (int i = 0; status == MT_OK && i < g->n; i++)
        mt_step_costs(weights, &a->views[i], &columns, 0, g->m, g->costs + (size_t)i * (size_t)g->m);
    return status;
}

static float cost_at(const mt_grid *g, int i, int j) {
    return g->costs[(size_t)i * (size_t)g->m + (size_t)j];
}

#define WAIT_COST ((float)MT_WAIT_COST)

/* The costs of row i, from start_b on. */
static const float *rotate_row(mt_grid *g, int i) {
    const float *costs = g->costs + (size_t)((g->start_a + i) % g->n) * (size_t)g->m;
    size_t behind = (size_t)(g->m - g->start_b);
    memcpy(g->rotated, costs + g->start_b, behind * sizeof *costs);
    memcpy(g->rotated + behind, costs, (size_t)g->start_b * sizeof *costs);
    g->rotated[g->m] = costs[g->start_b];
    return g->rotated;
}

/* Steps from the row before: A advances, alone or with B. */
static void advance_a(const mt_grid *g, const float *restrict costs, uint8_t *restrict moves) {
    const float *restrict last = g->last;
    float *restrict down = g->down;
    down[0] = last[0] + WAIT_COST + costs[0];
    moves[0] = A_ADVANCES;
    for (int j = 1; j <= g->m; j++) {
        float above = last[j] + WAIT_COST + costs[j], both = last[j - 1] + 2 * costs[j];
        down[j] = above < both ? above : both;
        moves[j] = above < both ? A_ADVANCES : BOTH;
    }
}

/* Steps within the row: B advances alone, where that is cheaper. Returns the least cost in the row. The first loop does nothing else,
 * since each of its rounds depends on the one before. */
static float advance_b(const mt_grid *g, const float *restrict costs, uint8_t *restrict moves) {
    const float *restrict down = g->down;
    float *restrict row = g->row, best = INFINITY, least = INFINITY;
    for (int j = 0; j <= g->m; j++) {
        float left = best + (WAIT_COST + costs[j]);
        best = left < down[j] ? left : down[j];
        row[j] = best;
    }
    for (int j = 0; j <= g->m; j++) moves[j] = row[j] < down[j] ? B_ADVANCES : moves[j];
    for (int j = 0; j <= g->m; j++) least = row[j] < least ? row[j] : least;
    return least;
}

/* The least cost of a path from (start_a, start_b) once around both rings; INFINITY as soon as it is at least `most`. */
static float fill(mt_grid *g, float most) {
    for (int i = 0; i <= g->n; i++) {
        const float *costs = rotate_row(g, i);
        uint8_t *moves = g->moves + (size_t)i * (size_t)(g->m + 1);
        float *swap = g->last;
        g->last = g->row;
        g->row = swap;
        if (i > 0) advance_a(g, costs, moves);
        for (int j = 0; i == 0 && j <= g->m; j++) g->down[j] = j ? INFINITY : costs[0];
        if (advance_b(g, costs, moves) >= most) return INFINITY; /* every path crosses this row */
    }
    return g->row[g->m];
}

/* The path of the filled grid: the steps after the start, the last of which is the start again. */
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

static int cheapest_sample(const mt_grid *g) {
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

/* The STARTS cheapest partners of a sample of A, cheapest first; -1 where B has no more samples. */
static void cheapest_partners(const mt_grid *g, int i, int partners[STARTS]) {
    for (int k = 0; k < STARTS; k++) partners[k] = -1;
    for (int j = 0; j < g->m; j++) {
        int k = STARTS;
        while (k > 0 && (partners[k - 1] < 0 || cost_at(g, i, j) < cost_at(g, i, partners[k - 1]))) k--;
        for (int l = STARTS - 1; l > k; l--) partners[l] = partners[l - 1];
        if (k < STARTS) partners[k] = j;
    }
}

/* A pinned sample goes with its counterpart and with no other. */
static void pin(mt_grid *g, const mt_links *pins) {
    for (int k = 0; k < pins->count; k++) {
        mt_link p = pins->links[k];
        for (int j = 0; j < g->m; j++)
            if (j != p.b) g->costs[(size_t)p.a * (size_t)g->m + (size_t)j] += (float)PIN_COST;
        for (int i = 0; i < g->n; i++)
            if (i != p.a) g->costs[(size_t)i * (size_t)g->m + (size_t)p.b] += (float)PIN_COST;
    }
}

static mt_status start_grid(const mt_views *a, const mt_views *b, const mt_cost_weights *weights,
                            const mt_links *pins, mt_arena *arena, mt_grid *grid) {
    size_t cells = ((size_t)a->count + 1) * ((size_t)b->count + 1);
    if (cells > MT_ALIGNMENT_MAX) return MT_TOO_LARGE;
    *grid = (mt_grid){.n = a->count,
                      .m = b->count,
                      .costs = mt_arena_new(arena, cells, sizeof(float)),
                      .rotated = mt_arena_new(arena, (size_t)b->count + 1, sizeof(float)),
                      .row = mt_arena_new(arena, (size_t)b->count + 1, sizeof(float)),
                      .last = mt_arena_new(arena, (size_t)b->count + 1, sizeof(float)),
                      .down = mt_arena_new(arena, (size_t)b->count + 1, sizeof(float)),
                      .moves = mt_arena_new(arena, cells, 1)};
    if (!grid->costs || !grid->rotated || !grid->row || !grid->last || !grid->down || !grid->moves)
        return MT_NO_MEMORY;
    mt_status status = fill_costs(grid, weights, a, b, arena);
    if (status != MT_OK) return status;
    pin(grid, pins);
    grid->start_a = cheapest_sample(grid);
    return MT_OK;
}

static mt_status align(const mt_ring_samples *samples_a, mt_box box_a, const mt_ring_samples *samples_b,
                       mt_box box_b, const mt_cost_weights *weights, const mt_links *pins, mt_arena *arena,
                       mt_alignment *alignment) {
    mt_views a, b;
    mt_grid grid;
    mt_status status = views_of(samples_a, box_a, arena, &a);
    if (status == MT_OK) status = views_of(samples_b, box_b, arena, &b);
    if (status == MT_OK) status = start_grid(&a, &b, weights, pins, arena, &grid);
    if (status != MT_OK) return status;
    mt_alignment made = {.steps = mt_arena_new(arena, (size_t)a.count + (size_t)b.count, sizeof(mt_link))};
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
    made.cost = (double)least / (a.count + b.count);
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

mt_status mt_align(const mt_ring_samples *a, mt_box box_a, const mt_ring_samples *b, mt_box box_b,
                   const mt_cost_weights *weights, const mt_links *pins, mt_arena *arena,
                   mt_alignment *alignment) {
    if (compare(a, b) <= 0) return align(a, box_a, b, box_b, weights, pins, arena, alignment);
    mt_links swapped = {pins->count, mt_arena_new(arena, (size_t)pins->count, sizeof(mt_link))};
    if (!swapped.links) return MT_NO_MEMORY;
    for (int i = 0; i < pins->count; i++) swapped.links[i] = (mt_link){pins->links[i].b, pins->links[i].a};
    mt_status status = align(b, box_b, a, box_a, weights, &swapped, arena, alignment);
    if (status == MT_OK) swap_all(alignment->steps, alignment->count);
    return status;
}

/* ---- pins ---------------------------------------------------------------------------------------------- */

static int nearest_sample(const mt_ring_samples *samples, mt_point place, double *least) {
    int nearest = 0;
    *least = INFINITY;
    for (int i = 0; i < samples->count; i++) {
        double distance = hypot(samples->samples[i].x - place.x, samples->samples[i].y - place.y);
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
