/* WOFF2, by Google's libwoff2 (WOFF File Format 2.0, W3C). */
#pragma once

#include "morphotype.h"

/* A font of any sfnt flavour compressed, into bytes for mt_bytes_free. Outlines come out of it as they were, though the
 * bytes of 'glyf' may differ. MT_TOO_LARGE for what the format cannot hold, MT_NO_MEMORY. */
mt_status mt_woff2_pack(const uint8_t *font, size_t length, uint8_t **bytes, size_t *packed);
