#include "write/style.h"

#include <string.h>
#include <strings.h>

/* ---- words --------------------------------------------------------------------------------------------- */

typedef struct mt_style_word {
    const char *word;
    int value;
} mt_style_word;

static const mt_style_word weights[] = {
    {"thin", 100},       {"hairline", 100},   {"extralight", 200}, {"ultralight", 200}, {"light", 300},
    {"semilight", 350},  {"demilight", 350},  {"regular", 400},    {"normal", 400},     {"book", 400},
    {"roman", 400},      {"medium", 500},     {"semibold", 600},   {"demibold", 600},   {"demi", 600},
    {"bold", 700},       {"extrabold", 800},  {"ultrabold", 800},  {"heavy", 800},      {"black", 900},
    {"extrablack", 950}, {"ultrablack", 950},
};

static const mt_style_word widths[] = {
    {"ultracondensed", 1}, {"extracondensed", 2}, {"condensed", 3}, {"narrow", 3},
    {"semicondensed", 4},  {"semiexpanded", 6},   {"expanded", 7},  {"wide", 7},
    {"extraexpanded", 8},  {"ultraexpanded", 9},
};

static const mt_style_word slopes[] = {{"italic", 1}, {"oblique", 1}, {"slanted", 1}, {"inclined", 1}};

static const mt_style_word prefixes[] = {{"semi", 1}, {"demi", 1}, {"extra", 1}, {"ultra", 1}};

#define FIND(words, word) find(words, sizeof(words) / sizeof *(words), word)

/* The value of a word, 0 where it is none of them. */
static int find(const mt_style_word *words, size_t count, const char *word) {
    for (size_t i = 0; i < count; i++)
        if (strcasecmp(words[i].word, word) == 0) return words[i].value;
    return 0;
}

enum { WORD_ROOM = 32 };

static size_t skip_blanks(const char *name, size_t at) {
    return at + strspn(name + at, " -");
}

/* Reads a word from `at` on; gives where it ends. A word with no room is none that is known. */
static size_t read_word(const char *name, size_t at, char word[WORD_ROOM]) {
    size_t length = strcspn(name + at, " -");
    *word = '\0';
    if (length < WORD_ROOM) strncat(word, name + at, length);
    return at + length;
}

/* Reads a word, with a prefix that stands by itself before it; gives where it ends. */
static size_t read_whole_word(const char *name, size_t at, char word[WORD_ROOM]) {
    char next[WORD_ROOM];
    size_t end = read_word(name, at, word), from = skip_blanks(name, end);
    if (!FIND(prefixes, word) || !name[from]) return end;
    size_t next_end = read_word(name, from, next);
    if (strlen(word) + strlen(next) >= WORD_ROOM) return end;
    strcat(word, next);
    if (FIND(weights, word) || FIND(widths, word)) return next_end;
    return read_word(name, at, word);
}

/* ---- styles -------------------------------------------------------------------------------------------- */

/* A word that links: Regular and its like, Bold, or a slope. */
static bool links(const char *word) {
    int weight = FIND(weights, word);
    return weight == 400 || weight == 700 || FIND(slopes, word);
}

mt_style mt_style_read(const char *name) {
    mt_style style = {0};
    char word[WORD_ROOM];
    size_t end;
    for (size_t at = skip_blanks(name, 0); name[at]; at = skip_blanks(name, end)) {
        end = read_whole_word(name, at, word);
        int weight = FIND(weights, word), width = FIND(widths, word);
        bool slope = FIND(slopes, word) != 0;
        if (weight) style.weight = weight;
        if (width) style.width = width;
        style.italic |= slope;
        style.is_linked |= weight || slope;
        if (!links(word)) style.own = end;
    }
    style.bold = style.weight == 700;
    if (!style.weight && (style.width || style.italic)) style.weight = 400;
    return style;
}

void mt_style_drop_slope(const char *name, char *upright) {
    char word[WORD_ROOM];
    size_t end, length = 0;
    for (size_t at = skip_blanks(name, 0); name[at]; at = skip_blanks(name, end)) {
        end = read_word(name, at, word);
        if (FIND(slopes, word)) continue;
        if (length) upright[length++] = ' ';
        memcpy(upright + length, name + at, end - at);
        length += end - at;
    }
    upright[length] = '\0';
}
