/* The Debian fonts that tests read: fonts-dejavu-core, fonts-wqy-zenhei, fonts-arphic-ukai. */
#pragma once

#include "geometry/ring.h"
#include "source/font.h"

#define MT_TEST_SANS "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"
#define MT_TEST_SERIF "/usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf"
#define MT_TEST_HEI "/usr/share/fonts/truetype/wqy/wqy-zenhei.ttc"
#define MT_TEST_KAI "/usr/share/fonts/truetype/arphic/ukai.ttc"

/* Opens it. Where it is not installed, skips the test, or fails it if MORPHOTYPE_FONTS_REQUIRED is set. */
mt_font *mt_test_font(const char *path);

/* Code points of letters, digits and signs (Latin, some Greek and Cyrillic), and of common Han characters. */
extern const uint32_t mt_test_latin[];
extern const int mt_test_latin_count;
extern const uint32_t mt_test_han[];
extern const int mt_test_han_count;

/* The ink of a character's glyph, as a blend reads it. As mt_font_outline and mt_outline_shape. */
mt_status mt_test_glyph_shape(mt_font *font, uint32_t code_point, double tolerance, mt_arena *arena,
                              mt_shape *shape);
