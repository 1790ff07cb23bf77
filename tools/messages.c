#include "messages.h"

#include "base/utf.h"

#include <stdarg.h>
#include <stdio.h>

#define LINE_MAX_BYTES 16384

/* Puts a question mark for each control character and for each byte that is no UTF-8: names of files and of glyphs hold any. */
static void make_printable(char *line) {
    for (char *at = line; *at;) {
        const char *next = at;
        uint32_t code_point;
        bool good = mt_utf8_next(&next, &code_point);
        bool is_control = good && (code_point < ' ' || (code_point >= 0x7f && code_point < 0xa0));
        char *end = good ? at + (next - at) : at + 1;
        for (char *p = at; (!good || is_control) && p < end; p++) *p = '?';
        at = end;
    }
}

static void say_line(const char *format, va_list list, const char *end) {
    char line[LINE_MAX_BYTES];
    vsnprintf(line, sizeof line, format, list);
    make_printable(line);
    fprintf(stderr, "morphotype: %s%s\n", line, end);
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
