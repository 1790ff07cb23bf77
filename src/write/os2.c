/* 'OS/2', version 4. */
#include "write/tables.h"

#include <string.h>

#include "sfnt/sfnt.h"
#include "source/panose.h"
#include "write/max_context.h"

/* The mean of the advances that are not zero. */
static double mean_advance(const mt_font_data *data) {
    int64_t sum = 0, count = 0;
    for (int i = 0; i < data->glyph_count; i++) {
        sum += data->glyphs[i].advance;
        count += data->glyphs[i].advance > 0;
    }
    return count ? (double)sum / (double)count : 0;
}

static void write_pair(const double pair[2], mt_table *table) {
    mt_table_i16_of(table, pair[0]);
    mt_table_i16_of(table, pair[1]);
}

/* A monospaced font says so, unless its family knows no such proportion. */
static void write_panose(const mt_metrics *metrics, mt_table *table) {
    uint8_t panose[MT_PANOSE_DIGITS];
    memcpy(panose, metrics->panose, sizeof panose);
    if (metrics->monospaced && panose[0] == 0) panose[0] = MT_PANOSE_LATIN_TEXT;
    if (metrics->monospaced && panose[0] == MT_PANOSE_LATIN_TEXT)
        panose[MT_PANOSE_PROPORTION] = MT_PANOSE_MONOSPACED;
    mt_table_bytes(table, panose, sizeof panose);
}

static void write_coverage(const mt_font_data *data, mt_table *table) {
    uint32_t bits[4];
    mt_unicode_ranges(data->chars, data->char_count, bits);
    for (int i = 0; i < 4; i++) mt_table_32(table, bits[i]);
}

static void write_selection(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    enum { ITALIC = 1, BOLD = 1 << 5, REGULAR = 1 << 6, USE_TYPO_METRICS = 1 << 7 };
    int selection = (summary->italic ? ITALIC : 0) | (summary->bold ? BOLD : 0);
    if (selection == 0) selection = REGULAR;
    mt_table_16(table, selection | (data->metrics.use_typo_metrics ? USE_TYPO_METRICS : 0));
}

/* The first and the last code point, where they fit. */
static void write_char_range(const mt_font_data *data, mt_table *table) {
    uint32_t first = data->char_count ? data->chars[0].code_point : 0;
    uint32_t last = data->char_count ? data->chars[data->char_count - 1].code_point : 0;
    mt_table_16(table, first < 0xFFFF ? (int)first : 0xFFFF);
    mt_table_16(table, last < 0xFFFF ? (int)last : 0xFFFF);
}

static void write_lines(const mt_metrics *metrics, mt_table *table) {
    mt_table_i16_of(table, metrics->typo_ascender);
    mt_table_i16_of(table, metrics->typo_descender);
    mt_table_i16_of(table, metrics->typo_line_gap);
    mt_table_u16_of(table, metrics->win_ascent);
    mt_table_u16_of(table, metrics->win_descent);
}

static int max_context(const mt_font_data *data) {
    int most = 0;
    for (int i = 0; i < data->extra_count; i++) {
        const mt_extra_table *extra = &data->extras[i];
        bool substitution = extra->tag == MT_TAG('G', 'S', 'U', 'B');
        if (!substitution && extra->tag != MT_TAG('G', 'P', 'O', 'S')) continue;
        int found = mt_max_context(extra->data, substitution);
        if (found > most) most = found;
    }
    return most;
}

/* What version 2 added to the end of the table. */
static void write_heights(const mt_font_data *data, mt_table *table) {
    mt_table_i16_of(table, data->metrics.x_height);
    mt_table_i16_of(table, data->metrics.cap_height);
    mt_table_16(table, 0); /* usDefaultChar: .notdef */
    mt_table_16(table, mt_has_char(data->chars, data->char_count, ' ') ? ' ' : 0); /* usBreakChar */
    mt_table_16(table, max_context(data));
}

void mt_write_os2(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    const mt_metrics *metrics = &data->metrics;
    uint32_t pages[2];
    mt_table_16(table, 4);
    mt_table_i16_of(table, mean_advance(data));
    mt_table_u16_of(table, metrics->weight_class);
    mt_table_u16_of(table, metrics->width_class);
    mt_table_16(table, data->embedding);
    write_pair(metrics->subscript_size, table);
    write_pair(metrics->subscript_offset, table);
    write_pair(metrics->superscript_size, table);
    write_pair(metrics->superscript_offset, table);
    mt_table_i16_of(table, metrics->strikeout_size);
    mt_table_i16_of(table, metrics->strikeout_position);
    mt_table_16(table, metrics->family_class);
    write_panose(metrics, table);
    write_coverage(data, table);
    mt_table_bytes(table, "    ", 4); /* achVendID: none */
    write_selection(data, summary, table);
    write_char_range(data, table);
    write_lines(metrics, table);
    mt_code_pages(data->chars, data->char_count, data->is_symbol, pages);
    mt_table_32(table, pages[0]);
    mt_table_32(table, pages[1]);
    write_heights(data, table);
}
