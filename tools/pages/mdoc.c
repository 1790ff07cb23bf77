#include "pages.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#define LINE 76 /* bytes; mandoc takes 80 for long */

/* Whether a hyphen in the word is a minus that is typed, and no hyphen of English. */
static bool is_typed(const char *word, size_t length) {
    for (size_t i = 0; i < length; i++)
        if (isdigit((unsigned char)word[i]) || isupper((unsigned char)word[i])) return true;
    return *word == '-';
}

/* How many bytes. */
static int put(const char *word, size_t length, bool typed) {
    int put = 0;
    for (size_t i = 0; i < length; i++)
        if (word[i] == '\\')
            put += printf("\\e");
        else if (word[i] == '-' && typed)
            put += printf("\\-");
        else
            put += printf("%c", word[i]);
    return put;
}

static bool is_option(const char *word, size_t length) {
    return length > 1 && word[0] == '-' && (word[1] == '-' || islower((unsigned char)word[1]));
}

/* The word without the punctuation at its end. */
static size_t bare_length(const char *word, size_t length) {
    while (length > 1 && strchr(".,;:)", word[length - 1])) length--;
    return length;
}

/* .Fl of an option, with the punctuation that follows it. */
static void put_option(const char *word, size_t length) {
    size_t bare = bare_length(word, length);
    printf(".Fl ");
    put(word + 1, bare - 1, true);
    for (size_t i = bare; i < length; i++) printf(" %c", word[i]);
    putchar('\n');
}

/* A full stop, but no three of them. */
static bool ends_sentence(const char *word, size_t length) {
    return word[length - 1] == '.' && !(length > 1 && word[length - 2] == '.');
}

void mdoc_text(const char *text, size_t length) {
    int column = 0;
    for (size_t at = 0, word; at < length; at += word + 1) {
        word = strcspn(text + at, " ");
        if (word > length - at) word = length - at;
        const char *start = text + at;
        if (column > 0 && (column + (int)word > LINE || is_option(start, word))) {
            putchar('\n');
            column = 0;
        }
        if (is_option(start, word)) {
            put_option(start, word);
            continue;
        }
        if (column > 0) column += printf(" ");
        if (column == 0 && (*start == '.' || *start == '\'')) column += printf("\\&");
        column += put(start, word, is_typed(start, word));
        if (!ends_sentence(start, word)) continue;
        putchar('\n');
        column = 0;
    }
    if (column > 0) putchar('\n');
}

void mdoc_paragraphs(const char *text) {
    for (const char *at = text; *at;) {
        size_t length = strcspn(at, "\n");
        if (at > text) puts(".Pp");
        mdoc_text(at, length);
        at += length + (at[length] == '\n');
    }
}

void mdoc_literal(const char *text, size_t length) {
    put(text, length, true);
}

/* ---- the synopsis ------------------------------------------------------------------------------------------ */

/* Bytes up to a blank that stands in no brackets. */
static size_t item_length(const char *text) {
    int depth = 0;
    for (size_t i = 0;; i++) {
        depth += text[i] == '[';
        depth -= text[i] == ']';
        if (text[i] == '\0' || (text[i] == ' ' && depth == 0)) return i;
    }
}

static void put_words(const char *text, size_t length) {
    for (size_t at = 0, word; at < length; at += word + 1) {
        word = strcspn(text + at, " ");
        if (word > length - at) word = length - at;
        const char *start = text + at;
        bool option = is_option(start, word), bar = word == 1 && *start == '|';
        printf("%s", at ? " " : "");
        printf("%s", option ? "Fl " : bar ? "" : "Ar ");
        put(start + option, word - option, true);
    }
}

/* An item alone, or an option with its argument. */
void mdoc_synopsis(const char *synopsis) {
    for (const char *at = synopsis; *at;) {
        size_t length = item_length(at);
        bool optional = at[0] == '[' && at[length - 1] == ']';
        if (!optional && is_option(at, length) && at[length] == ' ')
            length += 1 + item_length(at + length + 1);
        printf(optional ? ".Op " : ".");
        put_words(at + optional, length - 2 * optional);
        putchar('\n');
        at += length + (at[length] == ' ');
    }
}
