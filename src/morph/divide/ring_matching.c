/* Dynamic programming over pairs of a ring's sample and a sample of the other glyph's whole boundary. Row i holds the least cost of
 * reaching each sample of the boundary while the ring is at its sample i:
 *
 *     row i-1   ●  ●  ●  ●        from the row before: BOTH advance, or the boundary's sample WAITs
 *                ╲ │              within the row:      ALONG the boundary's ring, the ring waits
 *     row i     ●─▶●─▶●┄┄▶●                            over a chord (┄) or a jump, at its cost
 *
 * A row is settled as by a label-correcting search of shortest paths: once along each ring, then over the chords of every junction, then
 * from each sample that became cheaper. Rows hold only samples in a window around the ring's sample; where no closed path fits in it, it
 * is doubled. A first, open match in strides of START_STRIDE finds the step to start and end the closed one with. Invariants: each
 * sample of the ring is in the match, in order; the first step is the last. O(n m) for n and m samples, 4 n m bytes. */
#include "morph/divide/ring_matching.h"

#include <assert.h>
#include <math.h>

#include "geometry/limits.h"

/* The window, in boxes: samples of the boundary whose places, each relative to its glyph's box, are further off in x or in y are left
 * out; it is doubled where no closed match fits in it. */
#define WINDOW 0.2

#define WAIT_COST ((float)MT_WAIT_COST)

/* The open match, which only finds a start, takes every third sample of its ring. */
enum { START_STRIDE = 3 };

/* The last step to a cell; FIRST_CHORD + k is chord k. */
enum { START, WAIT, BOTH, ALONG, FIRST_CHORD };

/* A chord that is not barred. */
typedef struct mt_open_chord {
    int to, chord;
    float cost;
} mt_open_chord;

/* Consecutive samples of a ring of the boundary, which are in the window, or out of it, together. */
typedef struct mt_sample_run {
    int first, end; /* its samples */
    int junction;   /* its first junction; they end where the next run's begin */
    double low_x, low_y, high_x, high_y;
} mt_sample_run;

enum { RUN_SAMPLES = 16 };

typedef struct mt_ring_matcher {
    const mt_boundary *from, *to;
    mt_cost_weights weights;
    mt_columns columns;
    int first, n;    /* the samples of the ring */
    int start;       /* offset in the ring of the sample to start at */
    int stride;      /* samples of the ring from one row to the next */
    int rows;        /* after the first; the last is the first sample again */
    int *before;     /* of each sample of the boundary, the one before it on its ring … */
    int *after;      /* … and the one after it */
    int *source;     /* of each chord, the sample that it leaves */
    int *first_open; /* of each sample, its crossings: open[first_open[j] … first_open[j + 1]) */
    mt_open_chord *open;
    int junction_count, *junctions; /* the samples that have open chords */
    int pending_count, *pending;    /* samples whose chords have to be relaxed again … */
    bool *is_pending;               /* … and whether a sample is among them */
    double window;                  /* boxes */
    mt_sample_run *runs;            /* and one more, empty */
    int *first_run;                 /* of each ring of the boundary, and one more */
    bool *in_window[2];             /* of the last two rows: whether each run is in the window */
    float *total[2];                /* of the last two rows: least costs; INFINITY outside the window */
    float *cost; /* of this row's sample of the ring with each of the boundary; INFINITY outside the window */
    int32_t *how; /* (n + 1) × to->count: last steps */
    mt_arena *arena;
} mt_ring_matcher;

static int32_t *row_of(const mt_ring_matcher *t, int i) {
    return t->how + (size_t)i * (size_t)t->to->count;
}

/* The sample of the ring in row i; the last row has that of the first. */
static int here_at(const mt_ring_matcher *t, int i) {
    return t->first + (i < t->rows ? t->start + i * t->stride : t->start) % t->n;
}

static int run_count(const mt_ring_matcher *t) {
    return t->first_run[t->to->ring_count];
}

