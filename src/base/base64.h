/* Base 64 (RFC 4648, section 4), written. */
#ifndef MT_BASE_BASE64_H
#define MT_BASE_BASE64_H

#include "base/buffer.h"

/* Adds the bytes as text, in one line with its padding. MT_NO_MEMORY. */
mt_status mt_base64_add(mt_buffer *text, const uint8_t *bytes, size_t length);

#endif
