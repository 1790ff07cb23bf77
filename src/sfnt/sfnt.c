/* The table directory (OpenType spec, "Organization of an OpenType Font"). FreeType passes over entries that
 * reach beyond the end of the file; a font cut short would then be read as one that never had those tables. */
#include "sfnt/sfnt.h"

static bool is_sfnt(uint32_t version) {
    return version == 0x00010000 || version == MT_TAG('O', 'T', 'T', 'O') ||
           version == MT_TAG('t', 'r', 'u', 'e');
}

/* Where the directory of the face starts. */
static bool find_directory(const uint8_t *bytes, size_t length, int face, size_t *start) {
    *start = 0;
    if (length < 12 || mt_read_u32(bytes) != MT_TAG('t', 't', 'c', 'f')) return length >= 12;
    size_t entry = 12 + 4 * (size_t)face;
    if (entry > length - 4) return false;
    *start = mt_read_u32(bytes + entry);
    return *start <= length - 12;
}

bool mt_sfnt_is_whole(const uint8_t *bytes, size_t length, int face) {
    size_t start;
    if (!find_directory(bytes, length, face, &start)) return false;
    if (!is_sfnt(mt_read_u32(bytes + start))) return true;
    size_t count = mt_read_u16(bytes + start + 4);
    if (count > (length - start - 12) / 16) return false;
    for (size_t i = 0; i < count; i++) {
        const uint8_t *entry = bytes + start + 12 + 16 * i;
        size_t offset = mt_read_u32(entry + 8), size = mt_read_u32(entry + 12);
        if (offset > length || size > length - offset) return false;
    }
    return true;
}
