#include "base/page.h"

#include <string.h>

static mt_status fill_slot(mt_page_slot slot, mt_page_fill fill, const void *user, mt_buffer *text) {
    if (slot == MT_SLOT_END) return MT_OK;
    if (slot == MT_SLOT_VERSION) return mt_buffer_add(text, MORPHOTYPE_VERSION, strlen(MORPHOTYPE_VERSION));
    return fill(slot, user, text);
}

mt_status mt_page_make(const mt_page_part *parts, mt_page_fill fill, const void *user, mt_buffer *text) {
    mt_buffer made = {0};
    mt_status status = MT_OK;
    bool last = false;
    for (const mt_page_part *part = parts; !last && status == MT_OK; part++) {
        status = mt_buffer_add(&made, part->markup, part->length);
        if (status == MT_OK) status = fill_slot(part->slot, fill, user, &made);
        last = part->slot == MT_SLOT_END;
    }
    if (status == MT_OK)
        *text = made;
    else
        mt_buffer_free(&made);
    return status;
}

/* In JSON a < stands in strings alone, so that it can be escaped wherever it is. */
mt_status mt_page_add_json(mt_buffer *text, const mt_buffer *json) {
    mt_status status = MT_OK;
    size_t from = 0;
    for (size_t i = 0; i < json->length && status == MT_OK; i++) {
        if (json->bytes[i] != '<') continue;
        status = mt_buffer_add(text, json->bytes + from, i - from);
        if (status == MT_OK) status = mt_buffer_add(text, "\\u003c", 6);
        from = i + 1;
    }
    return status == MT_OK ? mt_buffer_add(text, json->bytes + from, json->length - from) : status;
}
