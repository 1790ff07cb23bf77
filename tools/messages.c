#include "messages.h"

#include <stdarg.h>
#include <stdio.h>

#define LINE_MAX_BYTES 16384

static void say_line(const char *format, va_list list, const char *end) {
    char line[LINE_MAX_BYTES];
    vsnprintf(line, sizeof line, format, list);
    for (char *p = line; *p; p++)
        if ((unsigned char)*p < ' ' || *p == 0x7f) *p = '?';
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
