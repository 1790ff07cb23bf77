/* The outlines: 'glyf' and 'loca' (OpenType spec, "glyf - Glyph Data").
 *
 * A point's flag says for each axis how its difference from the point before is stored: not at all when it is
 * 0, as a byte and a sign up to 255, or else in 16 bits. Equal flags in a row are stored once, with a count. */
#include "write/tables.h"

enum {
    ON_CURVE = 1,
    X_SHORT = 2,
    Y_SHORT = 4,
    REPEAT = 8,
    X_SAME_OR_POSITIVE = 16,
    Y_SAME_OR_POSITIVE = 32,
    OVERLAP_SIMPLE = 64
};
enum { REPEATS_MAX = 255, ALIGNMENT = 2 };

/* Short offsets are stored halved, in 16 bits. */
#define SHORT_OFFSET_MAX 0x1FFFEu

static unsigned axis_flag(int difference, unsigned is_short, unsigned same_or_positive) {
    if (difference == 0) return same_or_positive;
    if (difference < -255 || difference > 255) return 0;
    return difference > 0 ? is_short | same_or_positive : is_short;
}

/* The flag that contours overlap stands at the first point. */
static unsigned point_flag(const mt_glyf *glyph, int i) {
    const mt_glyf_point *points = glyph->points;
    int dx = points[i].x - (i ? points[i - 1].x : 0), dy = points[i].y - (i ? points[i - 1].y : 0);
    return (points[i].on ? ON_CURVE : 0u) | (i == 0 && glyph->overlaps ? OVERLAP_SIMPLE : 0u) |
           axis_flag(dx, X_SHORT, X_SAME_OR_POSITIVE) | axis_flag(dy, Y_SHORT, Y_SAME_OR_POSITIVE);
}

static void write_flags(const mt_glyf *glyph, int count, mt_table *table) {
    for (int i = 0, next; i < count; i = next) {
        unsigned flag = point_flag(glyph, i);
        for (next = i + 1; next < count && next - i <= REPEATS_MAX; next++)
            if (point_flag(glyph, next) != flag) break;
        unsigned repeats = (unsigned)(next - i - 1);
        mt_table_u8(table, repeats ? flag | REPEAT : flag);
        if (repeats) mt_table_u8(table, repeats);
    }
}

static void write_difference(int difference, mt_table *table) {
    if (difference == 0) return;
    if (difference < -255 || difference > 255)
        mt_table_16(table, difference);
    else
        mt_table_u8(table, (unsigned)(difference < 0 ? -difference : difference));
}

static void write_points(const mt_glyf *glyph, mt_table *table) {
    const mt_glyf_point *points = glyph->points;
    int count = mt_glyf_point_count(glyph);
    write_flags(glyph, count, table);
    for (int i = 0; i < count; i++) write_difference(points[i].x - (i ? points[i - 1].x : 0), table);
    for (int i = 0; i < count; i++) write_difference(points[i].y - (i ? points[i - 1].y : 0), table);
}

static void write_bounds(const mt_bounds *bounds, mt_table *table) {
    mt_table_16(table, bounds->x_min);
    mt_table_16(table, bounds->y_min);
    mt_table_16(table, bounds->x_max);
    mt_table_16(table, bounds->y_max);
}

static void write_contours(const mt_glyf *glyph, mt_table *table) {
    for (int i = 0; i < glyph->contour_count; i++) mt_table_16(table, glyph->ends[i]);
    mt_table_16(table, 0); /* no instructions */
    write_points(glyph, table);
}

static bool is_byte(int offset) {
    return offset >= INT8_MIN && offset <= INT8_MAX;
}

static void write_reference(const mt_glyf *glyph, int i, mt_table *table) {
    enum { WORDS = 1, OFFSETS = 2, MORE = 0x20, USE_MY_METRICS = 0x200, OVERLAP_COMPOUND = 0x400 };
    const mt_glyf_reference *reference = &glyph->references[i];
    bool last = i == glyph->reference_count - 1;
    bool words = !is_byte(reference->dx) || !is_byte(reference->dy);
    mt_table_16(table, OFFSETS | (words ? WORDS : 0) | (last ? 0 : MORE) |
                           (reference->same_metrics ? USE_MY_METRICS : 0) |
                           (i == 0 && glyph->overlaps ? OVERLAP_COMPOUND : 0));
    mt_table_16(table, reference->glyph);
    if (words) {
        mt_table_16(table, reference->dx);
        mt_table_16(table, reference->dy);
    } else {
        mt_table_u8(table, (unsigned)reference->dx & 0xFF);
        mt_table_u8(table, (unsigned)reference->dy & 0xFF);
    }
}

static void write_glyph(const mt_glyf *glyph, const mt_extent *extent, mt_table *table) {
    enum { COMPOSITE = -1 };
    if (extent->points == 0) return;
    mt_table_16(table, glyph->reference_count ? COMPOSITE : glyph->contour_count);
    write_bounds(&extent->bounds, table);
    for (int i = 0; i < glyph->reference_count; i++) write_reference(glyph, i, table);
    if (glyph->reference_count == 0) write_contours(glyph, table);
    mt_table_zeros(table, (int)(table->length % ALIGNMENT));
}

/* A table over 4 GiB has offsets that wrap; write.c refuses it for its length. */
void mt_write_glyf(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    for (int i = 0; i < data->glyph_count; i++) {
        summary->offsets[i] = (uint32_t)table->length;
        write_glyph(&data->glyphs[i], &summary->extents[i], table);
    }
    summary->offsets[data->glyph_count] = (uint32_t)table->length;
    if (table->length == 0) mt_table_zeros(table, 1); /* readers want a table that is not empty */
}

bool mt_loca_is_long(const mt_font_data *data, const mt_summary *summary) {
    return summary->offsets[data->glyph_count] > SHORT_OFFSET_MAX;
}

void mt_write_loca(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    bool is_long = mt_loca_is_long(data, summary);
    for (int i = 0; i <= data->glyph_count; i++) {
        if (is_long)
            mt_table_32(table, summary->offsets[i]);
        else
            mt_table_16(table, (int)(summary->offsets[i] / 2));
    }
}
