/* Each row of the fewer is added in turn: along the cheapest path of columns that are taken, each of which its row gives up for the
 * next one, to a column that is free. Potentials of rows and columns keep all reduced costs at 0 or more, and those of the
 * assignment at 0, so that the path is found as by Dijkstra. */
#include "morph/align/assign.h"

#include <math.h>

typedef struct mt_assignment {
    const double *costs;
    int row_step, column_step; /* in `costs`: the fewer are the rows, whichever they were */
    int rows, columns;
    double *row_cost, *column_cost; /* potentials */
    int *row_of;                    /* each column's row; -1: free */
    double *reach;                  /* how far each column is from the row at hand … */
    int *from;                      /* … and the column before it on the way; -1: none */
    bool *done;
} mt_assignment;

static double reduced(const mt_assignment *a, int row, int column) {
    return a->costs[row * a->row_step + column * a->column_step] - a->row_cost[row] - a->column_cost[column];
}

/* Goes on from a row that is reached at `distance` over column `last`. */
static void look_on(mt_assignment *a, int row, double distance, int last) {
    for (int c = 0; c < a->columns; c++) {
        double by = distance + reduced(a, row, c);
        if (a->done[c] || by >= a->reach[c]) continue;
        a->reach[c] = by;
        a->from[c] = last;
    }
}

static int nearest_open(const mt_assignment *a) {
    int best = -1;
    for (int c = 0; c < a->columns; c++)
        if (!a->done[c] && (best < 0 || a->reach[c] < a->reach[best])) best = c;
    return best;
}

/* After a search that ended `distance` away: what is nearer than that comes to lie at 0. */
static void settle_costs(mt_assignment *a, int row, double distance) {
    a->row_cost[row] += distance;
    for (int c = 0; c < a->columns; c++) {
        if (!a->done[c]) continue;
        a->row_cost[a->row_of[c]] += distance - a->reach[c];
        a->column_cost[c] -= distance - a->reach[c];
    }
}

static void add_row(mt_assignment *a, int row) {
    for (int c = 0; c < a->columns; c++) {
        a->reach[c] = INFINITY;
        a->done[c] = false;
    }
    look_on(a, row, 0, -1);
    int c = nearest_open(a);
    while (a->row_of[c] >= 0) {
        a->done[c] = true;
        look_on(a, a->row_of[c], a->reach[c], c);
        c = nearest_open(a);
    }
    settle_costs(a, row, a->reach[c]);
    for (; a->from[c] >= 0; c = a->from[c]) a->row_of[c] = a->row_of[a->from[c]];
    a->row_of[c] = row;
}

static mt_status start(mt_assignment *a, mt_arena *arena) {
    size_t rows = (size_t)a->rows, columns = (size_t)a->columns;
    a->row_cost = mt_arena_new(arena, rows, sizeof *a->row_cost);
    a->column_cost = mt_arena_new(arena, columns, sizeof *a->column_cost);
    a->reach = mt_arena_new(arena, columns, sizeof *a->reach);
    a->row_of = mt_arena_new(arena, columns, sizeof *a->row_of);
    a->from = mt_arena_new(arena, columns, sizeof *a->from);
    a->done = mt_arena_new(arena, columns, sizeof *a->done);
    if (!a->row_cost || !a->column_cost || !a->reach || !a->row_of || !a->from || !a->done)
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
