#include "morph/walk.h"

#include <math.h>

#include "geometry/limits.h"

/* A walker minds the distance more than one who only aligns (align.c), since it has the choice of all rings. */
static const mt_tariff tariff = {.direction = 1, .distance = 4, .corner = 0};

/* How a cell was reached. From a bridge on, it is the bridge's number. */
enum { START, STAY, BOTH, ALONG, BRIDGE };

/* The views of the border's stops. */
typedef struct mt_columns {
    double *x, *y, *in_x, *in_y, *out_x, *out_y;
} mt_columns;

typedef struct mt_walker {
    const mt_border *from, *to;
    mt_columns columns;
    int first, n; /* the stops of the ring */
    int start;    /* the stop of the ring to start at */
    int *before;  /* of each stop of the border, the one before it on its ring … */
    int *after;   /* … and the one after it */
    int *source;  /* of each bridge, the stop that it leaves */
    int *first_open,
        *open; /* of each stop, the bridges from it that are not barred: open[first_open[j] … first_open[j + 1]) */
    int gate_count, *gates;  /* the stops that have such bridges */
    int later_count, *later; /* stops whose bridges are to be looked at again … */
    bool *waits;             /* … and whether a stop is one of them */
    double *cost[2];
    float *price; /* of this stop of the ring with each of the border */
    int32_t *how; /* (n + 1) × to->count */
} mt_walker;

static int32_t *row_of(const mt_walker *w, int i) {
    return w->how + (size_t)i * (size_t)w->to->count;
}

/* Notes that a stop's bridges are to be looked at, if it has any. */
static void look_later(mt_walker *w, int j) {
    if (w->waits[j] || w->first_open[j] == w->first_open[j + 1]) return;
    w->waits[j] = true;
    w->later[w->later_count++] = j;
}

/* ---- one row ----------------------------------------------------------------------------------------------------- */

/* As mt_price, for all stops of the border, column by column: half of a walk's time goes here. */
static void price_row(mt_walker *w, int i) {
    const mt_view *here = &w->from->views[w->first + (w->start + i) % w->n];
    const mt_columns *c = &w->columns;
    for (int j = 0; j < w->to->count; j++) {
        double same = here->in_x * c->in_x[j] + here->in_y * c->in_y[j] + here->out_x * c->out_x[j] +
                      here->out_y * c->out_y[j];
        double dx = here->x - c->x[j], dy = here->y - c->y[j];
        w->price[j] = (float)(tariff.direction * (2 - same) / 4 + tariff.distance * sqrt(dx * dx + dy * dy));
    }
}

/* Along the ring of the border from stop j on, while the ring's walker waits, as long as that is cheaper. What it reaches has
 * its bridges to look at. */
static void go_on_from(mt_walker *w, int j, double *cost, int32_t *how) {
    for (;;) {
        int k = w->after[j];
        double by = cost[j] + MT_WAIT_PRICE + (double)w->price[k];
        if (by >= cost[k]) return;
        cost[k] = by;
        how[k] = ALONG;
        look_later(w, k);
        j = k;
    }
}

/* Once along a ring of the border from its cheapest stop, to which no way along the ring can be cheaper. */
static void go_along(mt_walker *w, int ring, double *cost, int32_t *how) {
    int low = w->to->first_of_ring[ring], high = w->to->first_of_ring[ring + 1], least = low;
    for (int j = low + 1; j < high; j++)
        if (cost[j] < cost[least]) least = j;
    for (int j = least, k = w->after[j]; k != least; j = k, k = w->after[j]) {
        double by = cost[j] + MT_WAIT_PRICE + (double)w->price[k];
        if (by >= cost[k]) continue;
        cost[k] = by;
        how[k] = ALONG;
    }
}

static void go_across(mt_walker *w, int j, double *cost, int32_t *how) {
    for (int i = w->first_open[j]; i < w->first_open[j + 1]; i++) {
        int b = w->open[i], to = w->to->bridges[b].to;
        double by = cost[j] + w->to->bridges[b].price + (double)w->price[to];
        if (by >= cost[to]) continue;
        cost[to] = by;
        how[to] = BRIDGE + b;
        look_later(w, to);
        go_on_from(w, to, cost, how);
    }
}

