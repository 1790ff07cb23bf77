/* Section 2.2.1, formulas (1) and (2): relaxation matching of components on a matrix of similarities.
 *
 *     s'(i, j) = s(i, j) · Σ_{h≠i} max_{r≠j} s(h, r) / (K − 1)     a match gains support where the other rows have good
 *                                                                  matches in the other columns
 *
 * The largest entry of each row and the largest of its other entries give all maxima of a round at once. Each round is scaled to a largest
 * entry of 1. Invariant: every row and every column keeps at least one match. O(rounds · K · L), and O(K · L · (K + L)) for the matches. */
#include "morph/paper/relax.h"

#include <math.h>

/* Where row i, column j stands in a matrix of so many columns. */
static size_t cell(int columns, int i, int j) {
    return (size_t)i * (size_t)columns + (size_t)j;
}

/* The two largest of a row, so that "the largest but at column j" costs nothing more. */
typedef struct mt_top {
    double first, second;
    int column; /* of the first */
} mt_top;

static mt_top top_of(const double *row, int columns) {
    mt_top top = {row[0], -1, 0};
    for (int j = 1; j < columns; j++) {
        if (row[j] > top.first)
            top = (mt_top){row[j], top.first, j};
        else if (row[j] > top.second)
            top.second = row[j];
    }
    return top;
}

static double largest_but(mt_top top, int j, int columns) {
    return columns > 1 && top.column == j ? top.second : top.first;
}

static void scale_to_one(double *s, size_t count) {
    double largest = 0;
    for (size_t i = 0; i < count; i++) largest = fmax(largest, s[i]);
    for (size_t i = 0; i < count && largest > 0; i++) s[i] /= largest;
}

/* One round. `support` has room for a number a column, `tops` for one a row. */
static void relax_once(double *s, int rows, int columns, mt_top *tops, double *support) {
    for (int j = 0; j < columns; j++) support[j] = 0;
    for (int h = 0; h < rows; h++) {
        tops[h] = top_of(s + cell(columns, h, 0), columns);
        for (int j = 0; j < columns; j++) support[j] += largest_but(tops[h], j, columns);
    }
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++)
            s[cell(columns, i, j)] *= (support[j] - largest_but(tops[i], j, columns)) / (rows - 1);
}

mt_status mt_relax(double *s, int rows, int columns, int rounds, mt_arena *arena) {
    mt_top *tops = mt_arena_new(arena, (size_t)rows, sizeof *tops);
    double *support = mt_arena_new(arena, (size_t)columns, sizeof *support);
    if (!tops || !support) return MT_NO_MEMORY;
    scale_to_one(s, cell(columns, rows, 0));
    for (int round = 0; round < rounds && rows > 1; round++) {
        relax_once(s, rows, columns, tops, support);
        scale_to_one(s, cell(columns, rows, 0));
    }
    return MT_OK;
}

/* ---- matches ------------------------------------------------------------------------------------------- */

typedef struct mt_matrix {
    int rows, columns;
    double *forth, *back; /* rows × columns, and its transpose */
    bool *matched;        /* rows × columns */
} mt_matrix;

static int best_of(const double *row, int count) {
    int best = 0;
    for (int j = 1; j < count; j++)
        if (row[j] > row[best]) best = j;
    return best;
}

static mt_status relax_both_ways(const double *s, int rounds, mt_arena *arena, mt_matrix *t) {
    size_t all = cell(t->columns, t->rows, 0);
    t->forth = mt_arena_new(arena, all, sizeof(double));
    t->back = mt_arena_new(arena, all, sizeof(double));
    t->matched = mt_arena_new(arena, all, sizeof(bool));
    if (!t->forth || !t->back || !t->matched) return MT_NO_MEMORY;
    for (int i = 0; i < t->rows; i++)
        for (int j = 0; j < t->columns; j++)
            t->forth[cell(t->columns, i, j)] = t->back[cell(t->rows, j, i)] = s[cell(t->columns, i, j)];
    mt_status status = mt_relax(t->forth, t->rows, t->columns, rounds, arena);
    return status == MT_OK ? mt_relax(t->back, t->columns, t->rows, rounds, arena) : status;
}

static bool has_other(const mt_matrix *t, int row, int column) {
    bool in_row = false, in_column = false;
    for (int j = 0; j < t->columns; j++) in_row |= j != column && t->matched[cell(t->columns, row, j)];
    for (int i = 0; i < t->rows; i++) in_column |= i != row && t->matched[cell(t->columns, i, column)];
    return in_row && in_column;
}

static void drop_weak(mt_matrix *t, double threshold) {
    for (int i = 0; i < t->rows; i++)
        for (int j = 0; j < t->columns; j++) {
            bool weak =
                t->forth[cell(t->columns, i, j)] < threshold || t->back[cell(t->rows, j, i)] < threshold;
            if (t->matched[cell(t->columns, i, j)] && weak && has_other(t, i, j))
                t->matched[cell(t->columns, i, j)] = false;
        }
}

mt_status mt_match_components(const double *s, int rows, int columns, int rounds, double threshold,
                              mt_arena *arena, mt_links *matches) {
    mt_matrix t = {.rows = rows, .columns = columns};
    mt_status status = relax_both_ways(s, rounds, arena, &t);
    mt_links made = {0, mt_arena_new(arena, (size_t)rows + (size_t)columns, sizeof(mt_link))};
    if (status != MT_OK) return status;
    if (!made.links) return MT_NO_MEMORY;
    for (int i = 0; i < rows; i++)
        t.matched[cell(columns, i, best_of(t.forth + cell(columns, i, 0), columns))] = true;
    for (int j = 0; j < columns; j++)
        t.matched[cell(columns, best_of(t.back + cell(rows, j, 0), rows), j)] = true;
    drop_weak(&t, threshold);
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++)
            if (t.matched[cell(columns, i, j)]) made.links[made.count++] = (mt_link){i, j};
    *matches = made;
    return MT_OK;
}
