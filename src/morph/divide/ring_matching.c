#include "morph/divide/ring_matching.h"

#include <math.h>

#include "geometry/limits.h"

/* How far a walker looks around: the boundary's samples whose places, each relative to its glyph's box, are farther off than so many
 * boxes in x or in y are out of its reach. Where that leads nowhere it looks twice as far; 1 is all of the box. */
#define SIGHT 0.2

#define WAIT_COST ((float)MT_WAIT_COST)

/* A walk that only has to tell where to start takes each so many-th sample of its ring. */
enum { START_STRIDE = 3 };

/* How a cell was reached. From a chord on, it is the chord's number. */
enum { START, STAY, BOTH, ALONG, BRIDGE };

/* A chord that is not barred. */
typedef struct mt_crossing {
    int to, chord;
    float cost;
} mt_crossing;

/* A stretch of a ring of the boundary, which is in the window, or out of it, as a whole. */
typedef struct mt_stretch {
    int first, end; /* its samples */
    int gate;       /* the first of its gates; they end where the next stretch's begin */
    double low_x, low_y, high_x, high_y;
} mt_stretch;

enum { STRETCH_STOPS = 16 };

typedef struct mt_ring_matcher {
    const mt_boundary *from, *to;
    mt_cost_weights weights;
    mt_columns columns;
    int first, n;    /* the samples of the ring */
    int start;       /* the sample of the ring to start at */
    int stride;      /* from one row to the next: 1, or each so many-th sample */
    int rows;        /* after the first; the last is the first sample again */
    int *before;     /* of each sample of the boundary, the one before it on its ring … */
    int *after;      /* … and the one after it */
    int *source;     /* of each chord, the sample that it leaves */
    int *first_open; /* of each sample, its crossings: open[first_open[j] … first_open[j + 1]) */
    mt_crossing *open;
    int gate_count, *gates;  /* the samples that have such chords */
    int later_count, *later; /* samples whose chords are to be looked at again … */
    bool *waits;             /* … and whether a sample is one of them */
    double window;           /* boxes */
    mt_stretch *stretches;   /* and one more that is empty */
    int *first_stretch;      /* of each ring of the boundary, and one more */
    bool *seen[2];           /* each stretch, by rows: whether it is in the window */
    float *total[2];         /* INFINITY outside the window */
    float *cost;  /* of this sample of the ring with each of the boundary; INFINITY outside the window */
    int32_t *how; /* (n + 1) × to->count */
} mt_ring_matcher;

static int32_t *row_of(const mt_ring_matcher *w, int i) {
    return w->how + (size_t)i * (size_t)w->to->count;
}

/* The sample of the ring in row i; in the last it is that of the first again. */
static int here_at(const mt_ring_matcher *w, int i) {
    return w->first + (i < w->rows ? w->start + i * w->stride : w->start) % w->n;
}

static int stretch_count(const mt_ring_matcher *w) {
    return w->first_stretch[w->to->ring_count];
}

/* Notes that a sample's chords are to be looked at, if it has any. */
static void look_later(mt_ring_matcher *w, int j) {
    if (w->waits[j] || w->first_open[j] == w->first_open[j + 1]) return;
    w->waits[j] = true;
    w->later[w->later_count++] = j;
}

/* ---- what is in the window ---------------------------------------------------------------------------------------------- */

static bool is_in_window(const mt_ring_matcher *w, const mt_sample_view *here, const mt_stretch *stretch) {
    return here->x >= stretch->low_x - w->window && here->x <= stretch->high_x + w->window &&
           here->y >= stretch->low_y - w->window && here->y <= stretch->high_y + w->window;
}

/* Looks around from sample i of the ring: costs for what is in the window, none for what no longer is. */
static void look_around(mt_ring_matcher *w, int i) {
    const mt_sample_view *here = &w->from->views[here_at(w, i)];
    bool *seen = w->seen[i % 2];
    const bool *last = w->seen[(i + 1) % 2];
    float *total = w->total[i % 2];
    for (int s = 0; s < stretch_count(w); s++) {
        const mt_stretch *stretch = &w->stretches[s];
        bool now = is_in_window(w, here, stretch);
        for (int j = stretch->first; seen[s] && !now && j < stretch->end; j++) total[j] = INFINITY;
        for (int j = stretch->first; last[s] && !now && j < stretch->end; j++) w->cost[j] = INFINITY;
        seen[s] = now;
        if (now) mt_step_costs(&w->weights, here, &w->columns, stretch->first, stretch->end, w->cost);
    }
}

