#include "characters_file.h"

#include "base/file.h"
#include "base/lines.h"
#include "base/memory.h"
#include "messages.h"
#include "work.h"

#include <ctype.h>
#include <errno.h>
#include <string.h>

#define FILE_MAX ((size_t)1 << 24) /* bytes: every code point of Unicode, with room for comments */

static bool is_blank(char c) {
    return c == '\0' || c == ' ' || c == '\t' || c == '\r';
}

static bool starts_code_point(const char *at) {
    return (at[0] == 'U' || at[0] == 'u') && at[1] == '+' && isxdigit((unsigned char)at[2]);
}

/* Reads up to six hexadecimal digits and moves past them; false where there are none. */
static bool read_hex(const char **at, uint32_t *value) {
    static const char digits[] = "0123456789abcdef";
    int count = 0;
    for (*value = 0; count < 6 && isxdigit((unsigned char)**at); count++, (*at)++)
        *value = *value * 16 + (uint32_t)(strchr(digits, tolower((unsigned char)**at)) - digits);
    return count > 0;
}

/* Reads U+X, U+X-Y or U+X-U+Y up to the next blank or comma, and moves past it. */
static bool read_range(const char **at, uint32_t *first, uint32_t *last) {
    *at += 2;
    if (!read_hex(at, first)) return false;
    *last = *first;
    if (**at == '-') {
        (*at)++;
        if (starts_code_point(*at)) *at += 2;
        if (!read_hex(at, last)) return false;
    }
    if (**at == ',') return (*at)++, true;
    return is_blank(**at);
}

/* A line that is being read. */
typedef struct line_reading {
    characters *set;
    const characters_source *source;
    int line; /* from 1 */
} line_reading;

static int fail_line(const line_reading *at, const char *problem) {
    return fail("%s:%d: %s", at->source->path, at->line, problem);
}

static int add_range(const line_reading *reading, const char **at) {
    uint32_t first, last;
    if (!read_range(at, &first, &last))
        return fail_line(reading, "a code point is written U+4E00, a range U+4E00-4E2F");
    if (last < first) return fail_line(reading, "the range runs backwards");
    if (last > 0x10ffff) return fail_line(reading, "the last code point is U+10FFFF");
    for (uint32_t c = first; c <= last; c++) {
        bool surrogate = c >= 0xd800 && c <= 0xdfff;
        if (!surrogate && characters_add(reading->set, c) != MT_OK)
            return fail_line(reading, mt_status_text(MT_NO_MEMORY));
    }
    return DONE;
}

static int add_choice(const line_reading *reading, const char **at) {
    const characters_source *source = reading->source;
    mt_choice choice;
    char name[NOTATION_NAME_MAX + 1];
    mt_status status = notation_next(source->reader, at, &choice, name);
    if (status == MT_OK) status = characters_add_choice(reading->set, &choice);
    if (status == MT_NO_GLYPH)
        return fail("%s:%d: %s has no glyph /%s", source->path, reading->line, source->font, name);
    if (status == MT_BAD_PARAMETER) return fail_line(reading, "not UTF-8");
    return status == MT_OK ? DONE : fail_status(source->font, status);
}

int characters_add_line(characters *set, const characters_source *source, int number, const char *line) {
    const line_reading reading = {set, source, number};
    int outcome = DONE;
    bool after_blank = true;
    source->reader->after_word = false;
    for (const char *at = line; *at && outcome == DONE;) {
        if (after_blank && *at == '#') break;
        if (is_blank(*at)) {
            after_blank = true, at++;
            source->reader->after_word = false;
        } else if (after_blank && starts_code_point(at)) {
            outcome = add_range(&reading, &at);
        } else {
            outcome = add_choice(&reading, &at);
            after_blank = !source->reader->after_word;
        }
    }
    return outcome;
}

/* ---- files -------------------------------------------------------------------------------------- */

/* `text` is cut into lines in place. */
static int pass_lines(const char *path, char *text, size_t length, text_line call, void *user) {
    mt_lines lines = mt_lines_of(text, length);
    int outcome = DONE;
    bool whole;
    for (char *line; outcome == DONE && (line = mt_lines_next(&lines, &whole));)
        outcome =
            whole ? call(line, lines.number, user) : fail("%s:%d: %s", path, lines.number, "not UTF-8 text");
    return outcome;
}

int text_file_read(const char *path, text_line call, void *user) {
    uint8_t *bytes;
    size_t length;
    errno = 0;
    mt_status status = mt_file_read(path, FILE_MAX, &bytes, &length);
    if (status == MT_NO_FILE && errno) return fail("%s: %s", path, strerror(errno));
    if (status != MT_OK) return fail("%s: %s", path, mt_status_text(status));
    char *text = mt_grow(bytes, length + 1, 1);
    if (!text) {
        mt_free(bytes);
        return fail("%s: %s", path, mt_status_text(MT_NO_MEMORY));
    }
    text[length] = '\0';
    int outcome = pass_lines(path, text, length, call, user);
    mt_free(text);
    return outcome;
}

typedef struct file_reading {
    characters *set;
    characters_source source;
} file_reading;

/* A text_line. */
static int add_line(char *line, int number, void *user) {
    const file_reading *file = user;
    return characters_add_line(file->set, &file->source, number, line);
}

int characters_add_file(characters *set, const char *path, notation *reader, const char *font) {
    file_reading file = {set, {reader, font, path}};
    return text_file_read(path, add_line, &file);
}
