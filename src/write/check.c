/* What a font must be before it can be written: each count, order and text, looked at once, here. */
#include "write/tables.h"

#include <string.h>

#include "base/utf.h"
#include "geometry/limits.h"

/* TrueType stores each point as its difference from the one before, in 16 bits. */
static mt_status check_differences(const mt_glyf *glyph, int points) {
    int x = 0, y = 0;
    for (int i = 0; i < points; i++) {
        int dx = glyph->points[i].x - x, dy = glyph->points[i].y - y;
        if (dx < INT16_MIN || dx > INT16_MAX || dy < INT16_MIN || dy > INT16_MAX) return MT_TOO_LARGE;
        x = glyph->points[i].x;
        y = glyph->points[i].y;
    }
    return MT_OK;
}

static mt_status check_glyph(const mt_glyf *glyph) {
    if (glyph->contour_count < 0 || glyph->reference_count < 0) return MT_BAD_PARAMETER;
    if (glyph->contour_count > 0 && glyph->reference_count > 0) return MT_BAD_PARAMETER;
    if (glyph->contour_count > MT_GLYF_CONTOURS_MAX) return MT_TOO_LARGE;
    for (int i = 0; i < glyph->contour_count; i++) {
        if (glyph->ends[i] >= MT_GLYF_POINTS_MAX) return MT_TOO_LARGE;
        if (glyph->ends[i] < (i ? glyph->ends[i - 1] + 1 : 0)) return MT_BAD_PARAMETER;
    }
    return check_differences(glyph, mt_glyf_point_count(glyph));
}

static mt_status check_glyphs(const mt_font_data *data) {
    if (data->glyph_count < 1) return MT_BAD_PARAMETER;
    if (data->glyph_count > MT_GLYPHS_MAX) return MT_TOO_LARGE;
    mt_status status = MT_OK;
    for (int i = 0; i < data->glyph_count && status == MT_OK; i++) status = check_glyph(&data->glyphs[i]);
    return status;
}

static mt_status check_chars(const mt_font_data *data) {
    if (data->char_count < 0) return MT_BAD_PARAMETER;
    for (int i = 0; i < data->char_count; i++) {
        uint32_t c = data->chars[i].code_point;
        if (i > 0 && c <= data->chars[i - 1].code_point) return MT_BAD_PARAMETER;
        if (c > 0x10FFFF || (c >= 0xD800 && c <= 0xDFFF)) return MT_BAD_PARAMETER;
        if (data->chars[i].glyph >= data->glyph_count) return MT_BAD_PARAMETER;
    }
    return MT_OK;
}

static bool in_order(const mt_char_variation *before, const mt_char_variation *after) {
    if (before->selector != after->selector) return before->selector < after->selector;
    return before->code_point < after->code_point;
}

static mt_status check_variants(const mt_font_data *data) {
    for (int i = 0; i < data->variant_count; i++) {
        const mt_char_variation *variant = &data->variants[i];
        if (i > 0 && !in_order(variant - 1, variant)) return MT_BAD_PARAMETER;
        if (variant->code_point > 0x10FFFF || variant->selector > 0x10FFFF) return MT_BAD_PARAMETER;
        if (variant->glyph >= data->glyph_count) return MT_BAD_PARAMETER;
    }
    return MT_OK;
}

/* As PostScript takes them. */
static mt_status check_glyph_names(const mt_font_data *data) {
    for (int i = 0; data->glyph_names && i < data->glyph_count; i++) {
        const char *name = data->glyph_names[i];
        size_t length = name ? strlen(name) : 0;
        if (length < 1 || length > MT_GLYPH_NAME_MAX) return MT_BAD_PARAMETER;
        for (size_t k = 0; k < length; k++)
            if (name[k] <= ' ' || name[k] > '~') return MT_BAD_PARAMETER;
    }
    return MT_OK;
}

/* Lengths and offsets in 'name' have 16 bits. Family and style stand there up to three times, and UTF-16
 * takes at most two bytes for one of UTF-8. */
static mt_status check_names(const mt_font_data *data) {
    enum { NAME_BYTES_MAX = 65535, OTHERS = 256 };
    const char *texts[] = {data->family,    data->style,    data->unique_id,   data->version,
                           data->copyright, data->license,  data->license_url, data->description,
                           data->designer,  data->trademark};
    size_t length = 0;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        if (i < 3 && (!texts[i] || !*texts[i])) return MT_BAD_PARAMETER;
        if (!texts[i]) continue;
        if (!mt_utf8_is_valid(texts[i], strlen(texts[i]))) return MT_BAD_PARAMETER;
        length += (i < 2 ? 3 : 1) * 2 * strlen(texts[i]);
    }
    return length > NAME_BYTES_MAX - OTHERS ? MT_TOO_LARGE : MT_OK;
}

mt_status mt_font_data_check(const mt_font_data *data) {
    if (data->units < 16 || data->units > 16384) return MT_BAD_PARAMETER;
    mt_status status = check_glyphs(data);
    if (status == MT_OK) status = check_chars(data);
    if (status == MT_OK) status = check_variants(data);
    if (status == MT_OK) status = check_glyph_names(data);
    if (status == MT_OK) status = check_names(data);
    return status;
}
