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

/* A file that is being read. */
typedef struct file_reading {
    characters *set;
    notation *reader;
    const char *font, *path;
    int line; /* from 1 */
} file_reading;

static int fail_line(const file_reading *file, const char *problem) {
    return fail("%s:%d: %s", file->path, file->line, problem);
}

static int add_range(const file_reading *file, const char **at) {
    uint32_t first, last;
    if (!read_range(at, &first, &last))
        return fail_line(file, "a code point is written U+4E00, a range U+4E00-4E2F");
    if (last < first) return fail_line(file, "the range runs backwards");
    if (last > 0x10ffff) return fail_line(file, "the last code point is U+10FFFF");
    for (uint32_t c = first; c <= last; c++) {
        bool surrogate = c >= 0xd800 && c <= 0xdfff;
        if (!surrogate && characters_add(file->set, c) != MT_OK)
            return fail_line(file, mt_status_text(MT_NO_MEMORY));
    }
    return DONE;
}

static int add_choice(const file_reading *file, const char **at) {
    mt_choice choice;
    char name[NOTATION_NAME_MAX + 1];
    mt_status status = notation_next(file->reader, at, &choice, name);
    if (status == MT_OK) status = characters_add_choice(file->set, &choice);
    if (status == MT_NO_GLYPH)
        return fail("%s:%d: %s has no glyph /%s", file->path, file->line, file->font, name);
    if (status == MT_BAD_PARAMETER) return fail_line(file, "not UTF-8");
    return status == MT_OK ? DONE : fail_status(file->font, status);
}

/* Adds what stands on one line. */
static int add_line(const file_reading *file, const char *line) {
    int outcome = DONE;
    bool after_blank = true;
    file->reader->after_word = false;
    for (const char *at = line; *at && outcome == DONE;) {
        if (after_blank && *at == '#') break;
        if (is_blank(*at)) {
            after_blank = true, at++;
            file->reader->after_word = false;
        } else if (after_blank && starts_code_point(at)) {
            outcome = add_range(file, &at);
        } else {
            outcome = add_choice(file, &at);
            after_blank = !file->reader->after_word;
        }
    }
    return outcome;
}

/* `text` is cut into lines in place. */
static int add_lines(file_reading *file, char *text, size_t length) {
    mt_lines lines = mt_lines_of(text, length);
    int outcome = DONE;
    bool whole;
    for (char *line; outcome == DONE && (line = mt_lines_next(&lines, &whole));) {
        file->line = lines.number;
        outcome = whole ? add_line(file, line) : fail_line(file, "not UTF-8 text");
    }
    return outcome;
}

int characters_add_file(characters *set, const char *path, notation *reader, const char *font) {
    file_reading file = {.set = set, .reader = reader, .font = font, .path = path};
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
    int outcome = add_lines(&file, text, length);
    mt_free(text);
    return outcome;
}
