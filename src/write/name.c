/* The names: 'name', for Windows in English (US), which every platform reads.
 *
 * A family of old applications has four styles at most. A font of any other style is given to them as one of a family of
 * its own, FAMILY STYLE (style.h), and its true family and style stand in names 16 and 17. */
#include "write/tables.h"

#include <string.h>

#include "base/utf.h"
#include "sfnt/sfnt.h"
#include "write/postscript_name.h"

enum { WINDOWS = 3, UNICODE_BMP = 1, ENGLISH = 0x409, HEADER = 6, RECORD = 12 };

typedef struct mt_naming {
    mt_table records, strings; /* records in the order of the ids */
} mt_naming;

/* The first `length` bytes of the text as UTF-16, big-endian. */
static void put_text(const char *text, size_t length, mt_table *strings) {
    uint32_t c;
    const char *end = text + length;
    while (text < end && mt_utf8_next(&text, &c) && c) {
        if (c >= 0x10000) mt_table_16(strings, (int)(0xD800 + ((c - 0x10000) >> 10)));
        mt_table_16(strings, (int)(c >= 0x10000 ? 0xDC00 + ((c - 0x10000) & 0x3FF) : c));
    }
}

/* Adds the name `first`, followed by a blank and the first `length` bytes of `second` where these are any. */
static void add_joined(int id, const char *first, const char *second, size_t length, mt_naming *naming) {
    size_t start = naming->strings.length;
    put_text(first, strlen(first), &naming->strings);
    if (length) put_text(" ", 1, &naming->strings);
    if (length) put_text(second, length, &naming->strings);
    const int record[] = {WINDOWS,   UNICODE_BMP, ENGLISH, id, (int)(naming->strings.length - start),
                          (int)start};
    for (int i = 0; i < RECORD / 2; i++) mt_table_16(&naming->records, record[i]);
}

/* Nothing for NULL. */
static void add_name(int id, const char *text, mt_naming *naming) {
    if (text) add_joined(id, text, "", 0, naming);
}

/* ---- the axis ------------------------------------------------------------------------------------------ */

/* What 'STAT' says of slope, and of the places without it. */
static void add_slope_names(const mt_axis_data *variation, mt_naming *naming) {
    int id = mt_name_slope(variation);
    bool italic = variation->slope == MT_SLOPE_ITALIC;
    add_name(id++, "Italic", naming);
    add_name(id++, italic ? "Italic" : "Roman", naming);
    for (int i = 0; italic && i < variation->named_count; i++)
        add_name(id + i, variation->named[i].part, naming);
}

/* Two files of a family have not the same beginning of PostScript names. */
static void add_prefix(const mt_font_data *data, mt_naming *naming) {
    char name[MT_POSTSCRIPT_NAME_ROOM];
    mt_postscript_prefix(data->family, name);
    if (data->variation->slope == MT_SLOPE_ITALIC) strcat(name, "Italic"); /* a place's own name is longer */
    add_name(MT_NAME_VARIATIONS_PREFIX, name, naming);
}

/* The PostScript names of the places stand behind their names. */
static void add_axis_names(const mt_font_data *data, mt_naming *naming) {
    const mt_axis_data *variation = data->variation;
    char name[MT_POSTSCRIPT_NAME_ROOM];
    int count = variation->named_count;
    add_prefix(data, naming);
    add_name(MT_NAME_AXIS, variation->name, naming);
    for (int i = 0; i < count; i++) add_name(MT_NAME_PLACES + i, variation->named[i].name, naming);
    for (int i = 0; i < count; i++) {
        mt_postscript_place_name(data->family, variation->named[i].name, name);
        add_name(MT_NAME_PLACES + count + i, name, naming);
    }
    if (variation->slope != MT_SLOPE_UNTOLD) add_slope_names(variation, naming);
}

/* ---- the table ----------------------------------------------------------------------------------------- */

static void add_names(const mt_font_data *data, const mt_summary *summary, mt_naming *naming) {
    const char *linked = mt_linked_style(summary);
    char postscript[MT_POSTSCRIPT_NAME_ROOM];
    mt_postscript_name(data->family, data->style, postscript);
    add_name(MT_NAME_COPYRIGHT, data->copyright, naming);
    add_joined(MT_NAME_FAMILY, data->family, data->style, summary->own_style, naming);
    add_name(MT_NAME_STYLE, linked, naming);
    add_name(MT_NAME_UNIQUE_ID, data->unique_id, naming);
    add_joined(MT_NAME_FULL, data->family, data->style, strlen(data->style), naming);
    add_name(MT_NAME_VERSION, data->version, naming);
    add_name(MT_NAME_POSTSCRIPT, postscript, naming);
    add_name(MT_NAME_TRADEMARK, data->trademark, naming);
    add_name(MT_NAME_DESIGNER, data->designer, naming);
    add_name(MT_NAME_DESCRIPTION, data->description, naming);
    add_name(MT_NAME_LICENSE, data->license, naming);
    add_name(MT_NAME_LICENSE_URL, data->license_url, naming);
    if (strcmp(data->style, linked) != 0) {
        add_name(MT_NAME_TYPOGRAPHIC_FAMILY, data->family, naming);
        add_name(MT_NAME_TYPOGRAPHIC_STYLE, data->style, naming);
    }
    if (data->variation) add_axis_names(data, naming);
}

void mt_write_name(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    mt_naming naming = {0};
    add_names(data, summary, &naming);
    mt_table_16(table, 0); /* version */
    mt_table_16(table, (int)(naming.records.length / RECORD));
    mt_table_16(table, (int)(HEADER + naming.records.length));
    mt_table_bytes(table, naming.records.bytes, naming.records.length);
    mt_table_bytes(table, naming.strings.bytes, naming.strings.length);
    if (naming.records.failed || naming.strings.failed) table->failed = true;
    mt_table_free(&naming.records);
    mt_table_free(&naming.strings);
}