/* Puts a sample with open chords among those pending. */
static void mark_pending(mt_ring_matcher *t, int j) {
    if (t->is_pending[j] || t->first_open[j] == t->first_open[j + 1]) return;
    t->is_pending[j] = true;
    t->pending[t->pending_count++] = j;
}

/* ---- the window ---------------------------------------------------------------------------------------------------------- */

static bool is_in_window(const mt_ring_matcher *t, const mt_sample_view *here, const mt_sample_run *run) {
    return here->x >= run->low_x - t->window && here->x <= run->high_x + t->window &&
           here->y >= run->low_y - t->window && here->y <= run->high_y + t->window;
}

/* Moves the window to row i: costs for the runs in it, INFINITY for those that left it. */
static void move_window(mt_ring_matcher *t, int i) {
    const mt_sample_view *here = &t->from->views[here_at(t, i)];
    bool *in_window = t->in_window[i % 2];
    const bool *last = t->in_window[(i + 1) % 2];
    float *total = t->total[i % 2];
    for (int s = 0; s < run_count(t); s++) {
        const mt_sample_run *run = &t->runs[s];
        bool now = is_in_window(t, here, run);
        for (int j = run->first; in_window[s] && !now && j < run->end; j++) total[j] = INFINITY;
        for (int j = run->first; last[s] && !now && j < run->end; j++) t->cost[j] = INFINITY;
        in_window[s] = now;
        if (now) mt_step_costs(&t->weights, here, &t->columns, run->first, run->end, t->cost);
    }
}

static void clear_window(mt_ring_matcher *t) {
    for (int j = 0; j < t->to->count; j++) {
        t->total[0][j] = t->total[1][j] = INFINITY;
        t->cost[j] = INFINITY;
    }
    for (int s = 0; s < run_count(t); s++) t->in_window[0][s] = t->in_window[1][s] = false;
}

/* ---- one row ----------------------------------------------------------------------------------------------------- */

/* Relaxes steps along the boundary's ring from sample j on, as long as they are cheaper, and marks the samples reached as pending. */
static void extend_from(mt_ring_matcher *t, int j, float *total, int32_t *how) {
    for (;;) {
        int k = t->after[j];
        float by = total[j] + WAIT_COST + t->cost[k];
        if (by >= total[k]) return;
        total[k] = by;
        how[k] = ALONG;
        mark_pending(t, k);
        j = k;
    }
}

static void relax_along(const mt_ring_matcher *t, int j, int k, float *total, int32_t *how) {
    float by = total[j] + WAIT_COST + t->cost[k];
    if (by >= total[k]) return;
    total[k] = by;
    how[k] = ALONG;
}

/* Once along a ring that is all in the window, from its cheapest sample, which no path along the ring can make cheaper. */
static void relax_full_ring(const mt_ring_matcher *t, int ring, float *total, int32_t *how) {
    int low = t->to->first_of_ring[ring], high = t->to->first_of_ring[ring + 1], least = low;
    for (int j = low + 1; j < high; j++)
        if (total[j] < total[least]) least = j;
    for (int j = least, k = t->after[j]; k != least; j = k, k = t->after[j]) relax_along(t, j, k, total, how);
}

/* Along the part of a ring in the window, from a run outside of it on, so that samples are relaxed in the ring's order. */
static void relax_ring(const mt_ring_matcher *t, int ring, const bool *in_window, float *total,
                       int32_t *how) {
    int low = t->first_run[ring], high = t->first_run[ring + 1], outside = low;
    while (outside < high && in_window[outside]) outside++;
    if (outside == high) {
        relax_full_ring(t, ring, total, how);
        return;
    }
    for (int k = 1, s = outside; k < high - low; k++) {
        s = s + 1 < high ? s + 1 : low;
        if (!in_window[s]) continue;
        relax_along(t, t->before[t->runs[s].first], t->runs[s].first, total, how);
        for (int j = t->runs[s].first + 1; j < t->runs[s].end; j++) relax_along(t, j - 1, j, total, how);
    }
}

