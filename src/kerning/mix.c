#include "kerning/mix.h"

#include "kerning/divide.h"

#include <string.h>

const int32_t *mt_mixed_cell(const mt_mixed_pairs *mixed, int row, int column) {
    size_t cell = (size_t)row * (size_t)mixed->column_count + (size_t)column;
    return mixed->cells + cell * (size_t)mt_value_row_width(&mixed->values);
}

const int32_t *mt_mixed_listed(const mt_mixed_pairs *mixed, int i) {
    return mixed->listed_values + (size_t)i * (size_t)mt_value_row_width(&mixed->values);
}

/* The pairs and the places that they are mixed for. */
typedef struct mt_pair_mixing {
    const mt_pairs *pairs;
    const mt_at *left, *right; /* where the classes lie; NULL: where the font does */
    const mt_places *places;
    mt_arena scratch;
} mt_pair_mixing;

/* ---- values -------------------------------------------------------------------------------------------- */

/* One font's values for a class of left glyphs and one of right glyphs; the first font's where it has not both. */
static const double *values_in(const mt_pairs *pairs, int font, int left, int right) {
    int row = pairs->left.in_fonts[left * pairs->font_count + font];
    int column = pairs->right.in_fonts[right * pairs->font_count + font];
    if (row < 0 || column < 0) return values_in(pairs, 0, left, right);
    const mt_pair_matrix *matrix = &pairs->fonts[font];
    size_t cell = (size_t)row * (size_t)matrix->columns + (size_t)column;
    return matrix->values + cell * (size_t)pairs->part_count;
}

/* Between which fonts a pair's part is mixed, at the i-th place. */
static mt_between between_of(const mt_pair_mixing *mixing, int left, int right, int part, int i) {
    mt_direction direction = mt_value_direction(mixing->pairs->parts[part]);
    if (!mixing->left) return mt_between_at(mixing->places, i, direction);
    return mt_between_at_pair(mixing->places, mixing->left[left], mixing->right[right], direction);
}

/* The values of a class of left glyphs with every class of right ones. */
static void fill_row(const mt_pair_mixing *mixing, int left, int32_t *row) {
    const mt_pairs *pairs = mixing->pairs;
    int parts = pairs->part_count, places = mixing->places->count;
    for (int c = 0; c < pairs->right.count; c++, row += parts * places)
        for (int i = 0; i < places; i++)
            for (int k = 0; k < parts; k++) {
                mt_between between = between_of(mixing, left, c, k, i);
                double first = values_in(pairs, between.first, left, c)[k],
                       second = values_in(pairs, between.first + 1, left, c)[k];
                row[k * places + i] = mt_value_rounded(mt_between_mix(between, first, second));
            }
}

/* ---- rows and columns that are equal ------------------------------------------------------------------- */

/* Distinct rows into `rows`, the first of them all 0; `row_of` is the one of each class. */
static mt_status find_rows(mt_pair_mixing *mixing, mt_interned *rows, int *row_of) {
    int zero;
    int32_t *row = mt_arena_new(&mixing->scratch, (size_t)rows->width + 1, sizeof *row);
    mt_status status = row ? mt_intern_filled(rows, 0, &zero) : MT_NO_MEMORY;
    for (int i = 0; i < mixing->pairs->left.count && status == MT_OK; i++) {
        fill_row(mixing, i, row);
        status = mt_intern(rows, row, &row_of[i]);
    }
    return status;
}

/* The same for the columns of the distinct rows, which have `width` numbers for each class. */
static mt_status find_columns(mt_pair_mixing *mixing, const mt_interned *rows, int width,
                              mt_interned *columns, int *column_of) {
    int zero;
    int32_t *column = mt_arena_new(&mixing->scratch, (size_t)columns->width + 1, sizeof *column);
    mt_status status = column ? mt_intern_filled(columns, 0, &zero) : MT_NO_MEMORY;
    for (int c = 0; c < mixing->pairs->right.count && status == MT_OK; c++) {
        for (int r = 0; r < rows->count; r++)
            for (int k = 0; k < width; k++) column[r * width + k] = mt_interned_row(rows, r)[c * width + k];
        status = mt_intern(columns, column, &column_of[c]);
    }
    return status;
}

static mt_status keep_cells(const mt_interned *columns, int row_count, mt_arena *arena,
                            mt_mixed_pairs *mixed) {
    int width = mt_value_row_width(&mixed->values);
    mixed->row_count = row_count;
    mixed->column_count = columns->count;
    size_t count = (size_t)row_count * (size_t)columns->count * (size_t)width;
    mixed->cells = mt_arena_new(arena, count + 1, sizeof *mixed->cells);
    if (!mixed->cells) return MT_NO_MEMORY;
    int32_t *cell = mixed->cells;
    for (int r = 0; r < row_count; r++)
        for (int c = 0; c < columns->count; c++, cell += width)
            memcpy(cell, mt_interned_row(columns, c) + r * width, (size_t)width * sizeof *cell);
    return MT_OK;
}

