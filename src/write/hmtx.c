/* The horizontal metrics: 'hmtx' and 'hhea'. */
#include "write/tables.h"

#include <math.h>

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

/* The caret leans with the letters: rise to the em, run by the angle. */
static void write_caret(const mt_font_data *data, mt_table *table) {
    double slope = tan(-data->metrics.italic_angle * acos(-1) / 180), run = slope * data->units;
    bool upright = !(fabs(run) >= 0.5 && fabs(run) <= INT16_MAX);
    mt_table_16(table, upright ? 1 : data->units);
    mt_table_i16_of(table, upright ? 0 : run);
    mt_table_i16_of(table, data->metrics.caret_offset);
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
