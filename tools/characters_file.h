/* A file of characters, UTF-8:
 *
 *     # From a # at the start of a line, or after a blank, to the line's end is a comment.
 *     abc é              characters stand for themselves; blanks part them
 *     U+5F62 U+6C38      code points
 *     U+4E00-4E2F        ranges, both ends included; U+4E00-U+4E2F too
 *     /a.sc /f_i         glyphs by their names, as in texts (notation.h)
 *
 * U+0023 is a # and U+0020 a space. */
#pragma once

#include "characters.h"
#include "notation.h"

/* Where lines stand. */
typedef struct characters_source {
    notation *reader;
    const char *font, *path; /* the spec of the reader's font; the file */
} characters_source;

/* Adds what stands on one line, counted from 1. DONE or, said with the file and the line, COULD_NOT. */
int characters_add_line(characters *set, const characters_source *source, int number, const char *line);

/* Reads a text that a person wrote, and hands on each line, which may be cut, until one gives other than DONE. That or, said with the file,
 * COULD_NOT. */
typedef int (*text_line)(char *line, int number, void *user);
int text_file_read(const char *path, text_line call, void *user);

/* Adds them to the set; `font` is the spec of the reader's font. On failure says why, with the file's name and line, and returns COULD_NOT; otherwise
 * DONE. */
int characters_add_file(characters *set, const char *path, notation *reader, const char *font);