static uint16_t *by_glyph(const mt_pair_classes *classes, const int *merged, int glyph_count,
                          mt_arena *arena) {
    uint16_t *of = mt_arena_new(arena, (size_t)glyph_count, sizeof *of);
    for (int i = 0; of && i < glyph_count; i++) of[i] = (uint16_t)merged[classes->of[i]];
    return of;
}

static mt_status merge(mt_pair_mixing *mixing, mt_interned *rows, mt_interned *columns, mt_arena *arena,
                       mt_mixed_pairs *mixed) {
    const mt_pairs *pairs = mixing->pairs;
    int width = mt_value_row_width(&mixed->values);
    int *row_of = mt_arena_new(&mixing->scratch, (size_t)pairs->left.count, sizeof *row_of);
    int *column_of = mt_arena_new(&mixing->scratch, (size_t)pairs->right.count, sizeof *column_of);
    if (!row_of || !column_of) return MT_NO_MEMORY;
    mt_status status = find_rows(mixing, rows, row_of);
    columns->width = rows->count * width;
    if (status == MT_OK) status = find_columns(mixing, rows, width, columns, column_of);
    if (status == MT_OK) status = keep_cells(columns, rows->count, arena, mixed);
    if (status != MT_OK) return status;
    mixed->row_of = by_glyph(&pairs->left, row_of, pairs->glyph_count, arena);
    mixed->column_of = by_glyph(&pairs->right, column_of, pairs->glyph_count, arena);
    return mixed->row_of && mixed->column_of ? MT_OK : MT_NO_MEMORY;
}

/* ---- listed pairs -------------------------------------------------------------------------------------- */

static void mix_listed_pair(const mt_pair_mixing *mixing, size_t i, int32_t *value) {
    int places = mixing->places->count, parts = mixing->pairs->part_count;
    size_t step = (size_t)mixing->pairs->font_count * (size_t)parts;
    mt_listed_pair pair = mixing->pairs->listed[i];
    int left = mixing->pairs->left.of[pair.left], right = mixing->pairs->right.of[pair.right];
    const double *in_fonts = mixing->pairs->listed_values + i * step;
    for (int k = 0; k < parts; k++)
        for (int p = 0; p < places; p++) {
            mt_between between = between_of(mixing, left, right, k, p);
            const double *first = in_fonts + between.first * parts;
            value[k * places + p] = mt_value_rounded(mt_between_mix(between, first[k], first[parts + k]));
        }
}

static mt_status mix_listed(const mt_pair_mixing *mixing, mt_arena *arena, mt_mixed_pairs *mixed) {
    size_t width = (size_t)mt_value_row_width(&mixed->values), all = (size_t)mixing->pairs->listed_count;
    mixed->listed = mt_arena_new(arena, all + 1, sizeof *mixed->listed);
    mixed->listed_values = mt_arena_new(arena, (all + 1) * width + 1, sizeof *mixed->listed_values);
    if (!mixed->listed || !mixed->listed_values) return MT_NO_MEMORY;
    int kept = 0;
    for (size_t i = 0; i < all; i++) {
        mt_listed_pair pair = mixing->pairs->listed[i];
        int32_t *value = mixed->listed_values + (size_t)kept * width;
        mix_listed_pair(mixing, i, value);
        const int32_t *cell = mt_mixed_cell(mixed, mixed->row_of[pair.left], mixed->column_of[pair.right]);
        if (memcmp(value, cell, width * sizeof *value) == 0) continue;
        mixed->listed[kept++] = pair;
    }
    mixed->listed_count = kept;
    return MT_OK;
}

mt_status mt_pairs_mix(const mt_pairs *pairs, const mt_places *places, mt_arena *arena,
                       mt_mixed_pairs *mixed) {
    mt_divided_pairs divided;
    mt_pair_mixing mixing = {.pairs = &divided.pairs, .places = places};
    mt_mixed_pairs made = {.glyph_count = pairs->glyph_count,
                           .values = {pairs->part_count, places->count, pairs->parts}};
    mt_interned rows = {0}, columns = {0};
    mt_status status = mt_pairs_divide(pairs, places, &mixing.scratch, &divided);
    if (status == MT_OK) {
        mixing.left = divided.left, mixing.right = divided.right;
        rows.width = divided.pairs.right.count * mt_value_row_width(&made.values);
        status = merge(&mixing, &rows, &columns, arena, &made);
    }
    if (status == MT_OK) status = mix_listed(&mixing, arena, &made);
    mt_interned_free(&rows);
    mt_interned_free(&columns);
    mt_arena_release(&mixing.scratch);
    if (status == MT_OK) *mixed = made;
    return status;
}
