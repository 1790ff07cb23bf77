#include "morph/walk.h"

#include <math.h>

#include "geometry/limits.h"

/* A walker minds the distance more than one who only aligns (align.c), since it has the choice of all rings. */
static const mt_tariff tariff = {.direction = 1, .distance = 4, .corner = 0};

/* How a cell was reached. From a bridge on, it is the bridge's number. */
enum { START, STAY, BOTH, ALONG, BRIDGE };

typedef struct mt_walker {
    const mt_border *from, *to;
    int first, n; /* the stops of the ring */
    int start;    /* the stop of the ring to start at */
    int *before;  /* of each stop of the border, the one before it on its ring */
    int *source;  /* of each bridge, the stop that it leaves */
    double *cost[2];
    float *price; /* of this stop of the ring with each of the border */
    int32_t *how; /* (n + 1) × to->count */
} mt_walker;

static int32_t *row_of(const mt_walker *w, int i) {
    return w->how + (size_t)i * (size_t)w->to->count;
}

/* ---- one row ----------------------------------------------------------------------------------------------------- */

static void price_row(mt_walker *w, int i) {
    const mt_view *here = &w->from->views[w->first + (w->start + i) % w->n];
    for (int j = 0; j < w->to->count; j++) w->price[j] = (float)mt_price(&tariff, here, &w->to->views[j]);
}

/* Along the rings of the border, while the ring's walker waits. */
static bool go_along(mt_walker *w, double *cost, int32_t *how) {
    bool changed = false;
    for (int r = 0; r < w->to->ring_count; r++) {
        int low = w->to->first_of_ring[r], high = w->to->first_of_ring[r + 1], j = high - 1;
        for (int k = low; k < high; j = k++) {
            double by = cost[j] + MT_WAIT_PRICE + (double)w->price[k];
            if (by >= cost[k]) continue;
            cost[k] = by;
            how[k] = ALONG;
            changed = true;
        }
    }
    return changed;
}

static bool go_across(mt_walker *w, double *cost, int32_t *how) {
    bool changed = false;
    for (int j = 0; j < w->to->count; j++)
        for (int b = w->to->first_bridge[j]; b < w->to->first_bridge[j + 1]; b++) {
            double by = cost[j] + w->to->bridges[b].price + (double)w->price[w->to->bridges[b].to];
            if (by >= cost[w->to->bridges[b].to]) continue;
            cost[w->to->bridges[b].to] = by;
            how[w->to->bridges[b].to] = BRIDGE + b;
            changed = true;
        }
    return changed;
}

static void settle_row(mt_walker *w, double *cost, int32_t *how) {
    bool changed = true;
    while (changed) {
        while (go_along(w, cost, how)) {
        }
        changed = go_across(w, cost, how);
    }
}

static void next_row(mt_walker *w, int i) {
    const double *last = w->cost[(i + 1) % 2];
    double *cost = w->cost[i % 2];
    int32_t *how = row_of(w, i);
    price_row(w, i);
    for (int j = 0; j < w->to->count; j++) {
        double stay = last[j] + MT_WAIT_PRICE, both = last[w->before[j]];
        cost[j] = fmin(stay, both) + (double)w->price[j];
        how[j] = stay < both ? STAY : BOTH;
    }
    settle_row(w, cost, how);
}

/* ---- a lap ------------------------------------------------------------------------------------------------------- */

/* Fills the table for once around the ring, from any stop of the border, or from `there` when it is not -1. */
static void fill(mt_walker *w, int there) {
    price_row(w, 0);
    for (int j = 0; j < w->to->count; j++) {
        w->cost[0][j] = there < 0 || there == j ? (double)w->price[j] : INFINITY;
        row_of(w, 0)[j] = START;
    }
    settle_row(w, w->cost[0], row_of(w, 0));
    for (int i = 1; i <= w->n; i++) next_row(w, i);
}

