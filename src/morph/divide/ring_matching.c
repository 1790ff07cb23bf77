#include "morph/divide/ring_matching.h"

#include <math.h>

#include "geometry/limits.h"
#include "morph/align/columns.h"

/* How far a walker looks around: the border's stops whose places, each relative to its glyph's box, are farther off than so many
 * boxes in x or in y are out of its reach. Where that leads nowhere it looks twice as far; 1 is all of the box. */
#define SIGHT 0.2

#define WAIT_PRICE ((float)MT_WAIT_PRICE)

/* A walk that only has to tell where to start takes each so many-th stop of its ring. */
enum { START_STRIDE = 3 };

/* How a cell was reached. From a bridge on, it is the bridge's number. */
enum { START, STAY, BOTH, ALONG, BRIDGE };

/* A bridge that is not barred. */
typedef struct mt_crossing {
    int to, bridge;
    float price;
} mt_crossing;

/* A stretch of a ring of the border, which is in sight, or out of it, as a whole. */
typedef struct mt_stretch {
    int first, end; /* its stops */
    int gate;       /* the first of its gates; they end where the next stretch's begin */
    double low_x, low_y, high_x, high_y;
} mt_stretch;

enum { STRETCH_STOPS = 16 };

typedef struct mt_walker {
    const mt_border *from, *to;
    mt_tariff tariff;
    mt_columns columns;
    int first, n;    /* the stops of the ring */
    int start;       /* the stop of the ring to start at */
    int stride;      /* from one row to the next: 1, or each so many-th stop */
    int rows;        /* after the first; the last is the first stop again */
    int *before;     /* of each stop of the border, the one before it on its ring … */
    int *after;      /* … and the one after it */
    int *source;     /* of each bridge, the stop that it leaves */
    int *first_open; /* of each stop, its crossings: open[first_open[j] … first_open[j + 1]) */
    mt_crossing *open;
    int gate_count, *gates;  /* the stops that have such bridges */
    int later_count, *later; /* stops whose bridges are to be looked at again … */
    bool *waits;             /* … and whether a stop is one of them */
    double sight;            /* boxes */
    mt_stretch *stretches;   /* and one more that is empty */
    int *first_stretch;      /* of each ring of the border, and one more */
    bool *seen[2];           /* each stretch, by rows: whether it is in sight */
    float *cost[2];          /* INFINITY out of sight */
    float *price;            /* of this stop of the ring with each of the border; INFINITY out of sight */
    int32_t *how;            /* (n + 1) × to->count */
} mt_walker;

static int32_t *row_of(const mt_walker *w, int i) {
    return w->how + (size_t)i * (size_t)w->to->count;
}

/* The stop of the ring in row i; in the last it is that of the first again. */
static int here_at(const mt_walker *w, int i) {
    return w->first + (i < w->rows ? w->start + i * w->stride : w->start) % w->n;
}

static int stretch_count(const mt_walker *w) {
    return w->first_stretch[w->to->ring_count];
}

/* Notes that a stop's bridges are to be looked at, if it has any. */
static void look_later(mt_walker *w, int j) {
    if (w->waits[j] || w->first_open[j] == w->first_open[j + 1]) return;
    w->waits[j] = true;
    w->later[w->later_count++] = j;
}

/* ---- what is in sight ---------------------------------------------------------------------------------------------- */

static bool is_in_sight(const mt_walker *w, const mt_view *here, const mt_stretch *stretch) {
    return here->x >= stretch->low_x - w->sight && here->x <= stretch->high_x + w->sight &&
           here->y >= stretch->low_y - w->sight && here->y <= stretch->high_y + w->sight;
}

/* Looks around from stop i of the ring: prices for what is in sight, none for what no longer is. */
static void look_around(mt_walker *w, int i) {
    const mt_view *here = &w->from->views[here_at(w, i)];
    bool *seen = w->seen[i % 2];
    const bool *last = w->seen[(i + 1) % 2];
    float *cost = w->cost[i % 2];
    for (int s = 0; s < stretch_count(w); s++) {
        const mt_stretch *stretch = &w->stretches[s];
        bool now = is_in_sight(w, here, stretch);
        for (int j = stretch->first; seen[s] && !now && j < stretch->end; j++) cost[j] = INFINITY;
        for (int j = stretch->first; last[s] && !now && j < stretch->end; j++) w->price[j] = INFINITY;
        seen[s] = now;
        if (now) mt_price_all(&w->tariff, here, &w->columns, stretch->first, stretch->end, w->price);
    }
}