static void settle_row(mt_walker *w, double *cost, int32_t *how) {
    for (int r = 0; r < w->to->ring_count; r++) go_along(w, r, cost, how);
    for (int i = 0; i < w->gate_count; i++) go_across(w, w->gates[i], cost, how);
    while (w->later_count > 0) {
        int j = w->later[--w->later_count];
        w->waits[j] = false;
        go_across(w, j, cost, how);
    }
}

static void next_row(mt_walker *w, int i) {
    const double *last = w->cost[(i + 1) % 2];
    double *cost = w->cost[i % 2];
    int32_t *how = row_of(w, i);
    price_row(w, i);
    for (int r = 0; r < w->to->ring_count; r++) {
        double both = last[w->to->first_of_ring[r + 1] - 1];
        for (int j = w->to->first_of_ring[r]; j < w->to->first_of_ring[r + 1]; j++) {
            double stay = last[j] + MT_WAIT_PRICE;
            cost[j] = (stay < both ? stay : both) + (double)w->price[j];
            how[j] = stay < both ? STAY : BOTH;
            both = last[j];
        }
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

/* The rings of the border as chains of stops. */
static void chain_stops(mt_walker *w) {
    for (int r = 0; r < w->to->ring_count; r++) {
        int low = w->to->first_of_ring[r], high = w->to->first_of_ring[r + 1];
        for (int j = low; j < high; j++) {
            w->before[j] = j > low ? j - 1 : high - 1;
            w->after[j] = j + 1 < high ? j + 1 : low;
        }
    }
}

static void list_open_bridges(mt_walker *w) {
    int open = 0;
    for (int j = 0; j < w->to->count; j++) {
        w->first_open[j] = open;
        for (int b = w->to->first_bridge[j]; b < w->to->first_bridge[j + 1]; b++) {
            w->source[b] = j;
            if (w->to->bridges[b].price < INFINITY) w->open[open++] = b;
        }
        if (open > w->first_open[j]) w->gates[w->gate_count++] = j;
    }
    w->first_open[w->to->count] = open;
}

static mt_status fill_columns(mt_walker *w, mt_arena *arena) {
    size_t m = (size_t)w->to->count;
    double *room = mt_arena_new(arena, 6 * m, sizeof *room);
    if (!room) return MT_NO_MEMORY;
    mt_columns *c = &w->columns;
    *c = (mt_columns){room, room + m, room + 2 * m, room + 3 * m, room + 4 * m, room + 5 * m};
    for (size_t j = 0; j < m; j++) {
        const mt_view *view = &w->to->views[j];
        c->x[j] = view->x;
        c->y[j] = view->y;
        c->in_x[j] = view->in_x;
        c->in_y[j] = view->in_y;
        c->out_x[j] = view->out_x;
        c->out_y[j] = view->out_y;
    }
    return MT_OK;
}

static mt_status start_walker(const mt_border *from, int ring, const mt_border *to, mt_arena *arena,
                              mt_walker *w) {
    *w = (mt_walker){.from = from, .to = to, .first = from->first_of_ring[ring]};
    w->n = from->first_of_ring[ring + 1] - w->first;
    size_t m = (size_t)to->count, cells = ((size_t)w->n + 1) * m,
           bridges = (size_t)to->first_bridge[to->count];
    if (cells > MT_ALIGNMENT_MAX) return MT_TOO_LARGE;
    int *numbers = mt_arena_new(arena, 5 * m + 1 + 2 * bridges, sizeof *numbers);
    w->waits = mt_arena_new(arena, m, sizeof *w->waits);
    w->cost[0] = mt_arena_new(arena, 2 * m, sizeof(double));
    w->price = mt_arena_new(arena, m, sizeof *w->price);
    w->how = mt_arena_new(arena, cells, sizeof *w->how);
    if (!numbers || !w->waits || !w->cost[0] || !w->price || !w->how) return MT_NO_MEMORY;
    w->before = numbers;
    w->after = w->before + m;
    w->gates = w->after + m;
    w->later = w->gates + m;
    w->first_open = w->later + m;
    w->open = w->first_open + m + 1;
    w->source = w->open + bridges;
    w->cost[1] = w->cost[0] + m;
    chain_stops(w);
    list_open_bridges(w);
    return fill_columns(w, arena);
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
