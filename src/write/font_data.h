/* A font in writing, as plain data. */
#pragma once

#include "sfnt/axis_data.h"
#include "sfnt/sfnt.h"
#include "source/font.h"

typedef struct mt_glyf_point {
    int16_t x, y;
    bool on; /* on the curve */
} mt_glyf_point;

/* Another glyph of the same font, moved to the right and up. */
typedef struct mt_glyf_reference {
    uint16_t glyph;
    int16_t dx, dy;
    bool same_metrics; /* the composite stands in the line as that glyph does */
} mt_glyf_reference;

/* A glyph as 'glyf' has it: contours of on- and off-curve points, or references; font units. */
typedef struct mt_glyf {
    uint16_t advance;
    uint16_t height; /* the vertical advance; with mt_metrics.vertical only, as is the origin */
    int16_t origin;  /* of vertical lines, over the baseline */
    int contour_count;
    int *ends; /* the last point of each contour */
    mt_glyf_point *points;
    int reference_count; /* over 0: the glyph is a composite and has no contours of its own */
    mt_glyf_reference *references;
    bool overlaps; /* contours, or parts, may lie over one another */
} mt_glyf;

typedef struct mt_char {
    uint32_t code_point;
    uint16_t glyph;
} mt_char;

/* A character with a variation selector after it. */
typedef struct mt_char_variation {
    uint32_t selector, code_point;
    uint16_t glyph;
    bool by_default; /* the character's own glyph */
} mt_char_variation;

/* Where a glyph comes from. */
typedef struct mt_origin {
    uint32_t glyph; /* its number in the first source */
    uint32_t
        code_point; /* of the first character that leads to it, or that it is a form of; 0: none is known */
} mt_origin;

/* A table that was made elsewhere and goes into the font as it is. */
typedef struct mt_extra_table {
    uint32_t tag;
    mt_bytes data;
} mt_extra_table;

enum { MT_EXTRA_TABLES_MAX = 16 };

typedef struct mt_font_data {
    int units;       /* per em, 16 … 16384 */
    int glyph_count; /* 1 … MT_GLYPHS_MAX; glyph 0 is .notdef */
    mt_glyf *glyphs;
    const mt_origin *origins; /* one a glyph; NULL: not told */
    int char_count;
    mt_char *chars; /* ascending */
    int variant_count;
    mt_char_variation *variants; /* by selector, then by character, each once */
    mt_metrics metrics;
    int64_t created, modified; /* seconds since 1904 */
    uint16_t embedding;        /* OS/2 fsType */
    bool is_symbol;            /* the characters are in a character map for symbols too */
    const char **glyph_names; /* one a glyph, 1 … MT_GLYPH_NAME_MAX printable ASCII characters; NULL: none */
    const mt_axis_data *variation;    /* NULL: the font does not vary */
    const struct mt_kerning *kerning; /* for a UFO, which has no GPOS; NULL: none */
    mt_curves curves;                 /* of a UFO's outlines */
    int layout_place; /* on the axis of the tables made elsewhere, where these vary and the font does not */
    int extra_count;
    mt_extra_table extras[MT_EXTRA_TABLES_MAX]; /* none of a tag that is written here, none empty */
    /* UTF-8; NULL ones are left out. The first three are required. */
    const char *family, *style, *unique_id, *version, *copyright, *license, *license_url, *description,
        *designer, *trademark;
} mt_font_data;