static void shut_eyes(mt_walker *w) {
    for (int j = 0; j < w->to->count; j++) {
        w->cost[0][j] = w->cost[1][j] = INFINITY;
        w->price[j] = INFINITY;
    }
    for (int s = 0; s < stretch_count(w); s++) w->seen[0][s] = w->seen[1][s] = false;
}

/* ---- one row ----------------------------------------------------------------------------------------------------- */

/* Along the ring of the border from stop j on, while the ring's walker waits, as long as that is cheaper. What it reaches has
 * its bridges to look at. */
static void go_on_from(mt_walker *w, int j, float *cost, int32_t *how) {
    for (;;) {
        int k = w->after[j];
        float by = cost[j] + WAIT_PRICE + w->price[k];
        if (by >= cost[k]) return;
        cost[k] = by;
        how[k] = ALONG;
        look_later(w, k);
        j = k;
    }
}

static void step_along(const mt_walker *w, int j, int k, float *cost, int32_t *how) {
    float by = cost[j] + WAIT_PRICE + w->price[k];
    if (by >= cost[k]) return;
    cost[k] = by;
    how[k] = ALONG;
}

/* Once along a ring of the border that is all in sight, from its cheapest stop, to which no way along the ring can be cheaper. */
static void go_around(const mt_walker *w, int ring, float *cost, int32_t *how) {
    int low = w->to->first_of_ring[ring], high = w->to->first_of_ring[ring + 1], least = low;
    for (int j = low + 1; j < high; j++)
        if (cost[j] < cost[least]) least = j;
    for (int j = least, k = w->after[j]; k != least; j = k, k = w->after[j]) step_along(w, j, k, cost, how);
}

/* Along what is in sight of a ring of the border: from a stretch out of sight on, so that nothing comes before its own start. */
static void go_along(const mt_walker *w, int ring, const bool *seen, float *cost, int32_t *how) {
    int low = w->first_stretch[ring], high = w->first_stretch[ring + 1], unseen = low;
    while (unseen < high && seen[unseen]) unseen++;
    if (unseen == high) {
        go_around(w, ring, cost, how);
        return;
    }
    for (int k = 1, s = unseen; k < high - low; k++) {
        s = s + 1 < high ? s + 1 : low;
        if (!seen[s]) continue;
        step_along(w, w->before[w->stretches[s].first], w->stretches[s].first, cost, how);
        for (int j = w->stretches[s].first + 1; j < w->stretches[s].end; j++)
            step_along(w, j - 1, j, cost, how);
    }
}

static void go_across(mt_walker *w, int j, float *cost, int32_t *how) {
    for (int i = w->first_open[j]; i < w->first_open[j + 1]; i++) {
        const mt_crossing *c = &w->open[i];
        float by = cost[j] + c->price;
        if (by >= cost[c->to] || by + w->price[c->to] >= cost[c->to]) continue;
        cost[c->to] = by + w->price[c->to];
        how[c->to] = BRIDGE + c->bridge;
        look_later(w, c->to);
        go_on_from(w, c->to, cost, how);
    }
}

static void settle_row(mt_walker *w, int i) {
    float *cost = w->cost[i % 2];
    int32_t *how = row_of(w, i);
    const bool *seen = w->seen[i % 2];
    for (int r = 0; r < w->to->ring_count; r++) go_along(w, r, seen, cost, how);
    for (int s = 0; s < stretch_count(w); s++)
        for (int g = w->stretches[s].gate; seen[s] && g < w->stretches[s + 1].gate; g++)
            go_across(w, w->gates[g], cost, how);
    while (w->later_count > 0) {
        int j = w->later[--w->later_count];
        w->waits[j] = false;
        go_across(w, j, cost, how);
    }
}

