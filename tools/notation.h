/* Texts in which glyphs stand by their names, as in font editors:
 *
 *     /a.sc /f_i/uni0644.init     a slash and a name at the start, after a blank or after another name. The name ends before a blank
 *                                 or the next slash; one blank after it belongs to it
 *     n/a.sc                      after a character too where the name has a . or _ inside and the first font has the glyph; without,
 *                                 characters: km/h, and/or, https://a.org
 *     //a.sc                      where a name could stand: a slash and the characters a.sc
 *     / a, a/                     a slash that no name follows is a slash
 *
 * So no text that has its slashes after other characters, as texts have, reads otherwise than it stands there. */
#pragma once

#include "blend/choice.h"
#include "glyphset/naming.h"

typedef struct notation {
    mt_font *font;     /* the first */
    mt_naming *naming; /* of it; NULL until a name is looked for */
    bool after_word;   /* a character that is no blank stands before; at first none does */
} notation;

void notation_close(notation *reader);

enum { NOTATION_NAME_MAX = 255 };

/* Reads the character or glyph at *at, which is not the text's end, and moves past it; `name` has a glyph's name. MT_NO_GLYPH where
 * there has to be a glyph of that name and the font has none; MT_BAD_PARAMETER for what is no UTF-8; otherwise as
 * mt_naming_open and mt_naming_find. */
mt_status notation_next(notation *reader, const char **at, mt_choice *choice,
                        char name[NOTATION_NAME_MAX + 1]);
