#include "base/lines.h"

#include <string.h>

mt_lines mt_lines_of(char *text, size_t length) {
    bool marked = strncmp(text, "\xef\xbb\xbf", 3) == 0;
    return (mt_lines){marked ? text + 3 : text, text + length, 0};
}

char *mt_lines_next(mt_lines *lines, bool *whole) {
    char *line = lines->at;
    if (line >= lines->end) return NULL;
    char *stop = line + strcspn(line, "\n");
    *whole = stop == lines->end || *stop != '\0';
    *stop = '\0';
    lines->at = stop + 1;
    lines->number++;
    return line;
}

static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

int mt_words_split(char *line, const char **words, int most) {
    int count = 0;
    for (char *at = line;;) {
        while (is_blank(*at)) at++;
        if (*at == '\0' || *at == '#') return count;
        if (count < most) words[count] = at;
        count++;
        while (*at && !is_blank(*at)) at++;
        if (*at) *at++ = '\0';
    }
}
