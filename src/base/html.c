#include "base/html.h"

#include "base/utf.h"

#include <string.h>

bool mt_html_is_control(uint32_t code_point) {
    return code_point < ' ' || (code_point >= 0x7f && code_point < 0xa0);
}

mt_status mt_html_character(mt_buffer *text, uint32_t code_point) {
    char bytes[5] = "";
    const char *markup = bytes;
    switch (code_point) {
    case '&': markup = "&amp;"; break;
    case '<': markup = "&lt;"; break;
    case '>': markup = "&gt;"; break;
    case '"': markup = "&quot;"; break;
    case '\'': markup = "&#39;"; break;
    default: mt_utf8_put(mt_html_is_control(code_point) ? MT_REPLACEMENT : code_point, bytes);
    }
    return mt_buffer_add(text, markup, strlen(markup));
}

mt_status mt_html_text(mt_buffer *text, const char *utf8) {
    mt_status status = MT_OK;
    while (*utf8 && status == MT_OK) {
        uint32_t code_point = MT_REPLACEMENT;
        if (!mt_utf8_next(&utf8, &code_point)) utf8++;
        status = mt_html_character(text, code_point);
    }
    return status;
}
