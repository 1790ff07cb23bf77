/* The assignment of least cost, by shortest augmenting paths (H. W. Kuhn, "The Hungarian method for the assignment problem", 1955;
 * J. Munkres, 1957). Rows are those of the fewer; each is added in turn, along the cheapest path to a free column:
 *
 *     row 3 ──→ column 1 (taken by row 0) ──→ column 2 (free)     row 3 gets column 1, row 0 moves to column 2
 *
 * Potentials of rows and columns keep all reduced costs at 0 or more, and those of assigned pairs at 0, so that Dijkstra's search
 * finds the path. Ties go to the lower column. O(n² m) for n rows and m columns. */
#include "morph/align/assign.h"

#include <math.h>

typedef struct mt_assignment {
    const double *costs;
    int row_step, column_step; /* strides in `costs`, swapped where the caller has more rows than columns */
    int rows, columns;
    double *row_cost, *column_cost; /* potentials */
    int *row_of;                    /* each column's row; -1: free */
    double *distance_to;            /* cost of the cheapest path from the added row to each column … */
    int *previous;                  /* … and the column before it on that path; -1: none */
    bool *done;
} mt_assignment;

static double reduced(const mt_assignment *a, int row, int column) {
    return a->costs[row * a->row_step + column * a->column_step] - a->row_cost[row] - a->column_cost[column];
}

/* Relaxes the paths over a row that column `last` reaches at `distance`. */
static void relax_row(mt_assignment *a, int row, double distance, int last) {
    for (int c = 0; c < a->columns; c++) {
        double by = distance + reduced(a, row, c);
        if (a->done[c] || by >= a->distance_to[c]) continue;
        a->distance_to[c] = by;
        a->previous[c] = last;
    }
}

static int nearest_column(const mt_assignment *a) {
    int best = -1;
    for (int c = 0; c < a->columns; c++)
        if (!a->done[c] && (best < 0 || a->distance_to[c] < a->distance_to[best])) best = c;
    return best;
}

/* Raises the potentials after a search of length `distance`, so that reduced costs along its paths are 0. */
static void update_potentials(mt_assignment *a, int row, double distance) {
    a->row_cost[row] += distance;
    for (int c = 0; c < a->columns; c++) {
        if (!a->done[c]) continue;
        a->row_cost[a->row_of[c]] += distance - a->distance_to[c];
        a->column_cost[c] -= distance - a->distance_to[c];
    }
}

static void add_row(mt_assignment *a, int row) {
    for (int c = 0; c < a->columns; c++) {
        a->distance_to[c] = INFINITY;
        a->done[c] = false;
    }
    relax_row(a, row, 0, -1);
    int c = nearest_column(a);
    while (a->row_of[c] >= 0) {
        a->done[c] = true;
        relax_row(a, a->row_of[c], a->distance_to[c], c);
        c = nearest_column(a);
    }
    update_potentials(a, row, a->distance_to[c]);
    for (; a->previous[c] >= 0; c = a->previous[c]) a->row_of[c] = a->row_of[a->previous[c]];
    a->row_of[c] = row;
}

static mt_status start(mt_assignment *a, mt_arena *arena) {
    size_t rows = (size_t)a->rows, columns = (size_t)a->columns;
    a->row_cost = mt_arena_new(arena, rows, sizeof *a->row_cost);
    a->column_cost = mt_arena_new(arena, columns, sizeof *a->column_cost);
    a->distance_to = mt_arena_new(arena, columns, sizeof *a->distance_to);
    a->row_of = mt_arena_new(arena, columns, sizeof *a->row_of);
    a->previous = mt_arena_new(arena, columns, sizeof *a->previous);
    a->done = mt_arena_new(arena, columns, sizeof *a->done);
    if (!a->row_cost || !a->column_cost || !a->distance_to || !a->row_of || !a->previous || !a->done)
        return MT_NO_MEMORY;
    for (int c = 0; c < a->columns; c++) a->row_of[c] = -1;
    return MT_OK;
}

mt_status mt_assign(const double *costs, int rows, int columns, mt_arena *arena, int *column_of) {
    bool turned = rows > columns;
    mt_assignment a = {.costs = costs,
                       .row_step = turned ? 1 : columns,
                       .column_step = turned ? columns : 1,
                       .rows = turned ? columns : rows,
                       .columns = turned ? rows : columns};
    mt_status status = start(&a, arena);
    if (status != MT_OK) return status;
    for (int r = 0; r < a.rows; r++) add_row(&a, r);
    for (int r = 0; r < rows; r++) column_of[r] = -1;
    for (int c = 0; c < a.columns; c++) {
        if (a.row_of[c] < 0) continue;
        column_of[turned ? c : a.row_of[c]] = turned ? a.row_of[c] : c;
    }
    return MT_OK;
}
