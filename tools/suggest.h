/* Did you mean …? */
#pragma once

/* The nearest of all words that were offered so far. */
typedef struct suggestion {
    const char *wanted;
    const char *word; /* NULL: none is near */
    int distance;     /* of the word; all that is as far or farther is no suggestion */
} suggestion;

suggestion suggest_for(const char *wanted);
/* Offers a word, which is kept. Of equally near ones the first is kept. */
void suggest(suggestion *nearest, const char *word);

/* How many bytes have to be put in, taken out or replaced, or neighbours swapped, to make the one of the other: the
 * distance of optimal string alignment. Words of over SUGGEST_MOST bytes are infinitely far. */
enum { SUGGEST_MOST = 32, SUGGEST_FAR = 1000 };
int word_distance(const char *a, const char *b);

/* "; did you mean WORD?", or "" where none is near. `prefix` stands before the word. */
enum { SUGGEST_ROOM = 64 };
const char *suggest_text(const suggestion *nearest, const char *prefix, char text[SUGGEST_ROOM]);
