/* Variation sequences: 'cmap' format 14 (OpenType spec, "Format 14: Unicode variation sequences"). */
#include "write/tables.h"

enum { HEADER = 10, RECORD = 11, RANGE = 4, MAPPING = 5, RANGE_MAX = 256 };

static int selector_end(const mt_font_data *data, int start) {
    int end = start + 1;
    while (end < data->variant_count && data->variants[end].selector == data->variants[start].selector) end++;
    return end;
}

/* The next of one kind from `i` on; `end` when there is none. */
static int next_of(const mt_font_data *data, int i, int end, bool by_default) {
    while (i < end && data->variants[i].by_default != by_default) i++;
    return i;
}

/* The end of a run of characters that follow one another and keep their own glyphs. */
static int range_end(const mt_font_data *data, int start, int end) {
    int i = start + 1;
    while (i < end && i - start < RANGE_MAX && data->variants[i].by_default &&
           data->variants[i].code_point == data->variants[i - 1].code_point + 1)
        i++;
    return i;
}

static void write_u24(mt_table *table, uint32_t value) {
    mt_table_u8(table, value >> 16);
    mt_table_16(table, (int)(value & 0xFFFF));
}

/* The runs of characters of one selector that keep their own glyphs; counts them only where `table` is NULL. */
static int write_ranges(const mt_font_data *data, int start, int end, mt_table *table) {
    int count = 0;
    for (int i = next_of(data, start, end, true), last; i < end;
         i = next_of(data, last, end, true), count++) {
        last = range_end(data, i, end);
        if (!table) continue;
        write_u24(table, data->variants[i].code_point);
        mt_table_u8(table, (unsigned)(last - i - 1));
    }
    return count;
}

static int write_mappings(const mt_font_data *data, int start, int end, mt_table *table) {
    int count = 0;
    for (int i = next_of(data, start, end, false); i < end; i = next_of(data, i + 1, end, false), count++) {
        if (!table) continue;
        write_u24(table, data->variants[i].code_point);
        mt_table_16(table, data->variants[i].glyph);
    }
    return count;
}

/* A selector's record; moves *at past its lists. A list of none has the offset 0. */
static void write_record(const mt_font_data *data, int start, int end, uint32_t *at, mt_table *table) {
    uint32_t ranges = (uint32_t)write_ranges(data, start, end, NULL);
    uint32_t mappings = (uint32_t)write_mappings(data, start, end, NULL);
    write_u24(table, data->variants[start].selector);
    mt_table_32(table, ranges ? *at : 0);
    if (ranges) *at += 4 + RANGE * ranges;
    mt_table_32(table, mappings ? *at : 0);
    if (mappings) *at += 4 + MAPPING * mappings;
}

static void write_lists(const mt_font_data *data, int start, int end, mt_table *table) {
    int ranges = write_ranges(data, start, end, NULL), mappings = write_mappings(data, start, end, NULL);
    if (ranges) mt_table_32(table, (uint32_t)ranges);
    write_ranges(data, start, end, table);
    if (mappings) mt_table_32(table, (uint32_t)mappings);
    write_mappings(data, start, end, table);
}

void mt_write_variation_sequences(const mt_font_data *data, mt_table *table) {
    mt_table records = {0}, lists = {0};
    uint32_t selectors = 0, at = HEADER;
    for (int i = 0; i < data->variant_count; i = selector_end(data, i)) selectors++;
    at += RECORD * selectors;
    for (int i = 0, end; i < data->variant_count; i = end) {
        end = selector_end(data, i);
        write_record(data, i, end, &at, &records);
        write_lists(data, i, end, &lists);
    }
    mt_table_16(table, 14);
    mt_table_32(table, at);
    mt_table_32(table, selectors);
    mt_table_bytes(table, records.bytes, records.length);
    mt_table_bytes(table, lists.bytes, lists.length);
    table->failed |= records.failed || lists.failed;
    mt_table_free(&records);
    mt_table_free(&lists);
}
