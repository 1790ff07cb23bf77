/* A page of HTML that stands alone, as base/embed.py makes it of a file of markup, styles and scripts: markup with slots. */
#pragma once

#include "base/buffer.h"

/* What follows a part. */
typedef enum mt_page_slot {
    MT_SLOT_END,     /* nothing: it is the last */
    MT_SLOT_VERSION, /* the program's, in an attribute; filled by itself */
    MT_SLOT_TITLE,   /* in an element of text */
    MT_SLOT_BODY,    /* markup */
    MT_SLOT_DATA,    /* what the script reads: JSON, in a script element that is not run */
    MT_SLOT_FONT,    /* a data: URL, in such an element */
} mt_page_slot;

typedef struct mt_page_part {
    const uint8_t *markup;
    size_t length;
    mt_page_slot slot;
} mt_page_part;

/* Adds what stands in a slot other than MT_SLOT_END and MT_SLOT_VERSION. */
typedef mt_status (*mt_page_fill)(mt_page_slot slot, const void *user, mt_buffer *text);

/* The page in a buffer of the caller's. MT_NO_MEMORY, and what `fill` gives. */
mt_status mt_page_make(const mt_page_part *parts, mt_page_fill fill, const void *user, mt_buffer *text);

/* Adds JSON, in which no markup can be afterwards: each < is escaped. MT_NO_MEMORY. */
mt_status mt_page_add_json(mt_buffer *text, const mt_buffer *json);
