/* The names: 'name', for Windows in English (US), which every platform reads.
 *
 * A family of old applications has four styles at most. A font of any other style is given to them as a
 * family of its own, FAMILY STYLE, and its true family and style stand in names 16 and 17. */
#include "write/tables.h"

#include <stdio.h>
#include <string.h>

#include "base/utf.h"
#include "sfnt/sfnt.h"

enum { WINDOWS = 3, UNICODE_BMP = 1, ENGLISH = 0x409, HEADER = 6, RECORD = 12 };

typedef struct mt_naming {
    mt_table records, strings; /* records in the order of the ids */
} mt_naming;

/* UTF-16, big-endian. */
static void put_text(const char *text, mt_table *strings) {
    uint32_t c;
    while (mt_utf8_next(&text, &c) && c) {
        if (c >= 0x10000) mt_table_16(strings, (int)(0xD800 + ((c - 0x10000) >> 10)));
        mt_table_16(strings, (int)(c >= 0x10000 ? 0xDC00 + ((c - 0x10000) & 0x3FF) : c));
    }
}

/* Adds the name `first`, or `first second` when there is a second. */
static void add_name(int id, const char *first, const char *second, mt_naming *naming) {
    size_t start = naming->strings.length;
    if (!first) return;
    put_text(first, &naming->strings);
    if (second) put_text(" ", &naming->strings);
    if (second) put_text(second, &naming->strings);
    const int record[] = {WINDOWS,   UNICODE_BMP, ENGLISH, id, (int)(naming->strings.length - start),
                          (int)start};
    for (int i = 0; i < RECORD / 2; i++) mt_table_16(&naming->records, record[i]);
}

/* ---- the PostScript name ------------------------------------------------------------------------------- */

enum { POSTSCRIPT_MAX = MT_POSTSCRIPT_NAME_ROOM - 1, POSTSCRIPT_STYLE_MAX = 31 };

/* Copies what a PostScript name may hold; writes a character beyond ASCII as u and its hexadecimal code
 * point, so that names in any script stay apart, and leaves the rest out. At most `limit` bytes and a NUL. */
static void copy_printable(const char *text, size_t limit, char *name) {
    size_t length = 0;
    uint32_t c;
    while (mt_utf8_next(&text, &c) && c) {
        char escaped[12] = {(char)c};
        if (c <= ' ' || c == 0x7F || (c < 0x7F && strchr("[](){}<>/%-", (int)c))) continue;
        if (c > 0x7F) snprintf(escaped, sizeof escaped, "u%04X", (unsigned)c);
        if (length + strlen(escaped) > limit) break;
        memcpy(name + length, escaped, strlen(escaped));
        length += strlen(escaped);
    }
    name[length] = '\0';
}

void mt_postscript_name(const mt_font_data *data, char name[MT_POSTSCRIPT_NAME_ROOM]) {
    char style[POSTSCRIPT_STYLE_MAX + 1];
    copy_printable(data->style, POSTSCRIPT_STYLE_MAX, style);
    copy_printable(data->family, POSTSCRIPT_MAX - 1 - strlen(style), name);
    strcat(name, "-");
    strcat(name, style);
}

static void add_postscript_name(const mt_font_data *data, mt_naming *naming) {
    char name[MT_POSTSCRIPT_NAME_ROOM];
    mt_postscript_name(data, name);
    add_name(MT_NAME_POSTSCRIPT, name, NULL, naming);
}

/* ---- the axis ------------------------------------------------------------------------------------------ */

/* Of the family alone, without what stands for another character. */
static void add_axis_names(const mt_font_data *data, mt_naming *naming) {
    const mt_axis_data *variation = data->variation;
    char prefix[MT_POSTSCRIPT_NAME_ROOM];
    copy_printable(data->family, POSTSCRIPT_MAX - POSTSCRIPT_STYLE_MAX, prefix);
    add_name(MT_NAME_VARIATIONS_PREFIX, prefix, NULL, naming);
    add_name(MT_NAME_AXIS, variation->name, NULL, naming);
    for (int i = 0; i < variation->named_count; i++)
        add_name(MT_NAME_PLACES + i, variation->named[i].name, NULL, naming);
}

/* ---- the table ----------------------------------------------------------------------------------------- */

static void add_names(const mt_font_data *data, const mt_summary *summary, mt_naming *naming) {
    const char *linked = mt_linked_style(summary);
    bool is_linked = strcmp(data->style, linked) == 0;
    add_name(MT_NAME_COPYRIGHT, data->copyright, NULL, naming);
    add_name(MT_NAME_FAMILY, data->family, is_linked ? NULL : data->style, naming);
    add_name(MT_NAME_STYLE, linked, NULL, naming);
    add_name(MT_NAME_UNIQUE_ID, data->unique_id, NULL, naming);
    add_name(MT_NAME_FULL, data->family, data->style, naming);
    add_name(MT_NAME_VERSION, data->version, NULL, naming);
    add_postscript_name(data, naming);
    add_name(MT_NAME_TRADEMARK, data->trademark, NULL, naming);
    add_name(MT_NAME_DESIGNER, data->designer, NULL, naming);
    add_name(MT_NAME_DESCRIPTION, data->description, NULL, naming);
    add_name(MT_NAME_LICENSE, data->license, NULL, naming);
    add_name(MT_NAME_LICENSE_URL, data->license_url, NULL, naming);
    if (!is_linked) {
        add_name(MT_NAME_TYPOGRAPHIC_FAMILY, data->family, NULL, naming);
        add_name(MT_NAME_TYPOGRAPHIC_STYLE, data->style, NULL, naming);
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
