/* The font as a whole: 'head', 'maxp' and 'post'. */
#include "write/tables.h"

#include <string.h>

double mt_font_revision(const char *version) {
    double value = 0, place = 1;
    while (version && *version && (*version < '0' || *version > '9')) version++;
    if (!version || !*version) return 1;
    for (; *version >= '0' && *version <= '9'; version++) value = 10 * value + (*version - '0');
    if (*version == '.') version++;
    for (; *version >= '0' && *version <= '9'; version++) value += (*version - '0') * (place /= 10);
    return value;
}

/* checkSumAdjustment is left 0: HarfBuzz fills it in. */
void mt_write_head(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    enum { BASELINE_AT_0 = 1, LEFT_BEARING_AT_0 = 2, SMALLEST_READABLE = 8, STRONGLY_LEFT_TO_RIGHT = 2 };
    mt_table_32(table, 0x00010000);
    mt_table_fixed(table, mt_font_revision(data->version));
    mt_table_32(table, 0);
    mt_table_32(table, 0x5F0F3CF5); /* magicNumber */
    mt_table_16(table, BASELINE_AT_0 | LEFT_BEARING_AT_0);
    mt_table_16(table, data->units);
    mt_table_64(table, data->created);
    mt_table_64(table, data->modified);
    mt_table_16(table, summary->bounds.x_min);
    mt_table_16(table, summary->bounds.y_min);
    mt_table_16(table, summary->bounds.x_max);
    mt_table_16(table, summary->bounds.y_max);
    mt_table_16(table, (summary->bold ? 1 : 0) | (summary->italic ? 2 : 0)); /* macStyle */
    mt_table_16(table, SMALLEST_READABLE);
    mt_table_16(table, STRONGLY_LEFT_TO_RIGHT); /* fontDirectionHint; deprecated */
    mt_table_16(table, mt_loca_is_long(data, summary));
    mt_table_16(table, 0); /* glyphDataFormat */
}

void mt_write_maxp(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    mt_table_32(table, 0x00010000);
    mt_table_16(table, data->glyph_count);
    mt_table_16(table, summary->max_points);
    mt_table_16(table, summary->max_contours);
    mt_table_16(table, summary->max_composite_points);
    mt_table_16(table, summary->max_composite_contours);
    mt_table_16(table, 1);    /* maxZones */
    mt_table_zeros(table, 8); /* of the instructions' storage and functions: there are none */
    mt_table_16(table, 1);    /* maxStackElements: prep's */
    mt_table_16(table, 0);    /* maxSizeOfInstructions: of glyphs */
    mt_table_16(table, summary->max_references);
    mt_table_16(table, summary->max_depth);
}

/* The names of version 2, as Pascal strings: all are the font's own, numbered from 258 on, but that of .notdef, which is
 * the first of the standard Macintosh names. */
static void write_names(const mt_font_data *data, mt_table *table) {
    enum { FIRST_OWN = 258 };
    mt_table_16(table, data->glyph_count);
    mt_table_16(table, 0);
    for (int i = 1; i < data->glyph_count; i++) mt_table_16(table, FIRST_OWN + i - 1);
    for (int i = 1; i < data->glyph_count; i++) {
        size_t length = strlen(data->glyph_names[i]);
        mt_table_u8(table, (unsigned)length);
        mt_table_bytes(table, data->glyph_names[i], length);
    }
}

/* Version 2 with glyph names, as long as they can be numbered; version 3 without. */
void mt_write_post(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    enum { NAMED_MOST = 65278 };
    bool named = data->glyph_names && data->glyph_count <= NAMED_MOST;
    (void)summary;
    mt_table_32(table, named ? 0x00020000 : 0x00030000);
    mt_table_fixed(table, data->metrics.italic_angle);
    mt_table_i16_of(table, data->metrics.underline_position);
    mt_table_i16_of(table, data->metrics.underline_thickness);
    mt_table_32(table, data->metrics.monospaced);
    mt_table_zeros(table, 16); /* memory use when downloaded: unknown */
    if (named) write_names(data, table);
}
