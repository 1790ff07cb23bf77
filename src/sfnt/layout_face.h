/* Layout tables as HarfBuzz takes them. */
#pragma once

#include <hb.h>

#include "sfnt/sfnt.h"

/* The tables of a face; empty ones are left out. */
typedef struct mt_face_tables {
    mt_bytes gsub, gdef, gpos, kern;
    int glyph_count;
    uint8_t maxp[6]; /* the bytes of the face's 'maxp' */
} mt_face_tables;

/* A face of these tables and a 'maxp' (version 0.5) that tells how many glyphs there are; NULL without memory. The bytes
 * and the structure have to outlive the face. */
hb_face_t *mt_face_make(mt_face_tables *tables);
