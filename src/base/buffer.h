/* Bytes that grow: what a picture or a JSON text is written into before it becomes a file. */
#pragma once

#include "morphotype.h"

typedef struct mt_buffer {
    uint8_t *bytes; /* from mt_grow: mt_free or mt_bytes_free gives them back */
    size_t length, room;
} mt_buffer; /* all zero is an empty buffer */

/* Adds `length` bytes at the end. On MT_NO_MEMORY the buffer is as it was. */
mt_status mt_buffer_add(mt_buffer *buffer, const void *bytes, size_t length);
void mt_buffer_free(mt_buffer *buffer); /* leaves an empty one */
