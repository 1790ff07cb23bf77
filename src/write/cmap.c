/* The character map: 'cmap'.
 *
 * Format 4 holds the Basic Multilingual Plane in segments where both the code points and the glyphs rise by
 * one. Its length field has 16 bits, which is 8188 segments; a font that needs more, or that maps U+FFFF or
 * beyond, also gets a format 12 subtable with every character, and format 4 then holds the first ones, as
 * many as fit. A symbol font has format 4 as its map for symbols too, so that HarfBuzz and Windows find its glyphs by
 * codes of one byte. Variation sequences stand in a subtable of format 14 (write_cmap14.c). */
#include "write/tables.h"

enum { UNICODE = 0, WINDOWS = 3 };
enum {
    UNICODE_BMP = 3,
    UNICODE_FULL = 4,
    UNICODE_VARIANTS = 5,
    WINDOWS_SYMBOL = 0,
    WINDOWS_BMP = 1,
    WINDOWS_FULL = 10
};
enum { FORMAT12_HEADER = 16, FORMAT12_GROUP = 12 };
enum { FORMAT4_HEADER = 16, FORMAT4_SEGMENT = 8, LAST_OF_BMP = 0xFFFF, HEADER = 4, RECORD = 8 };
enum {
    SEGMENTS_MAX = (0xFFFF - FORMAT4_HEADER) / FORMAT4_SEGMENT - 1
}; /* besides the one that ends the list */

/* The end of the run of characters from `start`: code points and glyphs rise by one. */
static int run_end(const mt_font_data *data, int start, int limit) {
    int end = start + 1;
    while (end < limit && data->chars[end].code_point == data->chars[end - 1].code_point + 1 &&
           data->chars[end].glyph == data->chars[end - 1].glyph + 1)
        end++;
    return end;
}

/* How many characters format 4 takes, and in how many segments. */
static int count_bmp(const mt_font_data *data, int *segments) {
    int limit = 0, end = 0;
    while (limit < data->char_count && data->chars[limit].code_point < LAST_OF_BMP) limit++;
    for (*segments = 0; end < limit && *segments < SEGMENTS_MAX; (*segments)++)
        end = run_end(data, end, limit);
    return end;
}

/* ---- format 4 ------------------------------------------------------------------------------------------ */

/* The three numbers that help a binary search over `count` segments. */
static void write_search(int count, mt_table *table) {
    int selector = 0;
    while (2 << selector <= count) selector++;
    mt_table_16(table, 2 << selector);
    mt_table_16(table, selector);
    mt_table_16(table, 2 * count - (2 << selector));
}

/* One of the parallel arrays: a number of each segment, then that of the segment for U+FFFF, which maps
 * nothing. */
typedef enum mt_column { END, START, DELTA } mt_column;

static void write_column(const mt_font_data *data, int limit, mt_column column, mt_table *table) {
    for (int i = 0, end; i < limit; i = end) {
        end = run_end(data, i, limit);
        int first = (int)data->chars[i].code_point, last = (int)data->chars[end - 1].code_point;
        mt_table_16(table, column == END ? last : column == START ? first : data->chars[i].glyph - first);
    }
    mt_table_16(table, column == DELTA ? 1 : LAST_OF_BMP);
}

static void write_format4(const mt_font_data *data, int limit, int segments, mt_table *table) {
    int count = segments + 1;
    mt_table_16(table, 4);
    mt_table_16(table, FORMAT4_HEADER + FORMAT4_SEGMENT * count);
    mt_table_16(table, 0); /* language */
    mt_table_16(table, 2 * count);
    write_search(count, table);
    write_column(data, limit, END, table);
    mt_table_16(table, 0); /* reserved */
    write_column(data, limit, START, table);
    write_column(data, limit, DELTA, table);
    mt_table_zeros(table, 2 * count); /* idRangeOffset: the glyphs come from the deltas */
}

/* ---- format 12 ----------------------------------------------------------------------------------------- */

static int count_groups(const mt_font_data *data) {
    int count = 0;
    for (int i = 0; i < data->char_count; count++) i = run_end(data, i, data->char_count);
    return count;
}

static void write_format12(const mt_font_data *data, mt_table *table) {
    int groups = count_groups(data);
    mt_table_16(table, 12);
    mt_table_16(table, 0); /* reserved */
    mt_table_32(table, FORMAT12_HEADER + FORMAT12_GROUP * (uint32_t)groups);
    mt_table_32(table, 0); /* language */
    mt_table_32(table, (uint32_t)groups);
    for (int i = 0, end; i < data->char_count; i = end) {
        end = run_end(data, i, data->char_count);
        mt_table_32(table, data->chars[i].code_point);
        mt_table_32(table, data->chars[end - 1].code_point);
        mt_table_32(table, data->chars[i].glyph);
    }
}

/* ---- the table ----------------------------------------------------------------------------------------- */

static void write_record(int platform, int encoding, int offset, mt_table *table) {
    mt_table_16(table, platform);
    mt_table_16(table, encoding);
    mt_table_32(table, (uint32_t)offset);
}

void mt_write_cmap(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    (void)summary;
    int segments, limit = count_bmp(data, &segments);
    bool full = limit<data->char_count, varied = data->variant_count> 0;
    int records = (full ? 4 : 2) + varied + data->is_symbol, format4 = HEADER + RECORD * records;
    int format12 = format4 + FORMAT4_HEADER + FORMAT4_SEGMENT * (segments + 1);
    int format14 = format12 + (full ? FORMAT12_HEADER + FORMAT12_GROUP * count_groups(data) : 0);
    mt_table_16(table, 0); /* version */
    mt_table_16(table, records);
    write_record(UNICODE, UNICODE_BMP, format4, table);
    if (full) write_record(UNICODE, UNICODE_FULL, format12, table);
    if (varied) write_record(UNICODE, UNICODE_VARIANTS, format14, table);
    if (data->is_symbol) write_record(WINDOWS, WINDOWS_SYMBOL, format4, table);
    write_record(WINDOWS, WINDOWS_BMP, format4, table);
    if (full) write_record(WINDOWS, WINDOWS_FULL, format12, table);
    write_format4(data, limit, segments, table);
    if (full) write_format12(data, table);
    if (varied) mt_write_variation_sequences(data, table);
}
