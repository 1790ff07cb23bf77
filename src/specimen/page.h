/* The specimen's page, as specimen/embed.py makes it of page.html, style.css and script.js: markup with slots. */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* What follows a part. */
typedef enum mt_specimen_slot {
    MT_SLOT_END,     /* nothing: it is the last */
    MT_SLOT_VERSION, /* the program's, in an attribute */
    MT_SLOT_TITLE,   /* in an element of text */
    MT_SLOT_DATA,    /* what the script reads: JSON, in a script element that is not run */
    MT_SLOT_FONT,    /* a data: URL, in such an element */
} mt_specimen_slot;

typedef struct mt_specimen_part {
    const uint8_t *markup;
    size_t length;
    mt_specimen_slot slot;
} mt_specimen_part;

extern const mt_specimen_part mt_specimen_parts[];