/* From the row before to a stretch, the ring's walker alone or both going on. */
static void go_on_to(const mt_walker *w, int i, const mt_stretch *stretch) {
    const float *restrict last = w->cost[(i + 1) % 2], *restrict price = w->price;
    float *restrict cost = w->cost[i % 2];
    int32_t *restrict how = row_of(w, i);
    int first = stretch->first;
    float both = last[w->before[first]], stay = last[first] + WAIT_PRICE;
    cost[first] = (stay < both ? stay : both) + price[first];
    how[first] = stay < both ? STAY : BOTH;
    for (int j = first + 1; j < stretch->end; j++) {
        float waits = last[j] + WAIT_PRICE;
        cost[j] = (waits < last[j - 1] ? waits : last[j - 1]) + price[j];
        how[j] = waits < last[j - 1] ? STAY : BOTH;
    }
}

static void next_row(mt_walker *w, int i) {
    look_around(w, i);
    for (int s = 0; s < stretch_count(w); s++)
        if (w->seen[i % 2][s]) go_on_to(w, i, &w->stretches[s]);
    settle_row(w, i);
}

/* ---- a lap ------------------------------------------------------------------------------------------------------- */

/* Fills the table for once around the ring, from any stop of the border, or from `there` when it is not -1. */
static void fill(mt_walker *w, int there) {
    shut_eyes(w);
    look_around(w, 0);
    for (int j = 0; j < w->to->count; j++) {
        w->cost[0][j] = there < 0 || there == j ? w->price[j] : INFINITY;
        row_of(w, 0)[j] = START;
    }
    settle_row(w, 0);
    for (int i = 1; i <= w->rows; i++) next_row(w, i);
}

static int cheapest_end(const mt_walker *w) {
    const float *cost = w->cost[w->rows % 2];
    int best = 0;
    for (int j = 1; j < w->to->count; j++)
        if (cost[j] < cost[best]) best = j;
    return best;
}

/* The end of a lap, from any stop when `there` is -1, with as much in sight as it takes. */
static int walk_lap(mt_walker *w, int there, int stride) {
    w->stride = stride;
    w->rows = (w->n + stride - 1) / stride;
    for (;; w->sight *= 2) {
        fill(w, there);
        int end = there < 0 ? cheapest_end(w) : there;
        if (w->cost[w->rows % 2][end] < INFINITY) return end;
    }
}

/* Reads the way back from the end; writes it when there is room, and returns how many paces it has. */
static int read_back(const mt_walker *w, int end, mt_pace *paces, int room) {
    int count = 0, i = w->rows, j = end;
    for (;;) {
        int32_t how = row_of(w, i)[j];
        int here = here_at(w, i);
        if (paces) paces[room - 1 - count] = (mt_pace){here, j, how >= BRIDGE ? how - BRIDGE : -1};
        count++;
        if (how == START) return count;
        if (how == STAY || how == BOTH) i--;
        if (how == BOTH || how == ALONG) j = w->before[j];
        if (how >= BRIDGE) j = w->source[how - BRIDGE];
    }
}

/* ---- getting ready ----------------------------------------------------------------------------------------------- */

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
            const mt_bridge *bridge = &w->to->bridges[b];
            if (bridge->price < INFINITY)
                w->open[open++] = (mt_crossing){bridge->to, b, (float)bridge->price};
        }
        if (open > w->first_open[j]) w->gates[w->gate_count++] = j;
    }
    w->first_open[w->to->count] = open;
}

static mt_stretch stretch_of(const mt_walker *w, int first, int end) {
    mt_stretch made = {first, end, 0, INFINITY, INFINITY, -INFINITY, -INFINITY};
    for (int j = first; j < end; j++) {
        const mt_view *view = &w->to->views[j];
        made.low_x = fmin(made.low_x, view->x);
        made.low_y = fmin(made.low_y, view->y);
        made.high_x = fmax(made.high_x, view->x);
        made.high_y = fmax(made.high_y, view->y);
    }
    return made;
}

static void list_stretches(mt_walker *w) {
    int made = 0, gate = 0;
    for (int r = 0; r < w->to->ring_count; r++) {
        int high = w->to->first_of_ring[r + 1];
        w->first_stretch[r] = made;
        for (int j = w->to->first_of_ring[r]; j < high; j += STRETCH_STOPS) {
            mt_stretch *stretch = &w->stretches[made++];
            *stretch = stretch_of(w, j, j + STRETCH_STOPS < high ? j + STRETCH_STOPS : high);
            stretch->gate = gate;
            while (gate < w->gate_count && w->gates[gate] < stretch->end) gate++;
        }
    }
    w->first_stretch[w->to->ring_count] = made;
    w->stretches[made].gate = gate;
}

