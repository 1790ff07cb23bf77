/* Names that a font keeps for itself, and whether another name has one in it. */
#pragma once

#include "base/memory.h"
#include "source/font.h"

enum { MT_RESERVED_MAX = 16 };

typedef struct mt_reserved {
    int count;
    const char *names[MT_RESERVED_MAX];
} mt_reserved;

/* The font's family, and the names that its copyright or licence reserves: "… with Reserved Font Name Foo" of the SIL Open
 * Font License, and "… names not containing either the words "Foo" or the word "Bar"" of the Bitstream Vera licence. Those
 * over MT_RESERVED_MAX are passed over. The names belong to the arena or the font. MT_NO_MEMORY. */
mt_status mt_reserved_find(const mt_font *font, mt_arena *arena, mt_reserved *reserved);

/* Whether a name has another one in it as whole words, whatever their case and whatever stands between them. */
bool mt_name_holds(const char *name, const char *words);

/* The first of the reserved names that the name has in it; NULL when it has none. */
const char *mt_reserved_in(const mt_reserved *reserved, const char *name);

/* Where a text has a phrase of lower-case letters and spaces, whatever the text's case; NULL when it has not. */
const char *mt_find_phrase(const char *text, const char *phrase);
