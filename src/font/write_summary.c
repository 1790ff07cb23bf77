#include "write_tables.h"

#include <limits.h>
#include <string.h>

int mt_glyf_point_count(const mt_glyf *glyph) {
    return glyph->contour_count ? glyph->ends[glyph->contour_count - 1] + 1 : 0;
}

static int min(int a, int b) {
    return a < b ? a : b;
}

static int max(int a, int b) {
    return a > b ? a : b;
}

mt_bounds mt_glyf_bounds(const mt_glyf *glyph) {
    int count = mt_glyf_point_count(glyph);
    if (count == 0) return (mt_bounds){0};
    mt_bounds bounds = {INT_MAX, INT_MAX, INT_MIN, INT_MIN};
    for (int i = 0; i < count; i++) {
        const mt_glyf_point *point = &glyph->points[i];
        bounds.x_min = min(bounds.x_min, point->x);
        bounds.y_min = min(bounds.y_min, point->y);
        bounds.x_max = max(bounds.x_max, point->x);
        bounds.y_max = max(bounds.y_max, point->y);
    }
    return bounds;
}

static void add_drawn(mt_summary *summary, const mt_glyf *glyph, bool first) {
    mt_bounds bounds = mt_glyf_bounds(glyph), *all = &summary->bounds;
    int right = glyph->advance - bounds.x_max;
    summary->max_contours = max(summary->max_contours, glyph->contour_count);
    summary->max_points = max(summary->max_points, mt_glyf_point_count(glyph));
    summary->min_left = first ? bounds.x_min : min(summary->min_left, bounds.x_min);
    summary->min_right = first ? right : min(summary->min_right, right);
    summary->max_extent = first ? bounds.x_max : max(summary->max_extent, bounds.x_max);
    if (first) *all = bounds;
    all->x_min = min(all->x_min, bounds.x_min);
    all->y_min = min(all->y_min, bounds.y_min);
    all->x_max = max(all->x_max, bounds.x_max);
    all->y_max = max(all->y_max, bounds.y_max);
}

/* A style of that name says so itself; any other is judged by its figures. */
static bool is_bold(const mt_font_data *data) {
    if (strcmp(data->style, "Bold") == 0 || strcmp(data->style, "Bold Italic") == 0) return true;
    return data->metrics.weight_class >= 700;
}

static bool is_italic(const mt_font_data *data) {
    if (strcmp(data->style, "Italic") == 0 || strcmp(data->style, "Bold Italic") == 0) return true;
    return data->metrics.italic_angle < 0 || data->metrics.italic_angle > 0;
}

void mt_summarise(const mt_font_data *data, mt_summary *summary) {
    bool first = true;
    for (int i = 0; i < data->glyph_count; i++) {
        summary->max_advance = max(summary->max_advance, data->glyphs[i].advance);
        if (data->glyphs[i].contour_count == 0) continue;
        add_drawn(summary, &data->glyphs[i], first);
        first = false;
    }
    summary->bold = is_bold(data);
    summary->italic = is_italic(data);
}

const char *mt_linked_style(const mt_summary *summary) {
    static const char *const styles[] = {"Regular", "Bold", "Italic", "Bold Italic"};
    return styles[(summary->bold ? 1 : 0) + (summary->italic ? 2 : 0)];
}
