/* PairPosFormat2 (OpenType spec, "Pair adjustment positioning subtable format 2"). */
#include <string.h>

#include "kerning/write_matrix.h"

/* Some rows of the matrix, as one subtable: classes 0, 1, … of left glyphs are rows first, first + 1, … */
typedef struct mt_matrix_part {
    int first, end;
    mt_interned columns; /* distinct ones of these rows; the first is all 0 */
    int *column_of;      /* of each column of the matrix */
    mt_value_format format;
    mt_variation_pool pool; /* of what varies */
    mt_table records;
} mt_matrix_part;

static mt_status merge_columns(const mt_mixed_pairs *mixed, mt_matrix_part *part, mt_arena *scratch) {
    int width = mt_value_row_width(&mixed->values), zero;
    part->columns.width = (part->end - part->first) * width;
    part->column_of = mt_arena_new(scratch, (size_t)mixed->column_count, sizeof *part->column_of);
    int32_t *column = mt_arena_new(scratch, (size_t)part->columns.width, sizeof *column);
    if (!part->column_of || !column) return MT_NO_MEMORY;
    mt_status status = mt_intern_filled(&part->columns, 0, &zero);
    for (int c = 0; c < mixed->column_count && status == MT_OK; c++) {
        for (int r = part->first; r < part->end; r++)
            memcpy(column + (r - part->first) * width, mt_mixed_cell(mixed, r, c),
                   (size_t)width * sizeof *column);
        status = mt_intern(&part->columns, column, &part->column_of[c]);
        part->format = mt_value_format_join(
            part->format, mt_value_format_of(&mixed->values, column, part->end - part->first));
    }
    return status;
}

enum { HEADER = 16 };

/* The values of all pairs of classes, and what varies in them. MT_TOO_LARGE where that could not be reached. */
static mt_status write_records(const mt_mixed_pairs *mixed, mt_matrix_part *part) {
    size_t rows = (size_t)(part->end - part->first), columns = (size_t)part->columns.count;
    size_t to_pool = HEADER + rows * columns * mt_value_format_size(part->format);
    int width = mt_value_row_width(&mixed->values);
    if (to_pool > MT_OFFSET_MAX) return MT_TOO_LARGE;
    for (int r = 0; r < part->end - part->first; r++)
        for (int c = 0; c < part->columns.count; c++)
            mt_value_write(&part->records, &mixed->values, part->format,
                           mt_interned_row(&part->columns, c) + r * width, &part->pool, to_pool);
    mt_variation_pool_write(&part->pool, &part->records);
    return part->pool.status;
}

/* Coverage and ClassDef of the left glyphs, ClassDef of the right ones. */
static mt_status write_glyphs(const mt_mixed_pairs *mixed, const mt_matrix_part *part, mt_arena *scratch,
                              mt_table tables[3]) {
    size_t room = (size_t)mixed->glyph_count;
    uint16_t *covered = mt_arena_new(scratch, room, sizeof *covered);
    mt_glyph_class *left = mt_arena_new(scratch, room, sizeof *left);
    mt_glyph_class *right = mt_arena_new(scratch, room, sizeof *right);
    if (!covered || !left || !right) return MT_NO_MEMORY;
    int left_count = 0, right_count = 0;
    for (int i = 0; i < mixed->glyph_count; i++) {
        int row = mixed->row_of[i], column = part->column_of[mixed->column_of[i]];
        if (column) right[right_count++] = (mt_glyph_class){(uint16_t)i, (uint16_t)column};
        if (row < part->first || row >= part->end) continue;
        covered[left_count] = (uint16_t)i;
        left[left_count++] = (mt_glyph_class){(uint16_t)i, (uint16_t)(row - part->first)};
    }
    mt_table_coverage(&tables[0], covered, left_count);
    mt_table_classes(&tables[1], left, left_count);
    mt_table_classes(&tables[2], right, right_count);
    return MT_OK;
}

/* Puts the subtable together; the longest of the three tables comes last, so that its offset is the smallest that can
 * be. MT_TOO_LARGE where an offset does not reach. */
static mt_status assemble(const mt_matrix_part *part, const mt_table tables[3], mt_table *table) {
    size_t at = HEADER + part->records.length, offsets[3];
    int last = 2;
    for (int i = 0; i < 2; i++)
        if (tables[i].length > tables[last].length) last = i;
    for (int i = 0; i < 3; i++) {
        if (i == last) continue;
        offsets[i] = at;
        at += tables[i].length;
    }
    offsets[last] = at;
    if (at > MT_OFFSET_MAX) return MT_TOO_LARGE;
    mt_pair_write_header(table, 2, offsets[0], part->format);
    mt_table_16(table, (int)offsets[1]);
    mt_table_16(table, (int)offsets[2]);
    mt_table_16(table, part->end - part->first);
    mt_table_16(table, part->columns.count);
    mt_table_bytes(table, part->records.bytes, part->records.length);
    table->failed |= part->records.failed;
    for (int i = 0; i < 3; i++)
        if (i != last) mt_table_bytes(table, tables[i].bytes, tables[i].length);
    mt_table_bytes(table, tables[last].bytes, tables[last].length);
    for (int i = 0; i < 3; i++) table->failed |= tables[i].failed;
    return MT_OK;
}

static mt_status write_part(mt_pair_writer *writer, mt_matrix_part *part, mt_arena *scratch) {
    mt_table tables[3] = {0}, table = {0};
    mt_status status = merge_columns(writer->mixed, part, scratch);
    if (status == MT_OK) status = write_records(writer->mixed, part);
    if (status == MT_OK) status = write_glyphs(writer->mixed, part, scratch, tables);
    if (status == MT_OK) status = assemble(part, tables, &table);
    if (status == MT_OK) status = mt_subtables_add(&table, writer->arena, &writer->subtables);
    for (int i = 0; i < 3; i++) mt_table_free(&tables[i]);
    mt_table_free(&table);
    return status;
}

/* Rows first … end, in halves where they are too many for one subtable. */
static mt_status write_rows(mt_pair_writer *writer, int first, int end, mt_arena *scratch) {
    mt_matrix_part part = {.first = first, .end = end, .pool = mt_variation_pool_make(writer->store)};
    mt_arena_place place = mt_arena_mark(scratch);
    mt_status status = write_part(writer, &part, scratch);
    mt_interned_free(&part.columns);
    mt_variation_pool_free(&part.pool);
    mt_table_free(&part.records);
    mt_arena_rewind(scratch, place);
    if (status != MT_TOO_LARGE || end - first == 1) return status;
    int middle = first + (end - first) / 2;
    status = write_rows(writer, first, middle, scratch);
    return status == MT_OK ? write_rows(writer, middle, end, scratch) : status;
}

mt_status mt_pair_write_matrix(mt_pair_writer *writer) {
    mt_arena scratch = {0};
    int rows = writer->mixed->row_count; /* row 0 has nothing */
    mt_status status = rows > 1 ? write_rows(writer, 1, rows, &scratch) : MT_OK;
    mt_arena_release(&scratch);
    return status;
}