static void relax_chords(mt_ring_matcher *t, int j, float *total, int32_t *how) {
    for (int i = t->first_open[j]; i < t->first_open[j + 1]; i++) {
        const mt_open_chord *c = &t->open[i];
        float by = total[j] + c->cost;
        if (by >= total[c->to] || by + t->cost[c->to] >= total[c->to]) continue;
        total[c->to] = by + t->cost[c->to];
        how[c->to] = FIRST_CHORD + c->chord;
        mark_pending(t, c->to);
        extend_from(t, c->to, total, how);
    }
}

static void settle_row(mt_ring_matcher *t, int i) {
    float *total = t->total[i % 2];
    int32_t *how = row_of(t, i);
    const bool *in_window = t->in_window[i % 2];
    for (int r = 0; r < t->to->ring_count; r++) relax_ring(t, r, in_window, total, how);
    for (int s = 0; s < run_count(t); s++)
        for (int g = t->runs[s].junction; in_window[s] && g < t->runs[s + 1].junction; g++)
            relax_chords(t, t->junctions[g], total, how);
    while (t->pending_count > 0) {
        int j = t->pending[--t->pending_count], chords = t->first_open[j + 1] - t->first_open[j];
        t->is_pending[j] = false;
        if (mt_arena_spend(t->arena, chords)) relax_chords(t, j, total, how);
    }
}

/* Steps from the row before to a run: the ring advances, alone or with the boundary. */
static void advance_ring(const mt_ring_matcher *t, int i, const mt_sample_run *run) {
    const float *restrict last = t->total[(i + 1) % 2], *restrict cost = t->cost;
    float *restrict total = t->total[i % 2];
    int32_t *restrict how = row_of(t, i);
    int first = run->first;
    float both = last[t->before[first]], stay = last[first] + WAIT_COST;
    total[first] = (stay < both ? stay : both) + cost[first];
    how[first] = stay < both ? WAIT : BOTH;
    for (int j = first + 1; j < run->end; j++) {
        float waits = last[j] + WAIT_COST;
        total[j] = (waits < last[j - 1] ? waits : last[j - 1]) + cost[j];
        how[j] = waits < last[j - 1] ? WAIT : BOTH;
    }
}

static void fill_row(mt_ring_matcher *t, int i) {
    move_window(t, i);
    for (int s = 0; s < run_count(t); s++)
        if (t->in_window[i % 2][s]) advance_ring(t, i, &t->runs[s]);
    settle_row(t, i);
}

/* ---- a match ------------------------------------------------------------------------------------------------------- */

/* Fills the table, from any sample of the boundary, or from `there` when it is not -1. */
static void fill(mt_ring_matcher *t, int there) {
    clear_window(t);
    move_window(t, 0);
    for (int j = 0; j < t->to->count; j++) {
        t->total[0][j] = there < 0 || there == j ? t->cost[j] : INFINITY;
        row_of(t, 0)[j] = START;
    }
    settle_row(t, 0);
    for (int i = 1; i <= t->rows && mt_arena_spend(t->arena, t->to->count); i++) fill_row(t, i);
}

static int cheapest_end(const mt_ring_matcher *t) {
    const float *total = t->total[t->rows % 2];
    int best = 0;
    for (int j = 1; j < t->to->count; j++)
        if (total[j] < total[best]) best = j;
    return best;
}

/* The last sample of a match, from any sample when `there` is -1; the window grows until there is one. -1 where the arena's steps are
 * spent. */
static int match_around(mt_ring_matcher *t, int there, int stride) {
    t->stride = stride;
    t->rows = (t->n + stride - 1) / stride;
    for (;; t->window *= 2) {
        fill(t, there);
        if (mt_arena_is_spent(t->arena)) return -1;
        int end = there < 0 ? cheapest_end(t) : there;
        if (t->total[t->rows % 2][end] < INFINITY) return end;
    }
}

