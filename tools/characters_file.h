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

/* Adds them to the set; `font` is the spec of the reader's font. On failure says why, with the file's name and line, and returns COULD_NOT; otherwise
 * DONE. */
int characters_add_file(characters *set, const char *path, notation *reader, const char *font);
