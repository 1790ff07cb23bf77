/* The Debian fonts that tests read: fonts-dejavu-core, fonts-wqy-zenhei, fonts-arphic-ukai. */
#pragma once

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
