/* Hints by pointing: a glyph of two fonts as a page shows it, both drawings side by side, what goes with what, and what is between
 * them; a place on each, pointed at, makes a hint. The page of an inspection and that of a report have it.
 *
 *     glyph.c           a glyph as the pages' script reads it
 *     idle_hints.c      hints that change nothing
 *     page/editor.js    the script, and page/editor.css its style: both sides, and hints by clicks
 */
#pragma once

#include "base/json.h"
#include "blend/pair.h"

typedef struct mt_pointed_glyph {
    const char *label;   /* as a file of hints names it after "glyph": U+0041 or /NAME */
    uint32_t code_point; /* of a label that is a character's; 0 for a name */
    uint32_t a, b;       /* the glyphs in the first two fonts */
    const mt_glyph_pair *pair;
    const bool *idle; /* of each hint: it changes nothing (pointing/idle_hints.h); NULL: not known */
} mt_pointed_glyph;

/* Adds a prepared glyph of the row's first two fonts as an object:
 *
 *     {
 *       "name": "k", "label": "U+006B",
 *       "a": SIDE, "b": SIDE,
 *       "moving": [{"a": CONTOUR, "b": CONTOUR, "by": [0, 0]}, …],  every point moves straight from a's to b's, moved by "by" half-way
 *       "turn": {"degrees": 0, "a": [250, 350], "b": [260, 340]},    formula (5): what has moved is turned about what is between the middles
 *       "hints": [{"kind": "point", "a": [100, 700], "b": [90, 680], "idle": false}, …]
 *     }
 *
 * A SIDE is {"units": 1000, "advance": 520, "components": 1, "drawing": [CONTOUR, …]}, and a CONTOUR an array of segments, each an
 * array of its controls and its end, x and y in turn; the first starts where the last ends. Drawings and hints are in their font's units,
 * what moves in thousandths of the em. Takes the row's lock. MT_NO_MEMORY, MT_TOO_LARGE, and what mt_font_outline gives. */
mt_status mt_pointing_add_glyph(mt_json *json, mt_row *row, const mt_pointed_glyph *glyph, mt_arena *arena);

/* Adds the names of the row's first two fonts as an object, for the page's script: {"a": NAME, "b": NAME}. */
void mt_pointing_add_names(mt_json *json, const char *key, const mt_row *row);
/* Adds a page's title, in an element of text: both families' names. MT_NO_MEMORY. */
mt_status mt_pointing_add_title(mt_buffer *text, const mt_row *row);
