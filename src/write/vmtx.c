/* The vertical metrics: 'vmtx' and 'vhea'. */
#include "write/tables.h"

/* Heights that repeat to the end of the font are stored once. */
static int stored_heights(const mt_font_data *data) {
    int count = data->glyph_count;
    while (count > 1 && data->glyphs[count - 2].height == data->glyphs[count - 1].height) count--;
    return count;
}

/* Readers take a blank glyph's top to be at 0, and find its origin too. */
int mt_top_bearing(const mt_glyf *glyph, const mt_extent *extent) {
    int bearing = glyph->origin - extent->bounds.y_max;
    return bearing < INT16_MIN ? INT16_MIN : bearing > INT16_MAX ? INT16_MAX : bearing;
}

void mt_write_vmtx(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    if (!data->metrics.vertical) return;
    int stored = stored_heights(data);
    for (int i = 0; i < data->glyph_count; i++) {
        if (i < stored) mt_table_16(table, data->glyphs[i].height);
        mt_table_16(table, mt_top_bearing(&data->glyphs[i], &summary->extents[i]));
    }
}

void mt_write_vhea(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    if (!data->metrics.vertical) return;
    mt_table_32(table, 0x00011000); /* version 1.1 */
    mt_table_i16_of(table, data->metrics.vhea_ascender);
    mt_table_i16_of(table, data->metrics.vhea_descender);
    mt_table_i16_of(table, data->metrics.vhea_line_gap);
    mt_table_16(table, summary->max_height);
    mt_table_i16_of(table, summary->min_top);
    mt_table_i16_of(table, summary->min_bottom);
    mt_table_i16_of(table, summary->max_vertical_extent);
    mt_table_16(table, 0);     /* caretSlopeRise: the caret lies across the line */
    mt_table_16(table, 1);     /* caretSlopeRun */
    mt_table_zeros(table, 10); /* caretOffset, reserved */
    mt_table_16(table, 0);     /* metricDataFormat */
    mt_table_16(table, stored_heights(data));
}
