/* Loading a glyph, once what its references lead to is known to be bounded.
 *
 * FreeType 2.12 walks references to their ends: 26 glyphs of which each names the next one twice are a few kilobytes of a font, and 67
 * million glyphs to load. So a composite ('glyf' of the OpenType specification: Composite Glyph Description) is weighed before it is
 * loaded: its points and those of its parts, and something for each part. Weights are kept. What references lead to in a circle weighs
 * too much. O(references) for a font. */
#include "source/handle.h"

#include FT_TRUETYPE_TABLES_H

#include "geometry/limits.h"
#include "sfnt/sfnt.h"

/* A part costs as much as so many points; references may be so deep; and no glyph weighs more than a glyph can have points, which stands for
 * "too much" as well. */
enum { PART_WEIGHT = 16, DEPTH_MOST = 64, TOO_HEAVY = MT_GLYF_POINTS_MAX };

enum { REFERENCE_FLAGS = FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING | FT_LOAD_NO_RECURSE };

/* A big-endian number of two or four bytes from a table; false where there is none. */
static bool read_number(FT_Face face, FT_ULong tag, uint64_t at, FT_ULong bytes, uint32_t *number) {
    FT_Byte read[4];
    FT_ULong length = bytes;
    if (at > INT32_MAX || FT_Load_Sfnt_Table(face, tag, (FT_Long)at, read, &length) != 0) return false;
    *number = 0;
    for (FT_ULong i = 0; i < bytes; i++) *number = *number << 8 | read[i];
    return true;
}

/* Where a glyph's description starts in 'glyf'; false for a glyph that has none. */
static bool find_description(FT_Face face, uint32_t glyph, uint64_t *at) {
    const FT_ULong loca = MT_TAG('l', 'o', 'c', 'a');
    const TT_Header *head = FT_Get_Sfnt_Table(face, FT_SFNT_HEAD);
    bool is_long = head && head->Index_To_Loc_Format != 0;
    FT_ULong bytes = is_long ? 4 : 2;
    uint32_t start, end;
    if (!read_number(face, loca, (uint64_t)glyph * bytes, bytes, &start)) return false;
    if (!read_number(face, loca, ((uint64_t)glyph + 1) * bytes, bytes, &end)) end = UINT32_MAX;
    *at = is_long ? start : 2 * (uint64_t)start;
    return start < end;
}

/* The contours of a glyph, -1 for a composite, 0 for one that has no description; and the points. */
static int contours_of(FT_Face face, uint32_t glyph, uint32_t *points) {
    const FT_ULong glyf = MT_TAG('g', 'l', 'y', 'f');
    enum { HEADER = 10 };
    uint64_t at;
    uint32_t count, last;
    *points = 0;
    if (!find_description(face, glyph, &at) || !read_number(face, glyf, at, 2, &count)) return 0;
    if (count == 0 || count >= 0x8000) return count ? -1 : 0;
    if (read_number(face, glyf, at + HEADER + 2 * (uint64_t)(count - 1), 2, &last)) *points = last + 1;
    return (int)count;
}

/* ---- composites ---------------------------------------------------------------------------------------- */

static uint32_t weigh(mt_font *font, uint32_t glyph, int depth);

/* The glyphs that the loaded composite names, in the font's scratch memory. NULL: none, or no memory. */
static uint32_t *list_parts(mt_font *font, FT_UInt *count) {
    FT_GlyphSlot slot = font->face->glyph;
    *count = slot->format == FT_GLYPH_FORMAT_COMPOSITE ? slot->num_subglyphs : 0;
    uint32_t *parts = *count ? mt_arena_new(&font->scratch, *count, sizeof *parts) : NULL;
    for (FT_UInt i = 0; parts && i < *count; i++) {
        FT_Int index, first, second;
        FT_UInt flags;
        FT_Matrix matrix;
        if (FT_Get_SubGlyph_Info(slot, i, &index, &flags, &first, &second, &matrix) != 0) return NULL;
        parts[i] = (uint32_t)index;
    }
    return parts;
}

/* Of a composite. What cannot be read weighs nothing: FreeType refuses it as well. */
static uint32_t weigh_parts(mt_font *font, uint32_t glyph, int depth) {
    uint32_t weight = PART_WEIGHT;
    FT_UInt count;
    if (FT_Load_Glyph(font->face, glyph, REFERENCE_FLAGS) != 0) return weight;
    mt_arena_place before = mt_arena_mark(&font->scratch);
    const uint32_t *parts = list_parts(font, &count);
    for (FT_UInt i = 0; parts && i < count && weight < TOO_HEAVY; i++)
        weight += weigh(font, parts[i], depth + 1);
    if (count > 0 && !parts) weight = TOO_HEAVY;
    mt_arena_rewind(&font->scratch, before);
    return weight;
}

/* Up to TOO_HEAVY. While a glyph is being weighed it is too heavy, so that a circle is. */
static uint32_t weigh(mt_font *font, uint32_t glyph, int depth) {
    uint32_t points, weight = TOO_HEAVY;
    if (glyph >= (uint32_t)font->face->num_glyphs) return 0;
    if (font->weights[glyph]) return font->weights[glyph];
    font->weights[glyph] = TOO_HEAVY;
    if (contours_of(font->face, glyph, &points) >= 0)
        weight = PART_WEIGHT + points;
    else if (depth < DEPTH_MOST)
        weight = weigh_parts(font, glyph, depth);
    font->weights[glyph] = (uint16_t)(weight < TOO_HEAVY ? weight : TOO_HEAVY);
    return font->weights[glyph];
}

/* ---- a glyph ------------------------------------------------------------------------------------------- */

static mt_status check_parts(mt_font *font, uint32_t glyph) {
    uint32_t points;
    if (font->face->num_glyphs > MT_GLYPHS_MAX + 1 || glyph >= (uint32_t)font->face->num_glyphs ||
        contours_of(font->face, glyph, &points) >= 0)
        return MT_OK;
    if (!font->weights) font->weights = mt_new((size_t)font->face->num_glyphs, sizeof *font->weights);
    if (!font->weights) return MT_NO_MEMORY;
    return weigh(font, glyph, 0) < TOO_HEAVY ? MT_OK : MT_TOO_LARGE;
}

mt_status mt_font_load(mt_font *font, uint32_t glyph, FT_Int32 flags) {
    bool truetype = mt_font_has_table(font, MT_TAG('g', 'l', 'y', 'f'));
    mt_status status = truetype ? check_parts(font, glyph) : MT_OK;
    if (status != MT_OK) return status;
    return FT_Load_Glyph(font->face, glyph, flags) == 0 ? MT_OK : MT_BAD_GLYPH;
}
