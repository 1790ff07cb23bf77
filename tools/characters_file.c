#include "characters_file.h"

#include "base/file.h"
#include "base/memory.h"
#include "base/utf.h"
#include "messages.h"

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

static const char *add_range(characters *set, const char **at) {
    uint32_t first, last;
    if (!read_range(at, &first, &last)) return "a code point is written U+4E00, a range U+4E00-4E2F";
    if (last < first) return "the range runs backwards";
    if (last > 0x10ffff) return "the last code point is U+10FFFF";
    for (uint32_t c = first; c <= last; c++) {
        bool surrogate = c >= 0xd800 && c <= 0xdfff;
        if (!surrogate && characters_add(set, c) != MT_OK) return mt_status_text(MT_NO_MEMORY);
    }
    return NULL;
}

static const char *add_character(characters *set, const char **at) {
    uint32_t code_point;
    if (!mt_utf8_next(at, &code_point)) return "not UTF-8";
    return characters_add(set, code_point) == MT_OK ? NULL : mt_status_text(MT_NO_MEMORY);
}

/* Adds what stands on one line; what is wrong with it, or NULL. */
static const char *add_line(characters *set, const char *line) {
    const char *problem = NULL;
    bool after_blank = true;
    for (const char *at = line; *at && !problem;) {
        if (after_blank && *at == '#') break;
        if (is_blank(*at))
            after_blank = true, at++;
        else if (after_blank && starts_code_point(at))
            problem = add_range(set, &at);
        else
            after_blank = false, problem = add_character(set, &at);
    }
    return problem;
}

/* `text` is cut into lines in place. */
static int add_lines(characters *set, const char *path, char *text, const char *end) {
    int number = 1;
    if (strncmp(text, "\xef\xbb\xbf", 3) == 0) text += 3; /* a byte order mark */
    for (char *next; text < end; text = next, number++) {
        char *stop = text + strcspn(text, "\n");
        if (stop < end && *stop == '\0') return fail("%s:%d: not UTF-8 text", path, number);
        next = stop + 1;
        *stop = '\0';
        const char *problem = add_line(set, text);
        if (problem) return fail("%s:%d: %s", path, number, problem);
    }
    return DONE;
}

int characters_add_file(characters *set, const char *path) {
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
    int outcome = add_lines(set, path, text, text + length);
    mt_free(text);
    return outcome;
}
