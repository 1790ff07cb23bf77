/* A font with nothing in it but advances and GPOS: for the tests of layout. */
#pragma once

#include "glyphset/charset.h"
#include "layout/lookup_builder.h"

/* A GDEF table of nothing but classes, one for each glyph. */
mt_bytes mt_test_gdef(const uint16_t *classes, int count, mt_arena *arena);

/* What makes a font vary: empty tables where it does not. */
typedef struct mt_test_varying {
    mt_bytes fvar, hvar;
} mt_test_varying;

/* A font of blank glyphs for the characters of the charset, with these tables. */
mt_bytes mt_test_layout_font(const mt_charset *charset, int units, const uint16_t *advances, mt_bytes gdef,
                             mt_bytes gpos, mt_test_varying varying, mt_arena *arena);
