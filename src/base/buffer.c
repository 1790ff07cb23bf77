#include "base/buffer.h"

#include "base/memory.h"

#include <string.h>

static mt_status make_room(mt_buffer *buffer, size_t length) {
    if (length <= buffer->room - buffer->length) return MT_OK;
    if (length > SIZE_MAX / 2 - buffer->length) return MT_NO_MEMORY;
    size_t room = buffer->room < 4096 ? 4096 : buffer->room;
    while (room < buffer->length + length) room = room > SIZE_MAX / 2 ? SIZE_MAX : room * 2;
    uint8_t *bytes = mt_grow(buffer->bytes, room, 1);
    if (!bytes) return MT_NO_MEMORY;
    buffer->bytes = bytes;
    buffer->room = room;
    return MT_OK;
}

mt_status mt_buffer_add(mt_buffer *buffer, const void *bytes, size_t length) {
    if (length == 0) return MT_OK;
    mt_status status = make_room(buffer, length);
    if (status != MT_OK) return status;
    memcpy(buffer->bytes + buffer->length, bytes, length);
    buffer->length += length;
    return MT_OK;
}

void mt_buffer_free(mt_buffer *buffer) {
    mt_free(buffer->bytes);
    *buffer = (mt_buffer){0};
}