/* Counts the steps of the path to `end`, and writes them when `steps` is not NULL. */
static int read_path(const mt_ring_matcher *t, int end, mt_match_step *steps, int room) {
    int count = 0, i = t->rows, j = end;
    for (;;) {
        int32_t how = row_of(t, i)[j];
        int here = here_at(t, i);
        if (steps)
            steps[room - 1 - count] = (mt_match_step){here, j, how >= FIRST_CHORD ? how - FIRST_CHORD : -1};
        count++;
        if (how == START) return count;
        if (how == WAIT || how == BOTH) i--;
        if (how == BOTH || how == ALONG) j = t->before[j];
        if (how >= FIRST_CHORD) j = t->source[how - FIRST_CHORD];
    }
}

/* ---- the matcher ------------------------------------------------------------------------------------------------- */

/* Links the samples of each ring of the boundary. */
static void link_neighbours(mt_ring_matcher *t) {
    for (int r = 0; r < t->to->ring_count; r++) {
        int low = t->to->first_of_ring[r], high = t->to->first_of_ring[r + 1];
        for (int j = low; j < high; j++) {
            t->before[j] = j > low ? j - 1 : high - 1;
            t->after[j] = j + 1 < high ? j + 1 : low;
        }
    }
}

static void list_open_chords(mt_ring_matcher *t) {
    int open = 0;
    for (int j = 0; j < t->to->count; j++) {
        t->first_open[j] = open;
        for (int b = t->to->first_chord[j]; b < t->to->first_chord[j + 1]; b++) {
            t->source[b] = j;
            const mt_chord *chord = &t->to->chords[b];
            if (chord->cost < INFINITY) t->open[open++] = (mt_open_chord){chord->to, b, (float)chord->cost};
        }
        if (open > t->first_open[j]) t->junctions[t->junction_count++] = j;
    }
    t->first_open[t->to->count] = open;
}

static mt_sample_run run_at(const mt_ring_matcher *t, int first, int end) {
    mt_sample_run made = {first, end, 0, INFINITY, INFINITY, -INFINITY, -INFINITY};
    for (int j = first; j < end; j++) {
        const mt_sample_view *view = &t->to->views[j];
        made.low_x = fmin(made.low_x, view->x);
        made.low_y = fmin(made.low_y, view->y);
        made.high_x = fmax(made.high_x, view->x);
        made.high_y = fmax(made.high_y, view->y);
    }
    return made;
}

static void list_runs(mt_ring_matcher *t) {
    int made = 0, junction = 0;
    for (int r = 0; r < t->to->ring_count; r++) {
        int high = t->to->first_of_ring[r + 1];
        t->first_run[r] = made;
        for (int j = t->to->first_of_ring[r]; j < high; j += RUN_SAMPLES) {
            mt_sample_run *run = &t->runs[made++];
            *run = run_at(t, j, j + RUN_SAMPLES < high ? j + RUN_SAMPLES : high);
            run->junction = junction;
            while (junction < t->junction_count && t->junctions[junction] < run->end) junction++;
        }
    }
    t->first_run[t->to->ring_count] = made;
    t->runs[made].junction = junction;
}

static mt_status make_runs(mt_ring_matcher *t, mt_arena *arena) {
    size_t rings = (size_t)t->to->ring_count, most = (size_t)t->to->count / RUN_SAMPLES + rings + 1;
    t->runs = mt_arena_new(arena, most, sizeof *t->runs);
    t->first_run = mt_arena_new(arena, rings + 1, sizeof *t->first_run);
    t->in_window[0] = mt_arena_new(arena, 2 * most, sizeof(bool));
    if (!t->runs || !t->first_run || !t->in_window[0]) return MT_NO_MEMORY;
    t->in_window[1] = t->in_window[0] + most;
    list_runs(t);
    return MT_OK;
}