static void clear_window(mt_ring_matcher *w) {
    for (int j = 0; j < w->to->count; j++) {
        w->total[0][j] = w->total[1][j] = INFINITY;
        w->cost[j] = INFINITY;
    }
    for (int s = 0; s < stretch_count(w); s++) w->seen[0][s] = w->seen[1][s] = false;
}

/* ---- one row ----------------------------------------------------------------------------------------------------- */

/* Along the ring of the boundary from sample j on, while the ring's walker waits, as long as that is cheaper. What it reaches has
 * its chords to look at. */
static void go_on_from(mt_ring_matcher *w, int j, float *total, int32_t *how) {
    for (;;) {
        int k = w->after[j];
        float by = total[j] + WAIT_COST + w->cost[k];
        if (by >= total[k]) return;
        total[k] = by;
        how[k] = ALONG;
        look_later(w, k);
        j = k;
    }
}

static void step_along(const mt_ring_matcher *w, int j, int k, float *total, int32_t *how) {
    float by = total[j] + WAIT_COST + w->cost[k];
    if (by >= total[k]) return;
    total[k] = by;
    how[k] = ALONG;
}

/* Once along a ring of the boundary that is all in the window, from its cheapest sample, to which no way along the ring can be cheaper. */
static void go_around(const mt_ring_matcher *w, int ring, float *total, int32_t *how) {
    int low = w->to->first_of_ring[ring], high = w->to->first_of_ring[ring + 1], least = low;
    for (int j = low + 1; j < high; j++)
        if (total[j] < total[least]) least = j;
    for (int j = least, k = w->after[j]; k != least; j = k, k = w->after[j]) step_along(w, j, k, total, how);
}

/* Along what is in the window of a ring of the boundary: from a stretch outside the window on, so that nothing comes before its own start. */
static void go_along(const mt_ring_matcher *w, int ring, const bool *seen, float *total, int32_t *how) {
    int low = w->first_stretch[ring], high = w->first_stretch[ring + 1], unseen = low;
    while (unseen < high && seen[unseen]) unseen++;
    if (unseen == high) {
        go_around(w, ring, total, how);
        return;
    }
    for (int k = 1, s = unseen; k < high - low; k++) {
        s = s + 1 < high ? s + 1 : low;
        if (!seen[s]) continue;
        step_along(w, w->before[w->stretches[s].first], w->stretches[s].first, total, how);
        for (int j = w->stretches[s].first + 1; j < w->stretches[s].end; j++)
            step_along(w, j - 1, j, total, how);
    }
}

static void go_across(mt_ring_matcher *w, int j, float *total, int32_t *how) {
    for (int i = w->first_open[j]; i < w->first_open[j + 1]; i++) {
        const mt_crossing *c = &w->open[i];
        float by = total[j] + c->cost;
        if (by >= total[c->to] || by + w->cost[c->to] >= total[c->to]) continue;
        total[c->to] = by + w->cost[c->to];
        how[c->to] = BRIDGE + c->chord;
        look_later(w, c->to);
        go_on_from(w, c->to, total, how);
    }
}

static void settle_row(mt_ring_matcher *w, int i) {
    float *total = w->total[i % 2];
    int32_t *how = row_of(w, i);
    const bool *seen = w->seen[i % 2];
    for (int r = 0; r < w->to->ring_count; r++) go_along(w, r, seen, total, how);
    for (int s = 0; s < stretch_count(w); s++)
        for (int g = w->stretches[s].gate; seen[s] && g < w->stretches[s + 1].gate; g++)
            go_across(w, w->gates[g], total, how);
    while (w->later_count > 0) {
        int j = w->later[--w->later_count];
        w->waits[j] = false;
        go_across(w, j, total, how);
    }
}

/* From the row before to a stretch, the ring's walker alone or both going on. */
static void go_on_to(const mt_ring_matcher *w, int i, const mt_stretch *stretch) {
    const float *restrict last = w->total[(i + 1) % 2], *restrict cost = w->cost;
    float *restrict total = w->total[i % 2];
    int32_t *restrict how = row_of(w, i);
    int first = stretch->first;
    float both = last[w->before[first]], stay = last[first] + WAIT_COST;
    total[first] = (stay < both ? stay : both) + cost[first];
    how[first] = stay < both ? STAY : BOTH;
    for (int j = first + 1; j < stretch->end; j++) {
        float waits = last[j] + WAIT_COST;
        total[j] = (waits < last[j - 1] ? waits : last[j - 1]) + cost[j];
        how[j] = waits < last[j - 1] ? STAY : BOTH;
    }
}