static mt_status make_stretches(mt_walker *w, mt_arena *arena) {
    size_t rings = (size_t)w->to->ring_count, most = (size_t)w->to->count / STRETCH_STOPS + rings + 1;
    w->stretches = mt_arena_new(arena, most, sizeof *w->stretches);
    w->first_stretch = mt_arena_new(arena, rings + 1, sizeof *w->first_stretch);
    w->seen[0] = mt_arena_new(arena, 2 * most, sizeof(bool));
    if (!w->stretches || !w->first_stretch || !w->seen[0]) return MT_NO_MEMORY;
    w->seen[1] = w->seen[0] + most;
    list_stretches(w);
    return MT_OK;
}

static mt_status start_walker(const mt_border *from, int ring, const mt_border *to, const mt_tariff *tariff,
                              mt_arena *arena, mt_walker *w) {
    *w = (mt_walker){
        .from = from, .to = to, .tariff = *tariff, .first = from->first_of_ring[ring], .sight = SIGHT};
    w->n = from->first_of_ring[ring + 1] - w->first;
    size_t m = (size_t)to->count, cells = ((size_t)w->n + 1) * m,
           bridges = (size_t)to->first_bridge[to->count];
    if (cells > MT_ALIGNMENT_MAX) return MT_TOO_LARGE;
    int *numbers = mt_arena_new(arena, 5 * m + 1 + bridges, sizeof *numbers);
    w->open = mt_arena_new(arena, bridges, sizeof *w->open);
    w->waits = mt_arena_new(arena, m, sizeof *w->waits);
    w->cost[0] = mt_arena_new(arena, 2 * m, sizeof(float));
    w->price = mt_arena_new(arena, m, sizeof *w->price);
    w->how = mt_arena_new(arena, cells, sizeof *w->how);
    if (!numbers || !w->open || !w->waits || !w->cost[0] || !w->price || !w->how) return MT_NO_MEMORY;
    w->before = numbers;
    w->after = w->before + m;
    w->gates = w->after + m;
    w->later = w->gates + m;
    w->first_open = w->later + m;
    w->source = w->first_open + m + 1;
    w->cost[1] = w->cost[0] + m;
    chain_stops(w);
    list_open_bridges(w);
    mt_status status = make_stretches(w, arena);
    return status == MT_OK ? mt_columns_of(w->to->views, w->to->count, arena, &w->columns) : status;
}

/* The surest pace of a walk: where the two stops are most alike. */
static mt_pace surest(const mt_walker *w, const mt_pace *paces, int count) {
    mt_pace best = paces[0];
    double least = INFINITY;
    for (int k = 0; k < count; k++) {
        double price = mt_price(&w->tariff, &w->from->views[paces[k].here], &w->to->views[paces[k].there]);
        if (price >= least) continue;
        least = price;
        best = paces[k];
    }
    return best;
}

/* Where a closed walk may start: where an open one, in longer strides, is surest. */
static mt_status find_start(mt_walker *w, mt_arena *arena, mt_pace *start) {
    int end = walk_lap(w, -1, START_STRIDE), count = read_back(w, end, NULL, 0);
    mt_pace *paces = mt_arena_new(arena, (size_t)count, sizeof *paces);
    if (!paces) return MT_NO_MEMORY;
    read_back(w, end, paces, count);
    *start = surest(w, paces, count);
    return MT_OK;
}

mt_status mt_walk_around(const mt_border *from, int ring, const mt_border *to, const mt_tariff *tariff,
                         const mt_pace *start, mt_arena *arena, mt_walk *walk) {
    mt_walker w;
    mt_pace first = start ? *start : (mt_pace){0};
    mt_status status = start_walker(from, ring, to, tariff, arena, &w);
    if (status == MT_OK && !start) status = find_start(&w, arena, &first);
    if (status != MT_OK) return status;
    w.start = first.here - w.first;
    walk_lap(&w, first.there, 1);
    *walk = (mt_walk){.count = read_back(&w, first.there, NULL, 0)};
    walk->price = (double)w.cost[w.rows % 2][first.there] / walk->count;
    walk->paces = mt_arena_new(arena, (size_t)walk->count, sizeof *walk->paces);
    if (!walk->paces) return MT_NO_MEMORY;
    read_back(&w, first.there, walk->paces, walk->count);
    return MT_OK;
}
