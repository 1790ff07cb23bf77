#include "base/utf.h"

/* How many bytes follow a lead byte, and the smallest code point that needs so many; -1 for no lead byte. */
static int followers(uint8_t lead, uint32_t *smallest) {
    static const uint32_t smallests[] = {0, 0x80, 0x800, 0x10000};
    int count = lead < 0x80 ? 0 : lead < 0xC0 ? -1 : lead < 0xE0 ? 1 : lead < 0xF0 ? 2 : lead < 0xF8 ? 3 : -1;
    if (count >= 0) *smallest = smallests[count];
    return count;
}

bool mt_utf8_next(const char **text, uint32_t *code_point) {
    const char *at = *text;
    uint8_t lead = (uint8_t)*at;
    uint32_t smallest, value;
    int count = followers(lead, &smallest);
    if (count < 0) return false;
    value = count == 0 ? lead : lead & (0x3Fu >> count);
    if (lead) at++;
    for (int i = 0; i < count; i++, at++) {
        if (((uint8_t)*at & 0xC0) != 0x80) return false;
        value = value << 6 | ((uint8_t)*at & 0x3F);
    }
    if (value < smallest || value > 0x10FFFF || (value >= 0xD800 && value <= 0xDFFF)) return false;
    *text = at;
    *code_point = value;
    return true;
}

bool mt_utf8_is_valid(const char *text, size_t length) {
    const char *end = text + length;
    uint32_t code_point;
    while (text < end)
        if (!mt_utf8_next(&text, &code_point) || !code_point) return false;
    return true;
}

int mt_utf8_put(uint32_t code_point, char bytes[4]) {
    int followed = code_point < 0x80 ? 0 : code_point < 0x800 ? 1 : code_point < 0x10000 ? 2 : 3;
    static const uint8_t leads[] = {0x00, 0xC0, 0xE0, 0xF0};
    for (int i = followed; i > 0; i--, code_point >>= 6) bytes[i] = (char)(0x80 | (code_point & 0x3F));
    bytes[0] = (char)(leads[followed] | code_point);
    return followed + 1;
}

static uint32_t unit_at(const uint8_t *bytes, size_t length, size_t at) {
    return length - at >= 2 ? (uint32_t)bytes[at] << 8 | bytes[at + 1] : 0;
}

uint32_t mt_utf16_next(const uint8_t *bytes, size_t length, size_t *at) {
    size_t here = *at;
    *at = length - here >= 2 ? here + 2 : length;
    if (length - here < 2) return MT_REPLACEMENT;
    uint32_t high = unit_at(bytes, length, here), low = unit_at(bytes, length, *at);
    if (high < 0xD800 || high > 0xDFFF) return high;
    if (high > 0xDBFF || low < 0xDC00 || low > 0xDFFF) return MT_REPLACEMENT;
    *at += 2;
    return 0x10000 + ((high - 0xD800) << 10) + (low - 0xDC00);
}