static void next_row(mt_ring_matcher *w, int i) {
    look_around(w, i);
    for (int s = 0; s < stretch_count(w); s++)
        if (w->seen[i % 2][s]) go_on_to(w, i, &w->stretches[s]);
    settle_row(w, i);
}

/* ---- a lap ------------------------------------------------------------------------------------------------------- */

/* Fills the table for once around the ring, from any sample of the boundary, or from `there` when it is not -1. */
static void fill(mt_ring_matcher *w, int there) {
    clear_window(w);
    look_around(w, 0);
    for (int j = 0; j < w->to->count; j++) {
        w->total[0][j] = there < 0 || there == j ? w->cost[j] : INFINITY;
        row_of(w, 0)[j] = START;
    }
    settle_row(w, 0);
    for (int i = 1; i <= w->rows; i++) next_row(w, i);
}

static int cheapest_end(const mt_ring_matcher *w) {
    const float *total = w->total[w->rows % 2];
    int best = 0;
    for (int j = 1; j < w->to->count; j++)
        if (total[j] < total[best]) best = j;
    return best;
}

/* The end of a lap, from any sample when `there` is -1, with as much in the window as it takes. */
static int walk_lap(mt_ring_matcher *w, int there, int stride) {
    w->stride = stride;
    w->rows = (w->n + stride - 1) / stride;
    for (;; w->window *= 2) {
        fill(w, there);
        int end = there < 0 ? cheapest_end(w) : there;
        if (w->total[w->rows % 2][end] < INFINITY) return end;
    }
}

/* Reads the way back from the end; writes it when there is room, and returns how many steps it has. */
static int read_back(const mt_ring_matcher *w, int end, mt_match_step *steps, int room) {
    int count = 0, i = w->rows, j = end;
    for (;;) {
        int32_t how = row_of(w, i)[j];
        int here = here_at(w, i);
        if (steps) steps[room - 1 - count] = (mt_match_step){here, j, how >= BRIDGE ? how - BRIDGE : -1};
        count++;
        if (how == START) return count;
        if (how == STAY || how == BOTH) i--;
        if (how == BOTH || how == ALONG) j = w->before[j];
        if (how >= BRIDGE) j = w->source[how - BRIDGE];
    }
}

/* ---- getting ready ----------------------------------------------------------------------------------------------- */

/* The rings of the boundary as chains of samples. */
static void chain_samples(mt_ring_matcher *w) {
    for (int r = 0; r < w->to->ring_count; r++) {
        int low = w->to->first_of_ring[r], high = w->to->first_of_ring[r + 1];
        for (int j = low; j < high; j++) {
            w->before[j] = j > low ? j - 1 : high - 1;
            w->after[j] = j + 1 < high ? j + 1 : low;
        }
    }
}

static void list_open_chords(mt_ring_matcher *w) {
    int open = 0;
    for (int j = 0; j < w->to->count; j++) {
        w->first_open[j] = open;
        for (int b = w->to->first_chord[j]; b < w->to->first_chord[j + 1]; b++) {
            w->source[b] = j;
            const mt_chord *chord = &w->to->chords[b];
            if (chord->cost < INFINITY) w->open[open++] = (mt_crossing){chord->to, b, (float)chord->cost};
        }
        if (open > w->first_open[j]) w->gates[w->gate_count++] = j;
    }
    w->first_open[w->to->count] = open;
}

static mt_stretch stretch_of(const mt_ring_matcher *w, int first, int end) {
    mt_stretch made = {first, end, 0, INFINITY, INFINITY, -INFINITY, -INFINITY};
    for (int j = first; j < end; j++) {
        const mt_sample_view *view = &w->to->views[j];
        made.low_x = fmin(made.low_x, view->x);
        made.low_y = fmin(made.low_y, view->y);
        made.high_x = fmax(made.high_x, view->x);
        made.high_y = fmax(made.high_y, view->y);
    }
    return made;
}

