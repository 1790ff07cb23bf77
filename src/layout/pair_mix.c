#include "layout/pair_mix.h"

#include <string.h>

#include "layout/intern.h"

const int *mt_mixed_cell(const mt_mixed_pairs *mixed, int row, int column) {
    size_t cell = (size_t)row * (size_t)mixed->column_count + (size_t)column;
    return mixed->cells + cell * (size_t)mixed->part_count;
}

/* ---- values -------------------------------------------------------------------------------------------- */

static int mix(double a, double b, double t) {
    return mt_value_rounded((1 - t) * a + t * b);
}

static const double *cell_of(const mt_pairs *pairs, int end, int row, int column) {
    const mt_pair_matrix *matrix = &pairs->ends[end];
    size_t cell = (size_t)row * (size_t)matrix->columns + (size_t)column;
    return matrix->values + cell * (size_t)pairs->part_count;
}

/* The values of a class of left glyphs with every class of right ones. */
static void fill_row(const mt_pairs *pairs, mt_pair_class left, double t, int32_t *row) {
    int parts = pairs->part_count;
    for (int c = 0; c < pairs->right.count; c++) {
        mt_pair_class right = pairs->right.list[c];
        const double *a = cell_of(pairs, 0, left.a, right.a);
        const double *b = left.b < 0 || right.b < 0 ? a : cell_of(pairs, 1, left.b, right.b);
        for (int k = 0; k < parts; k++) row[c * parts + k] = mix(a[k], b[k], t);
    }
}

/* ---- rows and columns that are equal ------------------------------------------------------------------- */

/* Distinct rows into `rows`, the first of them all 0; `row_of` is the one of each class. */
static mt_status find_rows(const mt_pairs *pairs, double t, mt_arena *scratch, mt_interned *rows,
                           int *row_of) {
    int zero;
    int32_t *row = mt_arena_new(scratch, (size_t)rows->width + 1, sizeof *row);
    mt_status status = row ? mt_intern_filled(rows, 0, &zero) : MT_NO_MEMORY;
    for (int i = 0; i < pairs->left.count && status == MT_OK; i++) {
        fill_row(pairs, pairs->left.list[i], t, row);
        status = mt_intern(rows, row, &row_of[i]);
    }
    return status;
}

/* The same for the columns of the distinct rows. */
static mt_status find_columns(const mt_pairs *pairs, const mt_interned *rows, mt_arena *scratch,
                              mt_interned *columns, int *column_of) {
    int zero, parts = pairs->part_count;
    int32_t *column = mt_arena_new(scratch, (size_t)columns->width + 1, sizeof *column);
    mt_status status = column ? mt_intern_filled(columns, 0, &zero) : MT_NO_MEMORY;
    for (int c = 0; c < pairs->right.count && status == MT_OK; c++) {
        for (int r = 0; r < rows->count; r++)
            for (int k = 0; k < parts; k++) column[r * parts + k] = mt_interned_row(rows, r)[c * parts + k];
        status = mt_intern(columns, column, &column_of[c]);
    }
    return status;
}

static mt_status keep_cells(const mt_interned *columns, int row_count, mt_arena *arena,
                            mt_mixed_pairs *mixed) {
    int parts = mixed->part_count;
    mixed->row_count = row_count;
    mixed->column_count = columns->count;
    size_t count = (size_t)row_count * (size_t)columns->count * (size_t)parts;
    mixed->cells = mt_arena_new(arena, count + 1, sizeof *mixed->cells);
    if (!mixed->cells) return MT_NO_MEMORY;
    int *cell = mixed->cells;
    for (int r = 0; r < row_count; r++)
        for (int c = 0; c < columns->count; c++, cell += parts)
            memcpy(cell, mt_interned_row(columns, c) + r * parts, (size_t)parts * sizeof *cell);
    return MT_OK;
}

static uint16_t *by_glyph(const mt_pair_classes *classes, const int *merged, int glyph_count,
                          mt_arena *arena) {
    uint16_t *of = mt_arena_new(arena, (size_t)glyph_count, sizeof *of);
    for (int i = 0; of && i < glyph_count; i++) of[i] = (uint16_t)merged[classes->of[i]];
    return of;
}

static mt_status merge(const mt_pairs *pairs, double t, mt_interned *rows, mt_interned *columns,
                       mt_arena *scratch, mt_arena *arena, mt_mixed_pairs *mixed) {
    int *row_of = mt_arena_new(scratch, (size_t)pairs->left.count, sizeof *row_of);
    int *column_of = mt_arena_new(scratch, (size_t)pairs->right.count, sizeof *column_of);
    if (!row_of || !column_of) return MT_NO_MEMORY;
    mt_status status = find_rows(pairs, t, scratch, rows, row_of);
    columns->width = rows->count * pairs->part_count;
    if (status == MT_OK) status = find_columns(pairs, rows, scratch, columns, column_of);
    if (status == MT_OK) status = keep_cells(columns, rows->count, arena, mixed);
    if (status != MT_OK) return status;
    mixed->row_of = by_glyph(&pairs->left, row_of, pairs->glyph_count, arena);
    mixed->column_of = by_glyph(&pairs->right, column_of, pairs->glyph_count, arena);
    return mixed->row_of && mixed->column_of ? MT_OK : MT_NO_MEMORY;
}

/* ---- listed pairs -------------------------------------------------------------------------------------- */

static mt_status mix_listed(const mt_pairs *pairs, double t, mt_arena *arena, mt_mixed_pairs *mixed) {
    size_t parts = (size_t)pairs->part_count, all = (size_t)pairs->listed_count;
    mixed->listed = mt_arena_new(arena, all + 1, sizeof *mixed->listed);
    mixed->listed_values = mt_arena_new(arena, (all + 1) * parts + 1, sizeof *mixed->listed_values);
    if (!mixed->listed || !mixed->listed_values) return MT_NO_MEMORY;
    int kept = 0;
    for (size_t i = 0; i < all; i++) {
        mt_listed_pair pair = pairs->listed[i];
        const double *a = pairs->listed_values + 2 * i * parts, *b = a + parts;
        int *value = mixed->listed_values + (size_t)kept * parts;
        for (size_t k = 0; k < parts; k++) value[k] = mix(a[k], b[k], t);
        const int *cell = mt_mixed_cell(mixed, mixed->row_of[pair.left], mixed->column_of[pair.right]);
        if (memcmp(value, cell, parts * sizeof *value) == 0) continue;
        mixed->listed[kept++] = pair;
    }
    mixed->listed_count = kept;
    return MT_OK;
}

mt_status mt_pairs_mix(const mt_pairs *pairs, double t, mt_arena *arena, mt_mixed_pairs *mixed) {
    mt_arena scratch = {0};
    mt_interned rows = {.width = pairs->right.count * pairs->part_count}, columns = {0};
    mt_mixed_pairs made = {
        .glyph_count = pairs->glyph_count, .part_count = pairs->part_count, .parts = pairs->parts};
    mt_status status = merge(pairs, t, &rows, &columns, &scratch, arena, &made);
    if (status == MT_OK) status = mix_listed(pairs, t, arena, &made);
    mt_interned_free(&rows);
    mt_interned_free(&columns);
    mt_arena_release(&scratch);
    if (status == MT_OK) *mixed = made;
    return status;
}
