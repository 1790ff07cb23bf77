#include "sfnt/layout_face.h"

#include <string.h>

static bool add_table(hb_face_t *face, uint32_t tag, mt_bytes table) {
    if (table.length == 0) return true;
    hb_blob_t *blob = hb_blob_create_or_fail((const char *)table.bytes, (unsigned)table.length,
                                             HB_MEMORY_MODE_READONLY, NULL, NULL);
    bool added = blob && hb_face_builder_add_table(face, tag, blob);
    hb_blob_destroy(blob);
    return added;
}

hb_face_t *mt_face_make(mt_face_tables *tables) {
    const int count = tables->glyph_count;
    const uint8_t maxp[6] = {0, 0, 0x50, 0, (uint8_t)(count >> 8), (uint8_t)count};
    hb_face_t *face = hb_face_builder_create();
    memcpy(tables->maxp, maxp, sizeof maxp);
    bool made = add_table(face, MT_TAG('m', 'a', 'x', 'p'), (mt_bytes){tables->maxp, sizeof maxp}) &&
                add_table(face, MT_TAG('G', 'S', 'U', 'B'), tables->gsub) &&
                add_table(face, MT_TAG('G', 'D', 'E', 'F'), tables->gdef) &&
                add_table(face, MT_TAG('G', 'P', 'O', 'S'), tables->gpos) &&
                add_table(face, MT_TAG('k', 'e', 'r', 'n'), tables->kern);
    if (made) return face;
    hb_face_destroy(face);
    return NULL;
}
