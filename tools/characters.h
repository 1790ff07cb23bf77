/* Sets of characters, and of glyphs by their names: of a text, of a file, of a font. */
#pragma once

#include "blend/choice.h"

/* Characters and glyphs in a row; it owns the glyphs' names. */
typedef struct choices {
    mt_choice *list;
    int count, room;
} choices; /* all zero is empty */

/* Adds one, with a copy of its name. MT_NO_MEMORY. */
mt_status choices_add(choices *row, const mt_choice *choice);
void choices_free(choices *row);

typedef struct characters {
    uint32_t *list; /* no two alike, in the order in which they were added */
    int count, room;
    uint8_t *seen;    /* a bit for each code point */
    uint32_t *glyphs; /* numbers of the named ones, no two alike */
    int glyph_count, glyph_room;
    uint8_t *seen_glyphs; /* a bit for each number */
    choices order;        /* all of both, in the order in which they were added */
} characters;             /* all zero is empty */

/* Adds one unless it is there already. MT_NO_MEMORY. */
mt_status characters_add(characters *set, uint32_t code_point);
/* The same of a character or a glyph. */
mt_status characters_add_choice(characters *set, const mt_choice *choice);
bool characters_have(const characters *set, uint32_t code_point);
void characters_free(characters *set);

/* Adds those of a font. */
mt_status characters_add_font(characters *set, const mt_font *font);

/* Writes "U+0041-005A, U+00C6" into `text`: ranges in order, as many as fit into `most`; with more of them,
 * how many follow stands at the end. Sorts the list. */
void characters_describe(characters *set, int most, char *text, size_t room);

/* character_name.c: writes “A” (U+0041), a mark on a dotted circle, and of what cannot be seen the code point alone or with
 * its name: U+200D ZERO WIDTH JOINER. */
enum { CHARACTER_NAME_ROOM = 64 };
void character_describe(uint32_t code_point, char *text, size_t room);
/* Whether a reader sees it as itself: no control, format or private use character, no variation selector, no blank but a space. */
bool character_is_seen(uint32_t code_point);
