/* Which characters and glyphs a blend has. */
#ifndef MT_CHARSET_H
#define MT_CHARSET_H

#include "font/write.h"

/* B's glyph where B has none. */
#define MT_NO_PARTNER UINT32_MAX

/* A glyph of the new font: the glyphs of the two sources that it lies between. */
typedef struct mt_pairing {
    uint32_t code_point; /* the first that leads here; 0 for .notdef */
    uint32_t a, b;       /* b is MT_NO_PARTNER for a glyph of A's that stays as it is */
} mt_pairing;

typedef struct mt_charset {
    int glyph_count; /* glyph 0 is .notdef */
    mt_pairing *glyphs;
    int char_count;
    mt_char *chars; /* ascending */
} mt_charset;

/* Pairs the glyphs of the characters that both fonts map. Characters that lead to the same two glyphs share
 * one. With `wanted`, only those of its `count` code points, in any order. MT_NOTHING_SHARED, MT_TOO_LARGE
 * for more glyphs than a font can hold, MT_NO_MEMORY. */
mt_status mt_charset_make(const mt_font *a, const mt_font *b, const uint32_t *wanted, int count,
                          mt_arena *arena, mt_charset *charset);

#endif