static int cheapest_end(const mt_walker *w) {
    const double *cost = w->cost[w->n % 2];
    int best = 0;
    for (int j = 1; j < w->to->count; j++)
        if (cost[j] < cost[best]) best = j;
    return best;
}

/* Reads the way back from the end; writes it when there is room, and returns how many paces it has. */
static int read_back(const mt_walker *w, int end, mt_pace *paces, int room) {
    int count = 0, i = w->n, j = end;
    for (;;) {
        int32_t how = row_of(w, i)[j];
        int here = w->first + (w->start + i) % w->n;
        if (paces) paces[room - 1 - count] = (mt_pace){here, j, how >= BRIDGE ? how - BRIDGE : -1};
        count++;
        if (how == START) return count;
        if (how == STAY || how == BOTH) i--;
        if (how == BOTH || how == ALONG) j = w->before[j];
        if (how >= BRIDGE) j = w->source[how - BRIDGE];
    }
}

static mt_status start_walker(const mt_border *from, int ring, const mt_border *to, mt_arena *arena,
                              mt_walker *w) {
    *w = (mt_walker){.from = from, .to = to, .first = from->first_of_ring[ring]};
    w->n = from->first_of_ring[ring + 1] - w->first;
    size_t m = (size_t)to->count, cells = ((size_t)w->n + 1) * m;
    if (cells > MT_ALIGNMENT_MAX) return MT_TOO_LARGE;
    w->before = mt_arena_new(arena, m, sizeof *w->before);
    w->source = mt_arena_new(arena, (size_t)to->first_bridge[to->count] + 1, sizeof *w->source);
    w->cost[0] = mt_arena_new(arena, m, sizeof(double));
    w->cost[1] = mt_arena_new(arena, m, sizeof(double));
    w->price = mt_arena_new(arena, m, sizeof *w->price);
    w->how = mt_arena_new(arena, cells, sizeof *w->how);
    if (!w->before || !w->source || !w->cost[0] || !w->cost[1] || !w->price || !w->how) return MT_NO_MEMORY;
    for (int r = 0; r < to->ring_count; r++)
        for (int j = to->first_of_ring[r]; j < to->first_of_ring[r + 1]; j++)
            w->before[j] = j > to->first_of_ring[r] ? j - 1 : to->first_of_ring[r + 1] - 1;
    for (int j = 0; j < to->count; j++)
        for (int b = to->first_bridge[j]; b < to->first_bridge[j + 1]; b++) w->source[b] = j;
    return MT_OK;
}

/* The surest pace of a walk: where the two stops are most alike. */
static mt_pace surest(const mt_walker *w, const mt_pace *paces, int count) {
    mt_pace best = paces[0];
    double least = INFINITY;
    for (int k = 0; k < count; k++) {
        double price = mt_price(&tariff, &w->from->views[paces[k].here], &w->to->views[paces[k].there]);
        if (price >= least) continue;
        least = price;
        best = paces[k];
    }
    return best;
}

mt_status mt_walk_around(const mt_border *from, int ring, const mt_border *to, mt_arena *arena,
                         mt_walk *walk) {
    mt_walker w;
    mt_status status = start_walker(from, ring, to, arena, &w);
    if (status != MT_OK) return status;
    fill(&w, -1); /* an open walk, to learn where a closed one may start */
    int end = cheapest_end(&w), count = read_back(&w, end, NULL, 0);
    mt_pace *paces = mt_arena_new(arena, (size_t)count, sizeof *paces);
    if (!paces) return MT_NO_MEMORY;
    read_back(&w, end, paces, count);
    mt_pace start = surest(&w, paces, count);
    w.start = start.here - w.first;
    fill(&w, start.there);
    *walk = (mt_walk){.count = read_back(&w, start.there, NULL, 0)};
    walk->price = w.cost[w.n % 2][start.there] / walk->count;
    walk->paces = mt_arena_new(arena, (size_t)walk->count, sizeof *walk->paces);
    if (!walk->paces) return MT_NO_MEMORY;
    read_back(&w, start.there, walk->paces, walk->count);
    return MT_OK;
}
