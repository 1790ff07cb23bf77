#include "base/base64.h"

/* Up to three bytes become four letters; those that stand for no byte are padding. */
static void encode(const uint8_t *bytes, size_t count, char letters[4]) {
    static const char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    uint32_t bits = 0;
    for (size_t i = 0; i < 3; i++) bits = bits << 8 | (i < count ? bytes[i] : 0);
    for (size_t i = 0; i < 4; i++) letters[i] = i > count ? '=' : alphabet[bits >> (18 - 6 * i) & 63];
}

mt_status mt_base64_add(mt_buffer *text, const uint8_t *bytes, size_t length) {
    char letters[4 * 256];
    mt_status status = MT_OK;
    for (size_t at = 0; at < length && status == MT_OK;) {
        size_t filled = 0;
        for (; at < length && filled < sizeof letters; at += 3, filled += 4)
            encode(bytes + at, length - at < 3 ? length - at : 3, letters + filled);
        status = mt_buffer_add(text, letters, filled);
    }
    return status;
}
