/* A file of hints, read: places in the fonts' own units, by characters. Its format, UTF-8:
 *
 *     # From a # at the start of a line, or after a blank, to the line's end is a comment.
 *     glyph a                        a character: itself, or U+0061
 *     component 120,300 140,310      a place in A, and the one in B whose component goes with A's
 *     point 100,700 90,680           a place on A's boundary, and the one on B's that goes with it
 *
 * Hints belong to the character before them. One that stands there again gets more of them. */
#pragma once

#include "morph/model/hints.h"
#include "morphotype.h"

/* Font units, 16.16. */
typedef struct mt_hint_place {
    int32_t x, y;
} mt_hint_place;

typedef struct mt_hint_line {
    uint32_t code_point;
    int line; /* of the file; no two hints share one */
    mt_hint_kind kind;
    mt_hint_place a, b;
} mt_hint_line;

struct mt_hint_table {
    int count, room;
    mt_hint_line *lines; /* by character, then by line */
};
