/* Single and pair positions of GPOS. What an earlier subtable takes hides a later one's, which is left out. */
#include "fea/writer.h"
#include "geometry/limits.h"
#include "layout/value.h"

/* In full, or the advance alone. */
static void put_value(mt_fea_writer *writer, const double values[MT_VALUE_PARTS]) {
    int whole[MT_VALUE_PARTS];
    for (int i = 0; i < MT_VALUE_PARTS; i++) whole[i] = mt_value_rounded(values[i]);
    if (whole[0] == 0 && whole[1] == 0 && whole[3] == 0)
        mt_fea_print(writer, &writer->lookups, "%d", whole[MT_VALUE_X_ADVANCE]);
    else
        mt_fea_print(writer, &writer->lookups, "<%d %d %d %d>", whole[0], whole[1], whole[2], whole[3]);
}

/* The value record at a place of the table. */
static void put_value_at(mt_fea_writer *writer, mt_bytes table, size_t at, unsigned format) {
    double values[MT_VALUE_PARTS];
    mt_value_read(table, at, format, &writer->deltas, values);
    put_value(writer, values);
}

/* ---- single -------------------------------------------------------------------------------------------- */

static mt_bytes single_coverage(mt_bytes table) {
    unsigned format = mt_ot_u16(table, 0);
    return format == 1 || format == 2 ? mt_ot_follow(table, 2) : (mt_bytes){0};
}

static void put_single(mt_fea_writer *writer, mt_bytes table, mt_covered covered) {
    unsigned format = mt_ot_u16(table, 0), value = mt_ot_u16(table, 4);
    mt_fea_put(writer, &writer->lookups, "  pos ");
    mt_fea_glyph(writer, &writer->lookups, covered.glyph);
    mt_fea_put(writer, &writer->lookups, " ");
    size_t at = format == 1 ? 6 : 8 + mt_value_size(value) * covered.index;
    put_value_at(writer, table, at, value);
    mt_fea_put(writer, &writer->lookups, ";\n");
}

void mt_fea_singles(mt_fea_writer *writer, const mt_lookup *lookup) {
    mt_fea_each_glyph(writer, lookup, single_coverage, put_single);
}

/* ---- pairs --------------------------------------------------------------------------------------------- */

/* A subtable of pairs: `formats` of both records. */
typedef struct mt_pair_table {
    mt_bytes table;
    unsigned formats[2];
    size_t sizes[2];
} mt_pair_table;

/* One after the other, as the text has them where both are values. */
static void put_pair(mt_fea_writer *writer, const uint16_t *left, int left_count, const uint16_t *right,
                     int right_count, const mt_pair_table *pairs, mt_bytes parent, size_t at) {
    mt_buffer *to = &writer->lookups;
    bool both = pairs->formats[1] != 0;
    mt_fea_put(writer, to, "  pos ");
    mt_fea_class(writer, to, left, left_count);
    if (both) mt_fea_put(writer, to, " ");
    if (both) put_value_at(writer, parent, at, pairs->formats[0]);
    mt_fea_put(writer, to, " ");
    mt_fea_class(writer, to, right, right_count);
    mt_fea_put(writer, to, " ");
    put_value_at(writer, parent, both ? at + pairs->sizes[0] : at, pairs->formats[both]);
    mt_fea_put(writer, to, ";\n");
}

static void put_glyph_pairs(mt_fea_writer *writer, const mt_pair_table *pairs, const bool *taken,
                            mt_interned *told) {
    mt_covered *covered;
    int count;
    size_t step = 2 + pairs->sizes[0] + pairs->sizes[1];
    writer->status = mt_coverage_list(mt_ot_follow(pairs->table, 2), writer->arena, &covered, &count);
    for (int i = 0; i < count && writer->status == MT_OK; i++) {
        uint16_t left = covered[i].glyph;
        if (taken[left] || covered[i].index >= mt_ot_u16(pairs->table, 8)) continue;
        mt_bytes set = mt_ot_follow(pairs->table, 10 + 2 * (size_t)covered[i].index);
        int all = mt_ot_fit(set, 2, mt_ot_u16(set, 0), step);
        for (int k = 0; k < all && writer->status == MT_OK && mt_fea_spend(writer, 1); k++) {
            size_t at = 2 + step * (size_t)k;
            uint16_t right = (uint16_t)mt_ot_u16(set, at);
            int before = told->count, number;
            writer->status = mt_intern(told, (const int32_t[]){left, right}, &number);
            if (number == before && right < writer->source->glyph_count)
                put_pair(writer, &left, 1, &right, 1, pairs, set, at + 2);
        }
    }
}

