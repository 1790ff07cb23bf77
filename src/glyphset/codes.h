/* The characters of a new font. */
#pragma once

#include "base/memory.h"
#include "source/font.h"
#include "source/given_pairs.h"

/* A character and its glyph in each font, in B the one that is given for A's; 0 where a font has none. */
typedef struct mt_code {
    uint32_t code_point, a, b;
} mt_code;

typedef struct mt_codes {
    int count;
    mt_code *list; /* ascending */
} mt_codes;

typedef struct mt_charset_request {
    const uint32_t *wanted; /* only these code points, in any order, and their forms */
    int count;
    mt_glyph_set set;
    bool alternates; /* of wanted code points, also the forms that text has to ask for */
    const uint32_t *
        glyphs; /* only these glyphs of A's, in any order, with the characters that lead to them, and their forms */
    int glyph_count;
    const mt_given_pairs *pairs; /* NULL: none */
    int other;                   /* B's number among the fonts of the pairs */
    bool
        varies; /* the new font is to: parts of assemblies that differ in length stay the first font's (match.h) */
} mt_charset_request; /* neither characters nor glyphs: all */

/* Whether it is for some characters or glyphs, not for all. */
static inline bool mt_request_is_limited(const mt_charset_request *request) {
    return request->count > 0 || request->glyph_count > 0;
}

/* The characters of both fonts, or of A, all or those wanted or leading to wanted glyphs; and those of A that HarfBuzz takes them apart into, also where B
 * has them not. Of wanted ones also those of the set that HarfBuzz puts together of two of them. MT_NO_MEMORY. */
mt_status mt_codes_list(const mt_font *a, const mt_font *b, const mt_charset_request *request,
                        mt_arena *arena, mt_codes *codes);

void mt_codes_sort(mt_code *list, int count);
/* NULL for a character that is not in the list. */
const mt_code *mt_codes_find(const mt_codes *codes, uint32_t code_point);
