/* A font with nothing in it but advances and GPOS: for the tests of layout. */
#ifndef MT_TEST_GPOS_H
#define MT_TEST_GPOS_H

#include "font/charset.h"
#include "layout/made.h"

/* A font of blank glyphs for the characters of the charset, with this GPOS and with GDEF classes, one for
 * each glyph. */
mt_bytes mt_test_layout_font(const mt_charset *charset, int units, const uint16_t *advances,
                             const uint16_t *classes, mt_bytes gpos, mt_arena *arena);

#endif
