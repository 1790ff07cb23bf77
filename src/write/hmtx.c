/* The horizontal metrics: 'hmtx' and 'hhea'. */
#include "write/tables.h"

/* Advances that repeat to the end of the font are stored once. */
static int stored_advances(const mt_font_data *data) {
    int count = data->glyph_count;
    while (count > 1 && data->glyphs[count - 2].advance == data->glyphs[count - 1].advance) count--;
    return count;
}

void mt_write_hmtx(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    int stored = stored_advances(data);
    for (int i = 0; i < data->glyph_count; i++) {
        if (i < stored) mt_table_16(table, data->glyphs[i].advance);
        mt_table_16(table, summary->extents[i].bounds.x_min); /* the left side bearing */
    }
}

static void write_caret(const mt_font_data *data, mt_table *table) {
    const mt_metrics *metrics = &data->metrics;
    bool given = metrics->caret_rise > 0;
    mt_table_i16_of(table, given ? metrics->caret_rise : 1);
    mt_table_i16_of(table, given ? metrics->caret_run : 0);
    mt_table_i16_of(table, metrics->caret_offset);
}

void mt_write_hhea(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    mt_table_32(table, 0x00010000);
    mt_table_i16_of(table, data->metrics.hhea_ascender);
    mt_table_i16_of(table, data->metrics.hhea_descender);
    mt_table_i16_of(table, data->metrics.hhea_line_gap);
    mt_table_16(table, summary->max_advance);
    mt_table_i16_of(table, summary->min_left);
    mt_table_i16_of(table, summary->min_right);
    mt_table_i16_of(table, summary->max_extent);
    write_caret(data, table);
    mt_table_zeros(table, 8); /* reserved */
    mt_table_16(table, 0);    /* metricDataFormat */
    mt_table_16(table, stored_advances(data));
}
