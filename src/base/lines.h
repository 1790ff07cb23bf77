/* A text that a person wrote, such as hints: cut into lines and words in place. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

typedef struct mt_lines {
    char *at;
    const char *end;
    int number; /* of the line at hand, from 1 */
} mt_lines;

/* Of a text that ends with a NUL at `length`. A byte order mark is passed over. */
mt_lines mt_lines_of(char *text, size_t length);

/* The next line, without its end; NULL after the last. *whole is false for one that a NUL cuts short. */
char *mt_lines_next(mt_lines *lines, bool *whole);

/* Cuts a line into words, up to one that begins with #; how many, of which `words` holds the first `most`. */
int mt_words_split(char *line, const char **words, int most);