static mt_status start_matcher(const mt_boundary *from, int ring, const mt_boundary *to,
                               const mt_cost_weights *weights, mt_arena *arena, mt_ring_matcher *t) {
    *t = (mt_ring_matcher){.from = from,
                           .to = to,
                           .weights = *weights,
                           .first = from->first_of_ring[ring],
                           .window = WINDOW,
                           .arena = arena};
    t->n = from->first_of_ring[ring + 1] - t->first;
    size_t m = (size_t)to->count, cells = ((size_t)t->n + 1) * m, chords = (size_t)to->first_chord[to->count];
    if (cells > MT_ALIGNMENT_MAX) return MT_TOO_LARGE;
    int *numbers = mt_arena_new(arena, 5 * m + 1 + chords, sizeof *numbers);
    t->open = mt_arena_new(arena, chords, sizeof *t->open);
    t->is_pending = mt_arena_new(arena, m, sizeof *t->is_pending);
    t->total[0] = mt_arena_new(arena, 2 * m, sizeof(float));
    t->cost = mt_arena_new(arena, m, sizeof *t->cost);
    t->how = mt_arena_new(arena, cells, sizeof *t->how);
    if (!numbers || !t->open || !t->is_pending || !t->total[0] || !t->cost || !t->how) return MT_NO_MEMORY;
    t->before = numbers;
    t->after = t->before + m;
    t->junctions = t->after + m;
    t->pending = t->junctions + m;
    t->first_open = t->pending + m;
    t->source = t->first_open + m + 1;
    t->total[1] = t->total[0] + m;
    link_neighbours(t);
    list_open_chords(t);
    mt_status status = make_runs(t, arena);
    return status == MT_OK ? mt_columns_of(t->to->views, t->to->count, arena, &t->columns) : status;
}

/* The step of least cost. */
static mt_match_step cheapest(const mt_ring_matcher *t, const mt_match_step *steps, int count) {
    mt_match_step best = steps[0];
    double least = INFINITY;
    for (int k = 0; k < count; k++) {
        double cost =
            mt_step_cost(&t->weights, &t->from->views[steps[k].here], &t->to->views[steps[k].there]);
        if (cost >= least) continue;
        least = cost;
        best = steps[k];
    }
    return best;
}

/* A step to start a closed match with: the cheapest of an open one in longer strides. */
static mt_status find_start(mt_ring_matcher *t, mt_arena *arena, mt_match_step *start) {
    int end = match_around(t, -1, START_STRIDE);
    if (end < 0) return MT_TOO_LARGE;
    int count = read_path(t, end, NULL, 0);
    mt_match_step *steps = mt_arena_new(arena, (size_t)count, sizeof *steps);
    if (!steps) return MT_NO_MEMORY;
    read_path(t, end, steps, count);
    *start = cheapest(t, steps, count);
    return MT_OK;
}

mt_status mt_match_ring(const mt_boundary *from, int ring, const mt_boundary *to,
                        const mt_cost_weights *weights, const mt_match_step *start, mt_arena *arena,
                        mt_ring_match *match) {
    mt_ring_matcher t;
    mt_match_step first = start ? *start : (mt_match_step){0};
    mt_status status = start_matcher(from, ring, to, weights, arena, &t);
    if (status == MT_OK && !start) status = find_start(&t, arena, &first);
    if (status != MT_OK) return status;
    t.start = first.here - t.first;
    if (match_around(&t, first.there, 1) < 0) return MT_TOO_LARGE;
    *match = (mt_ring_match){.count = read_path(&t, first.there, NULL, 0)};
    match->cost = (double)t.total[t.rows % 2][first.there] / match->count;
    match->steps = mt_arena_new(arena, (size_t)match->count, sizeof *match->steps);
    if (!match->steps) return MT_NO_MEMORY;
    read_path(&t, first.there, match->steps, match->count);
    assert(mt_ring_match_is_valid(match));
    return MT_OK;
}

bool mt_ring_match_is_valid(const mt_ring_match *match) {
    bool valid = match->count >= 2 && match->cost >= 0;
    for (int k = 0; valid && k < match->count; k++) {
        mt_match_step step = match->steps[k], last = match->steps[k ? k - 1 : match->count - 1];
        bool same = step.here == last.here && step.there == last.there;
        valid = k ? !same && (step.chord < 0 || step.here == last.here) : same;
    }
    return valid;
}
