/* What a font says of itself: the 'name' table, or the FontInfo dictionary of a Type 1 font.
 *
 * Of several records for one name the best is taken (`rank`): English for Windows, Unicode, Mac Roman, then
 * any language. The table is read here and not through FT_Get_Sfnt_Name, which keeps a copy of every string:
 * a hostile table can make 65 535 records share one long string. */
#include "source/handle.h"

#include <string.h>

#include FT_TRUETYPE_TABLES_H
#include FT_TYPE1_TABLES_H

#include "base/utf.h"
#include "sfnt/sfnt.h"

typedef enum mt_encoding { UTF16, MAC_ROMAN, LATIN1 } mt_encoding;

typedef struct mt_text { /* still encoded */
    const uint8_t *bytes;
    size_t length;
    mt_encoding encoding;
} mt_text;

typedef struct mt_name_table {
    uint8_t *bytes;
    size_t length, count, strings; /* where the strings start */
} mt_name_table;

/* ---- text ---------------------------------------------------------------------------------------------- */

/* The upper half of Mac Roman, as Apple publishes it. */
static const uint16_t mac_roman[128] = {
    0x00C4, 0x00C5, 0x00C7, 0x00C9, 0x00D1, 0x00D6, 0x00DC, 0x00E1, 0x00E0, 0x00E2, 0x00E4, 0x00E3, 0x00E5,
    0x00E7, 0x00E9, 0x00E8, 0x00EA, 0x00EB, 0x00ED, 0x00EC, 0x00EE, 0x00EF, 0x00F1, 0x00F3, 0x00F2, 0x00F4,
    0x00F6, 0x00F5, 0x00FA, 0x00F9, 0x00FB, 0x00FC, 0x2020, 0x00B0, 0x00A2, 0x00A3, 0x00A7, 0x2022, 0x00B6,
    0x00DF, 0x00AE, 0x00A9, 0x2122, 0x00B4, 0x00A8, 0x2260, 0x00C6, 0x00D8, 0x221E, 0x00B1, 0x2264, 0x2265,
    0x00A5, 0x00B5, 0x2202, 0x2211, 0x220F, 0x03C0, 0x222B, 0x00AA, 0x00BA, 0x03A9, 0x00E6, 0x00F8, 0x00BF,
    0x00A1, 0x00AC, 0x221A, 0x0192, 0x2248, 0x2206, 0x00AB, 0x00BB, 0x2026, 0x00A0, 0x00C0, 0x00C3, 0x00D5,
    0x0152, 0x0153, 0x2013, 0x2014, 0x201C, 0x201D, 0x2018, 0x2019, 0x00F7, 0x25CA, 0x00FF, 0x0178, 0x2044,
    0x20AC, 0x2039, 0x203A, 0xFB01, 0xFB02, 0x2021, 0x00B7, 0x201A, 0x201E, 0x2030, 0x00C2, 0x00CA, 0x00C1,
    0x00CB, 0x00C8, 0x00CD, 0x00CE, 0x00CF, 0x00CC, 0x00D3, 0x00D4, 0xF8FF, 0x00D2, 0x00DA, 0x00DB, 0x00D9,
    0x0131, 0x02C6, 0x02DC, 0x00AF, 0x02D8, 0x02D9, 0x02DA, 0x00B8, 0x02DD, 0x02DB, 0x02C7,
};

static uint32_t next_char(const mt_text *text, size_t *at) {
    if (text->encoding == UTF16) return mt_utf16_next(text->bytes, text->length, at);
    uint8_t byte = text->bytes[(*at)++];
    return text->encoding == MAC_ROMAN && byte >= 0x80 ? mac_roman[byte - 0x80] : byte;
}

/* UTF-8, without control characters: a line break or a tab becomes a space. NULL in *copy for an empty text. */
static mt_status copy_text(const mt_text *text, const char **copy) {
    char *to = mt_new(text->length + 1,
                      3); /* one byte becomes at most two, two bytes at most three, four at most four */
    if (!to) return MT_NO_MEMORY;
    size_t length = 0;
    for (size_t at = 0; at < text->length;) {
        uint32_t c = next_char(text, &at);
        if (c == '\n' || c == '\r' || c == '\t') c = ' ';
        if (c < ' ' || (c >= 0x7F && c < 0xA0)) continue;
        length += (size_t)mt_utf8_put(c, to + length);
    }
    while (length && to[length - 1] == ' ') length--;
    to[length] = '\0';
    *copy = length ? to : NULL;
    if (!length) mt_free(to);
    return MT_OK;
}

/* ---- the 'name' table (OpenType spec, "name - Naming Table") ------------------------------------------- */

static mt_status load_table(mt_font *font, mt_name_table *table) {
    FT_ULong length = 0;
    *table = (mt_name_table){0};
    if (FT_Load_Sfnt_Table(font->face, MT_TAG('n', 'a', 'm', 'e'), 0, NULL, &length) != 0) return MT_OK;
    if (length < 6) return MT_OK;
    uint8_t *bytes = mt_arena_new(&font->scratch, length, 1);
    if (!bytes) return MT_NO_MEMORY;
    if (FT_Load_Sfnt_Table(font->face, MT_TAG('n', 'a', 'm', 'e'), 0, bytes, &length) != 0) return MT_OK;
    size_t count = mt_read_u16(bytes + 2), room = (length - 6) / 12;
    *table = (mt_name_table){bytes, length, count < room ? count : room, mt_read_u16(bytes + 4)};
    return MT_OK;
}

