#include "messages.h"

#include "base/utf.h"
#include "characters.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define LINE_MAX_BYTES 16384

/* Copies a line: what cannot be seen as <U+200D>, a byte that is no UTF-8 as <0xFF>, since names of files and of glyphs hold any. What
 * no longer fits is left out. */
static void make_printable(const char *line, char *text, size_t room) {
    size_t used = 0;
    for (const char *at = line; *at;) {
        char one[16] = "";
        const char *next = at;
        uint32_t code_point;
        bool good = mt_utf8_next(&next, &code_point);
        if (!good) {
            snprintf(one, sizeof one, "<0x%02X>", (unsigned char)*at);
            next = at + 1;
        } else if (character_is_seen(code_point))
            strncat(one, at, (size_t)(next - at));
        else
            snprintf(one, sizeof one, "<U+%04lX>", (unsigned long)code_point);
        size_t length = strlen(one);
        if (used + length >= room) break;
        memcpy(text + used, one, length);
        used += length;
        at = next;
    }
    text[used] = '\0';
}

static void say_line(const char *format, va_list list, const char *end) {
    char line[LINE_MAX_BYTES], text[LINE_MAX_BYTES];
    vsnprintf(line, sizeof line, format, list);
    make_printable(line, text, sizeof text);
    fprintf(stderr, "morphotype: %s%s\n", text, end);
}

void say(const char *format, ...) {
    va_list list;
    va_start(list, format);
    say_line(format, list, "");
    va_end(list);
}

int fail(const char *format, ...) {
    va_list list;
    va_start(list, format);
    say_line(format, list, "");
    va_end(list);
    return COULD_NOT;
}

int misuse(const char *command, const char *format, ...) {
    char pointer[64];
    va_list list;
    snprintf(pointer, sizeof pointer, " (try: morphotype %s%s--help)", command ? command : "",
             command ? " " : "");
    va_start(list, format);
    say_line(format, list, pointer);
    va_end(list);
    return WRONG_USAGE;
}
