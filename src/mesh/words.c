#include "mesh/words.h"

#include <string.h>

#include "base/real.h"

/* Longer words are no numbers. */
enum { NUMBER_ROOM = 128 };

static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

mt_words mt_words_of(const void *bytes, size_t length) {
    const char *text = bytes;
    return (mt_words){text, text + length, 0};
}

bool mt_words_line(mt_words *text, mt_words *line) {
    const char *p = text->at;
    if (p == text->end) return false;
    while (p < text->end && *p != '\n' && *p != '\r') p++;
    *line = (mt_words){text->at, p, ++text->line};
    if (p < text->end) p += *p == '\r' && p + 1 < text->end && p[1] == '\n' ? 2 : 1;
    text->at = p;
    return true;
}

bool mt_words_next(mt_words *words, mt_word *word) {
    const char *p = words->at;
    while (p < words->end && is_blank(*p)) words->line += *p++ == '\n';
    const char *start = p;
    while (p < words->end && !is_blank(*p)) p++;
    words->at = p;
    *word = (mt_word){start, (size_t)(p - start)};
    return p > start;
}

bool mt_word_is(mt_word word, const char *text) {
    return strlen(text) == word.length && memcmp(word.start, text, word.length) == 0;
}

/* The word with a NUL behind it; false where it has no room. */
static bool copy(mt_word word, char text[NUMBER_ROOM]) {
    if (word.length >= NUMBER_ROOM) return false;
    memcpy(text, word.start, word.length);
    text[word.length] = '\0';
    return strlen(text) == word.length;
}

bool mt_word_number(mt_word word, double *number) {
    char text[NUMBER_ROOM];
    const char *at = text;
    return copy(word, text) && mt_real_next(&at, number) && *at == '\0';
}

bool mt_word_whole(mt_word word, long *number) {
    char text[NUMBER_ROOM];
    const char *at = text;
    long value = 0;
    if (!copy(word, text)) return false;
    bool negative = *at == '-';
    if (*at == '-' || *at == '+') at++;
    if (!*at) return false;
    for (; *at >= '0' && *at <= '9'; at++) {
        value = 10 * value + (*at - '0');
        if (value > (1L << 31) - 1) return false;
    }
    *number = negative ? -value : value;
    return *at == '\0';
}
