/* What reading and writing share of the sfnt format: TrueType, OpenType and collections. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MT_TAG(a, b, c, d) ((uint32_t)(a) << 24 | (uint32_t)(b) << 16 | (uint32_t)(c) << 8 | (uint32_t)(d))

typedef struct mt_bytes {
    const uint8_t *bytes;
    size_t length;
} mt_bytes;

static inline unsigned mt_read_u16(const uint8_t *bytes) {
    return (unsigned)bytes[0] << 8 | bytes[1];
}

static inline uint32_t mt_read_u32(const uint8_t *bytes) {
    return (uint32_t)mt_read_u16(bytes) << 16 | mt_read_u16(bytes + 2);
}

/* The names of the 'name' table that are read or written (OpenType spec, "name": Name IDs). */
enum {
    MT_NAME_COPYRIGHT = 0,
    MT_NAME_FAMILY = 1, /* with one of the four styles below, as old applications want it */
    MT_NAME_STYLE = 2,  /* Regular, Bold, Italic or Bold Italic */
    MT_NAME_UNIQUE_ID = 3,
    MT_NAME_FULL = 4,
    MT_NAME_VERSION = 5,
    MT_NAME_POSTSCRIPT = 6,
    MT_NAME_TRADEMARK = 7,
    MT_NAME_DESIGNER = 9,
    MT_NAME_DESCRIPTION = 10,
    MT_NAME_LICENSE = 13,
    MT_NAME_LICENSE_URL = 14,
    MT_NAME_TYPOGRAPHIC_FAMILY = 16,
    MT_NAME_TYPOGRAPHIC_STYLE = 17,
    MT_NAME_VARIATIONS_PREFIX = 25, /* what the PostScript names of a variable font's places begin with */
    MT_NAME_AXIS = 256,             /* from here on the font's own: its axis, … */
    MT_NAME_PLACES = 257,           /* … and its named places, one after another */
};

/* Whether every table of face `face` lies within the file's bytes: false for a file cut short. True for what
 * is no sfnt file (a WOFF gives its length in its header, which FreeType checks). */
bool mt_sfnt_is_whole(const uint8_t *bytes, size_t length, int face);