/* How well a record serves, from its platform, encoding and language; 0: it cannot be decoded. */
static int rank(const uint8_t *record, mt_encoding *encoding) {
    enum { UNICODE, MACINTOSH, WINDOWS = 3 };
    unsigned platform = mt_read_u16(record), script = mt_read_u16(record + 2),
             language = mt_read_u16(record + 4);
    *encoding = platform == MACINTOSH ? MAC_ROMAN : UTF16;
    if (platform == WINDOWS && (script == 1 || script == 10 || script == 0))
        return language == 0x409 ? 6 : (language & 0x3FF) == 9 ? 5 : 2;
    if (platform == UNICODE) return 4;
    if (platform == MACINTOSH && script == 0) return language == 0 ? 3 : 1;
    return 0;
}

/* The best record of a name. */
static bool find_name(const mt_name_table *table, int id, mt_text *text) {
    int best = 0;
    for (size_t i = 0; i < table->count; i++) {
        const uint8_t *record = table->bytes + 6 + 12 * i;
        size_t length = mt_read_u16(record + 8), offset = table->strings + mt_read_u16(record + 10);
        mt_encoding encoding;
        if ((int)mt_read_u16(record + 6) != id || length == 0) continue;
        if (offset > table->length || length > table->length - offset) continue;
        int value = rank(record, &encoding);
        if (value <= best) continue;
        best = value;
        *text = (mt_text){table->bytes + offset, length, encoding};
    }
    return best > 0;
}

/* The name of the first of two ids that has one; NULL in *copy when neither has. */
static mt_status copy_name(const mt_name_table *table, int first, int second, const char **copy) {
    mt_text text;
    if (!find_name(table, first, &text) && !find_name(table, second, &text)) return MT_OK;
    return copy_text(&text, copy);
}

static mt_status read_table(const mt_name_table *table, int instance_name, mt_names *names) {
    enum { NONE = -1 };
    mt_status status = copy_name(table, instance_name, NONE, &names->style);
    const struct {
        int first, second;
        const char **copy;
    } wanted[] = {
        {MT_NAME_TYPOGRAPHIC_FAMILY, MT_NAME_FAMILY, &names->family},
        {MT_NAME_TYPOGRAPHIC_STYLE, MT_NAME_STYLE, &names->style},
        {MT_NAME_VERSION, NONE, &names->version},
        {MT_NAME_COPYRIGHT, NONE, &names->copyright},
        {MT_NAME_LICENSE, NONE, &names->license},
        {MT_NAME_LICENSE_URL, NONE, &names->license_url},
        {MT_NAME_DESIGNER, NONE, &names->designer},
        {MT_NAME_TRADEMARK, NONE, &names->trademark},
    };
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted && status == MT_OK; i++)
        if (!*wanted[i].copy) status = copy_name(table, wanted[i].first, wanted[i].second, wanted[i].copy);
    return status;
}

/* ---- other formats ------------------------------------------------------------------------------------- */

static mt_status copy_latin1(const char *text, const char **copy) {
    if (!text || *copy) return MT_OK;
    return copy_text(&(mt_text){(const uint8_t *)text, strlen(text), LATIN1}, copy);
}

/* Fills in what is missing from what FreeType makes out and from a Type 1 font's FontInfo (Adobe Type 1 Font
 * Format, section 2.2), whose Notice is its copyright. */
static mt_status read_others(const mt_font *font, mt_names *names) {
    PS_FontInfoRec info;
    mt_status status = copy_latin1(font->face->family_name, &names->family);
    if (status == MT_OK) status = copy_latin1(font->face->style_name, &names->style);
    if (FT_Get_PS_Font_Info(font->face, &info) != 0) return status;
    if (status == MT_OK) status = copy_latin1(info.family_name, &names->family);
    if (status == MT_OK) status = copy_latin1(info.version, &names->version);
    if (status == MT_OK) status = copy_latin1(info.notice, &names->copyright);
    return status;
}

/* ---- the handle's -------------------------------------------------------------------------------------- */

mt_status mt_font_read_names(mt_font *font) {
    mt_name_table table;
    mt_status status = load_table(font, &table);
    if (status == MT_OK) status = read_table(&table, font->instance_name, &font->names);
    if (status == MT_OK) status = read_others(font, &font->names);
    return status;
}

void mt_font_free_names(mt_font *font) {
    const mt_names *names = &font->names;
    const char *owned[] = {names->family,  names->style,       names->version,  names->copyright,
                           names->license, names->license_url, names->designer, names->trademark};
    for (size_t i = 0; i < sizeof owned / sizeof *owned; i++) mt_free((void *)owned[i]);
    font->names = (mt_names){0};
}

void mt_font_names(const mt_font *font, mt_names *names) {
    *names = font->names;
}

const char *mt_font_family(const mt_font *font) {
    return font->names.family ? font->names.family : "Untitled";
}

const char *mt_font_style(const mt_font *font) {
    return font->names.style ? font->names.style : "Regular";
}
