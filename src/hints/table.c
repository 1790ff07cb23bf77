#include "hints/table.h"

#include <stdlib.h>
#include <string.h>

#include "base/decimal.h"
#include "base/file.h"
#include "base/lines.h"
#include "base/memory.h"
#include "base/utf.h"
#include "geometry/limits.h"

enum { WORDS = 3 }; /* that a line has at most */

typedef struct mt_hint_reader {
    mt_hint_table *table;
    bool has_glyph;
    uint32_t code_point; /* of the glyph that the hints are for; or … */
    const char *name;    /* … its name, and … */
    int name_line;       /* … where it stands */
    int line;
    const char *reason; /* what is wrong with the line, on MT_BAD_HINTS */
} mt_hint_reader;

static mt_status bad(mt_hint_reader *reader, const char *reason) {
    reader->reason = reason;
    return MT_BAD_HINTS;
}

/* ---- words --------------------------------------------------------------------------------------------- */

static int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/* The code point of U+X, one to six digits. */
static bool read_code_point(const char *word, uint32_t *code_point) {
    uint32_t value = 0;
    size_t length = strlen(word);
    if ((word[0] != 'U' && word[0] != 'u') || word[1] != '+' || length < 3 || length > 8) return false;
    for (const char *at = word + 2; *at; at++) {
        if (hex_digit(*at) < 0) return false;
        value = 16 * value + (uint32_t)hex_digit(*at);
    }
    if (value > 0x10ffff || (value >= 0xd800 && value <= 0xdfff)) return false;
    *code_point = value;
    return true;
}

static bool read_character(const char *word, uint32_t *code_point) {
    const char *after = word;
    if (mt_utf8_next(&after, code_point) && *after == '\0') return true;
    return read_code_point(word, code_point);
}

/* X,Y and nothing else. */
static bool read_place(const char *word, mt_hint_place *place) {
    if (!mt_decimal_next(&word, &place->x) || *word++ != ',') return false;
    return mt_decimal_next(&word, &place->y) && *word == '\0';
}

/* ---- lines --------------------------------------------------------------------------------------------- */

static mt_status add(mt_hint_table *table, mt_hint_line line) {
    mt_hint_line *lines = mt_grow_list(table->lines, table->count, &table->room, sizeof *lines);
    if (!lines) return MT_NO_MEMORY;
    table->lines = lines;
    table->lines[table->count++] = line;
    return MT_OK;
}

static mt_status read_glyph(mt_hint_reader *reader, const char *const *words, int count) {
    bool named = count == 2 && words[1][0] == '/' && words[1][1];
    if (count != 2 || (!named && !read_character(words[1], &reader->code_point)))
        return bad(reader, "after glyph one character is wanted, itself or as U+0061, or a name as /a.sc");
    reader->has_glyph = true;
    reader->name = named ? words[1] + 1 : NULL;
    reader->name_line = reader->line;
    return MT_OK;
}

static mt_status read_hint(mt_hint_reader *reader, mt_hint_kind kind, const char *const *words, int count) {
    mt_hint_line hint = {.code_point = reader->name ? 0 : reader->code_point,
                         .name = reader->name,
                         .name_line = reader->name_line,
                         .line = reader->line,
                         .kind = kind};
    if (!reader->has_glyph) return bad(reader, "a hint before the first glyph");
    if (count != 3) return bad(reader, "a hint has two places, written 120,300 140,310");
    if (!read_place(words[1], &hint.a) || !read_place(words[2], &hint.b))
        return bad(reader, "a place is written 120,300: decimal numbers under 32768");
    if (reader->table->count == MT_HINTS_MAX) return bad(reader, "too many hints");
    return add(reader->table, hint);
}

static mt_status read_line(mt_hint_reader *reader, char *line) {
    const char *words[WORDS];
    if (!mt_utf8_is_valid(line, strlen(line))) return bad(reader, "not UTF-8 text");
    int count = mt_words_split(line, words, WORDS);
    if (count == 0) return MT_OK;
    if (strcmp(words[0], "glyph") == 0) return read_glyph(reader, words, count);
    if (strcmp(words[0], "component") == 0) return read_hint(reader, MT_HINT_COMPONENT, words, count);
    if (strcmp(words[0], "point") == 0) return read_hint(reader, MT_HINT_POINT, words, count);
    return bad(reader, "a line begins with glyph, component or point");
}

/* `text` ends with a NUL at `length` and is cut into lines in place. */
static mt_status read_lines(mt_hint_reader *reader, char *text, size_t length) {
    mt_lines lines = mt_lines_of(text, length);
    mt_status status = MT_OK;
    bool whole;
    for (char *line; status == MT_OK && (line = mt_lines_next(&lines, &whole));) {
        reader->line = lines.number;
        status = whole ? read_line(reader, line) : bad(reader, "not UTF-8 text");
    }
    return status;
}

/* ---- the table ----------------------------------------------------------------------------------------- */

static int by_character(const void *a, const void *b) {
    const mt_hint_line *x = a, *y = b;
    if (!x->name != !y->name) return x->name ? 1 : -1;
    if (x->code_point != y->code_point) return x->code_point < y->code_point ? -1 : 1;
    return (x->line > y->line) - (x->line < y->line);
}

/* Reads `text`, which ends with a NUL at `length`, and takes it over, whatever comes. */
static mt_status read_table(char *text, size_t length, mt_hint_table **table, mt_hint_error *error) {
    mt_hint_reader reader = {.table = mt_new(1, sizeof(mt_hint_table))};
    if (!reader.table) {
        mt_free(text);
        return MT_NO_MEMORY;
    }
    reader.table->text = text;
    mt_status status = read_lines(&reader, text, length);
    if (status != MT_OK) {
        mt_hint_table_free(reader.table);
        if (status == MT_BAD_HINTS && error) *error = (mt_hint_error){reader.line, reader.reason};
        return status;
    }
    if (reader.table->count > 0)
        qsort(reader.table->lines, (size_t)reader.table->count, sizeof *reader.table->lines, by_character);
    for (int i = 0; i < reader.table->count; i++)
        reader.table->character_count += !reader.table->lines[i].name;
    *table = reader.table;
    return MT_OK;
}

mt_status mt_hint_table_read(const char *text, size_t length, mt_hint_table **table, mt_hint_error *error) {
    if (length > MT_HINT_FILE_MAX) return MT_TOO_LARGE;
    char *copy = mt_new(length + 1, 1);
    if (!copy) return MT_NO_MEMORY;
    if (length > 0) memcpy(copy, text, length);
    return read_table(copy, length, table, error);
}

mt_status mt_hint_table_open(const char *path, mt_hint_table **table, mt_hint_error *error) {
    uint8_t *bytes;
    size_t length;
    mt_status status = mt_file_read(path, MT_HINT_FILE_MAX, &bytes, &length);
    if (status != MT_OK) return status;
    status = mt_hint_table_read((const char *)bytes, length, table, error);
    mt_free(bytes);
    return status;
}

void mt_hint_table_free(mt_hint_table *table) {
    if (!table) return;
    mt_free(table->lines);
    mt_free(table->text);
    mt_free(table);
}

bool mt_hint_table_next_char(const mt_hint_table *table, uint32_t from, uint32_t *code_point) {
    int low = 0, high = table->character_count;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (table->lines[middle].code_point < from)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == table->character_count) return false;
    *code_point = table->lines[low].code_point;
    return true;
}
