/* Base 64 (RFC 4648, section 4), written. */
#pragma once

#include "base/buffer.h"

/* Adds the bytes as text, in one line with its padding. MT_NO_MEMORY. */
mt_status mt_base64_add(mt_buffer *text, const uint8_t *bytes, size_t length);
