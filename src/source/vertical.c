/* Where a glyph stands on a vertical line (OpenType spec, "vmtx" and "VORG").
 *
 * A glyph's vertical origin is over its top by the top side bearing. A font with cubic outlines may say in VORG how
 * high it is, so that the outline need not be looked at; VVAR's changes to VORG are not read. */
#include "source/handle.h"

#include <math.h>

#include FT_ADVANCES_H
#include FT_BBOX_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H

#include "geometry/limits.h"
#include "sfnt/sfnt.h"

enum { FLAGS = FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP | FT_LOAD_IGNORE_TRANSFORM };

/* ---- VORG ---------------------------------------------------------------------------------------------- */

enum { VORG_HEADER = 8, VORG_RECORD = 4 };

/* `count` bytes of the table, 8 at most. */
static bool read_vorg(const mt_font *font, size_t offset, FT_ULong count, uint8_t *bytes) {
    return FT_Load_Sfnt_Table(font->face, MT_TAG('V', 'O', 'R', 'G'), (FT_Long)offset, bytes, &count) == 0;
}

static double read_i16(const uint8_t *bytes) {
    return (int16_t)mt_read_u16(bytes);
}

/* The record of the glyph is looked for among all, which ascend; the default stands in the header. */
static bool find_origin(const mt_font *font, uint32_t glyph, double *origin) {
    uint8_t header[VORG_HEADER], record[VORG_RECORD];
    FT_ULong length = 0;
    if (FT_Load_Sfnt_Table(font->face, MT_TAG('V', 'O', 'R', 'G'), 0, NULL, &length) != 0) return false;
    if (length < VORG_HEADER || !read_vorg(font, 0, VORG_HEADER, header)) return false;
    size_t low = 0, high = mt_read_u16(header + 6);
    if (high > (length - VORG_HEADER) / VORG_RECORD) return false;
    *origin = read_i16(header + 4);
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (!read_vorg(font, VORG_HEADER + VORG_RECORD * middle, VORG_RECORD, record)) return false;
        uint32_t found = mt_read_u16(record);
        if (found == glyph) *origin = read_i16(record + 2);
        if (found == glyph) break;
        if (found < glyph)
            low = middle + 1;
        else
            high = middle;
    }
    return true;
}

/* ---- vmtx ---------------------------------------------------------------------------------------------- */

/* The top of the glyph as FreeType takes it: with the control points, for quadratic outlines; the ink's, for cubic
 * ones, whose bearing it passes on as it stands in the table. */
static mt_status measure_top(const mt_font *font, double *top) {
    FT_BBox box;
    FT_Outline *outline = &font->face->glyph->outline;
    if (mt_font_has_table(font, MT_TAG('g', 'l', 'y', 'f')))
        FT_Outline_Get_CBox(outline, &box);
    else if (FT_Outline_Get_BBox(outline, &box) != 0)
        return MT_BAD_GLYPH;
    *top = (double)box.yMax;
    return MT_OK;
}

static mt_status measure_origin(mt_font *font, uint32_t glyph, double *origin) {
    double top;
    mt_status status = mt_font_load(font, glyph, FLAGS);
    if (status != MT_OK) return status;
    if (font->face->glyph->format != FT_GLYPH_FORMAT_OUTLINE) return MT_BAD_GLYPH;
    status = measure_top(font, &top);
    if (status == MT_OK) *origin = (double)font->face->glyph->metrics.vertBearingY + top;
    return status;
}

/* ---- a glyph ------------------------------------------------------------------------------------------- */

typedef struct mt_wanted {
    uint32_t glyph;
    mt_vertical vertical; /* font units; made up from the lines before it is read */
} mt_wanted;

/* Some fonts give glyphs of theirs no height at all; of one that has a width that is no vertical metric. */
static mt_status read_vertical(mt_font *font, void *user) {
    mt_wanted *wanted = user;
    FT_Fixed width, height;
    mt_vertical read = {0};
    if (FT_Get_Advance(font->face, wanted->glyph, FLAGS, &width) != 0) return MT_BAD_GLYPH;
    if (FT_Get_Advance(font->face, wanted->glyph, FLAGS | FT_LOAD_VERTICAL_LAYOUT, &height) != 0)
        return MT_BAD_GLYPH;
    if (height == 0 && width != 0) return MT_OK;
    read.advance = fabs((double)height);
    mt_status status = MT_OK;
    if (!find_origin(font, wanted->glyph, &read.origin))
        status = measure_origin(font, wanted->glyph, &read.origin);
    if (status == MT_OK) wanted->vertical = read;
    return status;
}

mt_status mt_font_vertical(mt_font *font, uint32_t glyph, mt_vertical *vertical) {
    const mt_metrics *lines = &font->metrics;
    const mt_composed *composed = mt_font_composed(font, glyph);
    mt_wanted wanted = {composed ? composed->like : glyph,
                        {lines->typo_ascender - lines->typo_descender, lines->typo_ascender}};
    if (!font->face) return MT_NO_MEMORY;
    mt_status status = lines->vertical ? mt_font_guard(font, read_vertical, &wanted) : MT_OK;
    if (status != MT_OK) return status;
    double scale = (double)MT_EM / font->units;
    *vertical = (mt_vertical){wanted.vertical.advance * scale, wanted.vertical.origin * scale};
    return MT_OK;
}