/* Neither a value nor a way for it to vary. */
static bool is_nothing(const mt_pair_table *pairs, size_t at) {
    for (size_t i = 0; i < pairs->sizes[0] + pairs->sizes[1]; i += 2)
        if (mt_ot_u16(pairs->table, at + i)) return false;
    return true;
}

/* A row of classes: what it does nothing with is left out but one, by which it stays a row. */
static void put_row(mt_fea_writer *writer, const mt_pair_table *pairs, const uint16_t *left, int left_count,
                    uint16_t *const *columns, const int *counts, size_t row) {
    int column_count = (int)mt_ot_u16(pairs->table, 14);
    size_t size = pairs->sizes[0] + pairs->sizes[1];
    bool any = false;
    for (int c = column_count - 1; c >= 0 && writer->status == MT_OK; c--) {
        size_t at = 16 + size * (row * (size_t)column_count + (size_t)c);
        bool last = c == 0 && !any;
        if (counts[c] == 0 || !mt_fea_spend(writer, 1)) continue;
        if (is_nothing(pairs, at) && !last) continue;
        put_pair(writer, left, left_count, columns[c], counts[c], pairs, pairs->table, at);
        any = true;
    }
}

static bool list_columns(mt_fea_writer *writer, const mt_pair_table *pairs, uint16_t ***columns,
                         int **counts) {
    int count = (int)mt_ot_u16(pairs->table, 14);
    *columns = mt_fea_new(writer, (size_t)count, sizeof **columns);
    *counts = mt_fea_new(writer, (size_t)count, sizeof **counts);
    bool listed = *columns && *counts;
    for (int c = 0; c < count && listed; c++)
        listed = mt_fea_class_list(writer, mt_ot_follow(pairs->table, 10), (unsigned)c, &(*columns)[c],
                                   &(*counts)[c]);
    return listed;
}

/* The glyphs of the coverage in one class that no earlier subtable has taken. */
static int pick_row(const uint16_t *covered, int count, mt_bytes classes, unsigned row, const bool *taken,
                    uint16_t *picked) {
    int found = 0;
    for (int i = 0; i < count; i++)
        if (!taken[covered[i]] && mt_class_find(classes, covered[i]) == row) picked[found++] = covered[i];
    return found;
}

static void put_class_pairs(mt_fea_writer *writer, const mt_pair_table *pairs, bool *taken, bool again) {
    uint16_t **columns, *covered, *picked;
    int *counts, count;
    unsigned rows = mt_ot_u16(pairs->table, 12);
    if (!mt_fea_coverage_list(writer, mt_ot_follow(pairs->table, 2), &covered, &count)) return;
    picked = mt_fea_new(writer, (size_t)count, sizeof *picked);
    if (!picked || !list_columns(writer, pairs, &columns, &counts)) return;
    if (again) mt_fea_put(writer, &writer->lookups, "  subtable;\n");
    for (unsigned r = 0; r < rows && mt_fea_spend(writer, count + 1); r++) {
        int found = pick_row(covered, count, mt_ot_follow(pairs->table, 8), r, taken, picked);
        if (found) put_row(writer, pairs, picked, found, columns, counts, r);
    }
    for (int i = 0; i < count; i++) taken[covered[i]] = true;
}

void mt_fea_pairs(mt_fea_writer *writer, const mt_lookup *lookup) {
    bool *taken = mt_fea_new(writer, MT_GLYPHS_MAX + 1, sizeof *taken), again = false;
    mt_interned told = {.width = 2};
    for (int i = 0; i < lookup->subtable_count && taken && writer->status == MT_OK; i++) {
        mt_pair_table pairs = {.table = mt_lookup_subtable(lookup, i)};
        for (int k = 0; k < 2; k++) {
            pairs.formats[k] = mt_ot_u16(pairs.table, 4 + 2 * (size_t)k);
            pairs.sizes[k] = mt_value_size(pairs.formats[k]);
        }
        unsigned format = mt_ot_u16(pairs.table, 0);
        if (format == 1) put_glyph_pairs(writer, &pairs, taken, &told);
        if (format != 2) continue;
        put_class_pairs(writer, &pairs, taken, again);
        again = true;
    }
    mt_interned_free(&told);
}
