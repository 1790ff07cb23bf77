/* Text of a file, in lines and words that are read in place; it need not end with a NUL. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

typedef struct mt_words {
    const char *at, *end;
    int line; /* that the last one read was, from 1 */
} mt_words;

typedef struct mt_word {
    const char *start;
    size_t length;
} mt_word;

mt_words mt_words_of(const void *bytes, size_t length);

/* The next line, without its end, as words; false after the last. LF, CR and CR LF end a line. */
bool mt_words_line(mt_words *text, mt_words *line);

/* The next word between blanks, line ends among them; false after the last. */
bool mt_words_next(mt_words *words, mt_word *word);

bool mt_word_is(mt_word word, const char *text);
/* False for a word that is anything but a finite number. */
bool mt_word_number(mt_word word, double *number);
/* False for a word that is anything but a whole number within ±2^31. */
bool mt_word_whole(mt_word word, long *number);
