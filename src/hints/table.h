/* A file of hints, read: places in the fonts' own units, by characters, or by names of glyphs. Its format, UTF-8:
 *
 *     # From a # at the start of a line, or after a blank, to the line's end is a comment.
 *     glyph a                        a character: itself, or U+0061
 *     glyph /a.sc                    a glyph of the first font by its name (glyphset/naming.h)
 *     component 120,300 140,310      a place in A, and the one in B whose component goes with A's
 *     point 100,700 90,680           a place on A's boundary, and the one on B's that goes with it
 *
 * Hints belong to the character or glyph before them. One that stands there again gets more of them. */
#pragma once

#include "morph/model/hints.h"
#include "morphotype.h"

/* Font units, 16.16. */
typedef struct mt_hint_place {
    int32_t x, y;
} mt_hint_place;

typedef struct mt_hint_line {
    uint32_t code_point; /* where there is no name */
    const char
        *name; /* of the glyph, without its slash; in the table's text. NULL: the hint is for a character */
    int name_line; /* where the name stands in the file */
    int line;      /* of the file; no two hints share one */
    mt_hint_kind kind;
    mt_hint_place a, b;
} mt_hint_line;

struct mt_hint_table {
    int count, room;
    mt_hint_line *lines; /* by character, then by line; then those by name, by line */
    int character_count; /* of lines for characters */
    char *text;          /* the file, cut up; it has the names */
};
