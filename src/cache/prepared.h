/* What the preparing of two glyphs comes to, and the same as bytes. */
#pragma once

#include "base/buffer.h"
#include "morph/model/morph.h"

typedef struct mt_prepared {
    mt_status status; /* MT_OK, or why there is no morph */
    int at_fault;     /* then: 0 for A's glyph, 1 for B's; -1 for neither alone */
    mt_shape a, b;    /* as both are drawn; empty where they cannot be read */
    mt_morph morph;   /* all zero unless the status is MT_OK */
} mt_prepared;

/* Whether it would come to the same any other time: not for want of memory, and not because work was stopped. */
bool mt_prepared_is_lasting(const mt_prepared *prepared);

/* Adds it to a buffer. MT_NO_MEMORY. */
mt_status mt_prepared_pack(const mt_prepared *prepared, mt_buffer *out);

/* Makes it of bytes, which may be anything, in the arena; what it gives is valid. MT_BAD_GEOMETRY for bytes that are damaged, MT_NO_MEMORY. */
mt_status mt_prepared_unpack(const uint8_t *bytes, size_t length, mt_arena *arena, mt_prepared *prepared);
