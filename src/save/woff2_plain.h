/* WOFF2 with every table as it is. */
#pragma once

#include "morphotype.h"

/* A font compressed without the transformations of 'glyf' and 'loca', into bytes for mt_bytes_free: libwoff2 1.0.2, the last
 * release, drops the flags of contours that overlap, even where it does not transform. The font is one that
 * mt_font_write made. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_woff2_pack_plain(const uint8_t *font, size_t length, uint8_t **bytes, size_t *packed);