static void list_stretches(mt_ring_matcher *w) {
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

static mt_status make_stretches(mt_ring_matcher *w, mt_arena *arena) {
    size_t rings = (size_t)w->to->ring_count, most = (size_t)w->to->count / STRETCH_STOPS + rings + 1;
    w->stretches = mt_arena_new(arena, most, sizeof *w->stretches);
    w->first_stretch = mt_arena_new(arena, rings + 1, sizeof *w->first_stretch);
    w->seen[0] = mt_arena_new(arena, 2 * most, sizeof(bool));
    if (!w->stretches || !w->first_stretch || !w->seen[0]) return MT_NO_MEMORY;
    w->seen[1] = w->seen[0] + most;
    list_stretches(w);
    return MT_OK;
}

static mt_status start_walker(const mt_boundary *from, int ring, const mt_boundary *to,
                              const mt_cost_weights *weights, mt_arena *arena, mt_ring_matcher *w) {
    *w = (mt_ring_matcher){
        .from = from, .to = to, .weights = *weights, .first = from->first_of_ring[ring], .window = SIGHT};
    w->n = from->first_of_ring[ring + 1] - w->first;
    size_t m = (size_t)to->count, cells = ((size_t)w->n + 1) * m, chords = (size_t)to->first_chord[to->count];
    if (cells > MT_ALIGNMENT_MAX) return MT_TOO_LARGE;
    int *numbers = mt_arena_new(arena, 5 * m + 1 + chords, sizeof *numbers);
    w->open = mt_arena_new(arena, chords, sizeof *w->open);
    w->waits = mt_arena_new(arena, m, sizeof *w->waits);
    w->total[0] = mt_arena_new(arena, 2 * m, sizeof(float));
    w->cost = mt_arena_new(arena, m, sizeof *w->cost);
    w->how = mt_arena_new(arena, cells, sizeof *w->how);
    if (!numbers || !w->open || !w->waits || !w->total[0] || !w->cost || !w->how) return MT_NO_MEMORY;
    w->before = numbers;
    w->after = w->before + m;
    w->gates = w->after + m;
    w->later = w->gates + m;
    w->first_open = w->later + m;
    w->source = w->first_open + m + 1;
    w->total[1] = w->total[0] + m;
    chain_samples(w);
    list_open_chords(w);
    mt_status status = make_stretches(w, arena);
    return status == MT_OK ? mt_columns_of(w->to->views, w->to->count, arena, &w->columns) : status;
}

/* The surest step of a walk: where the two samples are most alike. */
static mt_match_step surest(const mt_ring_matcher *w, const mt_match_step *steps, int count) {
    mt_match_step best = steps[0];
    double least = INFINITY;
    for (int k = 0; k < count; k++) {
        double cost =
            mt_step_cost(&w->weights, &w->from->views[steps[k].here], &w->to->views[steps[k].there]);
        if (cost >= least) continue;
        least = cost;
        best = steps[k];
    }
    return best;
}

/* Where a closed walk may start: where an open one, in longer strides, is surest. */
static mt_status find_start(mt_ring_matcher *w, mt_arena *arena, mt_match_step *start) {
    int end = walk_lap(w, -1, START_STRIDE), count = read_back(w, end, NULL, 0);
    mt_match_step *steps = mt_arena_new(arena, (size_t)count, sizeof *steps);
    if (!steps) return MT_NO_MEMORY;
    read_back(w, end, steps, count);
    *start = surest(w, steps, count);
    return MT_OK;
}

mt_status mt_match_ring(const mt_boundary *from, int ring, const mt_boundary *to,
                        const mt_cost_weights *weights, const mt_match_step *start, mt_arena *arena,
                        mt_ring_match *walk) {
    mt_ring_matcher w;
    mt_match_step first = start ? *start : (mt_match_step){0};
    mt_status status = start_walker(from, ring, to, weights, arena, &w);
    if (status == MT_OK && !start) status = find_start(&w, arena, &first);
    if (status != MT_OK) return status;
    w.start = first.here - w.first;
    walk_lap(&w, first.there, 1);
    *walk = (mt_ring_match){.count = read_back(&w, first.there, NULL, 0)};
    walk->cost = (double)w.total[w.rows % 2][first.there] / walk->count;
    walk->steps = mt_arena_new(arena, (size_t)walk->count, sizeof *walk->steps);
    if (!walk->steps) return MT_NO_MEMORY;
    read_back(&w, first.there, walk->steps, walk->count);
    return MT_OK;
}
