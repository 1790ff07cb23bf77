/* WOFF2, by Google's libwoff2 (WOFF File Format 2.0, W3C). */
#pragma once

#include "morphotype.h"

/* A font of any sfnt flavour compressed, into bytes for mt_bytes_free. Outlines come out of it as they were, though the
 * bytes of 'glyf' may differ. MT_TOO_LARGE for what the format cannot hold, MT_NO_MEMORY. */
mt_status mt_woff2_pack(const uint8_t *font, size_t length, uint8_t **bytes, size_t *packed);

/* The most bytes of a font out of a WOFF2, as its directory declares them and as they come: ten times the largest CJK
 * fonts. */
enum { MT_WOFF2_FONT_MAX = 1 << 28 };

/* Whether the bytes begin as a WOFF2 does. */
bool mt_woff2_is(const uint8_t *bytes, size_t length);

/* The font, or the collection, in a WOFF2, for mt_free. MT_NOT_A_FONT, MT_TOO_LARGE, MT_NO_MEMORY. */
mt_status mt_woff2_unpack(const uint8_t *bytes, size_t length, uint8_t **font, size_t *font_length);
