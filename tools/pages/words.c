#include "pages.h"

#include "base/memory.h"

#include <stdio.h>
#include <string.h>

bool argument_is_file(const option_row *row) {
    return row->argument && strcmp(row->argument, "FILE") == 0;
}

static void add(char *words, const char *word, size_t length) {
    if (*words) strcat(words, " ");
    strncat(words, word, length);
}

/* Of alternatives such as DEGREES|auto, those in small letters stand for themselves. */
char *argument_words(const option_row *row) {
    const char *argument = row->argument ? row->argument : "", *more = row->words ? row->words : "";
    char *words = mt_new(strlen(argument) + strlen(more) + 2, 1);
    if (!words) return NULL;
    for (const char *at = argument; *at;) {
        size_t length = strcspn(at, "|");
        if (strspn(at, "abcdefghijklmnopqrstuvwxyz-") == length) add(words, at, length);
        at += length + (at[length] == '|');
    }
    if (*more) add(words, more, strlen(more));
    return words;
}

void print_escaped(const char *text, const char *special) {
    for (; *text; text++) {
        if (strchr(special, *text)) putchar('\\');
        putchar(*text);
    }
}

void print_joined(const char *words, const char *between) {
    for (; *words; words++)
        if (*words == ' ')
            fputs(between, stdout);
        else
            putchar(*words);
}
