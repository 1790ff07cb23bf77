/* What several tables need to know of all glyphs, and of the style. */
#include "write/tables.h"

#include <string.h>

#include "write/style.h"

static int min(int a, int b) {
    return a < b ? a : b;
}

static int max(int a, int b) {
    return a > b ? a : b;
}

static void add_bounds(mt_summary *summary, const mt_glyf *glyph, const mt_extent *extent, bool first) {
    const mt_bounds *bounds = &extent->bounds;
    mt_bounds *all = &summary->bounds;
    int right = glyph->advance - bounds->x_max;
    summary->min_left = first ? bounds->x_min : min(summary->min_left, bounds->x_min);
    summary->min_right = first ? right : min(summary->min_right, right);
    summary->max_extent = first ? bounds->x_max : max(summary->max_extent, bounds->x_max);
    if (first) *all = *bounds;
    all->x_min = min(all->x_min, bounds->x_min);
    all->y_min = min(all->y_min, bounds->y_min);
    all->x_max = max(all->x_max, bounds->x_max);
    all->y_max = max(all->y_max, bounds->y_max);
}

static void add_vertical(mt_summary *summary, const mt_glyf *glyph, const mt_extent *extent, bool first) {
    int top = mt_top_bearing(glyph, extent), reach = top + extent->bounds.y_max - extent->bounds.y_min;
    int bottom = glyph->height - reach;
    summary->min_top = first ? top : min(summary->min_top, top);
    summary->min_bottom = first ? bottom : min(summary->min_bottom, bottom);
    summary->max_vertical_extent = first ? reach : max(summary->max_vertical_extent, reach);
}

static void add_counts(mt_summary *summary, const mt_glyf *glyph, const mt_extent *extent) {
    bool composite = glyph->reference_count > 0;
    int *points = composite ? &summary->max_composite_points : &summary->max_points;
    int *contours = composite ? &summary->max_composite_contours : &summary->max_contours;
    *points = max(*points, extent->points);
    *contours = max(*contours, extent->contours);
    summary->max_references = max(summary->max_references, glyph->reference_count);
    summary->max_depth = max(summary->max_depth, extent->depth);
}

/* A style whose name has a weight or a slope says so itself; any other is judged by its figures. */
void mt_summarise_style(const mt_font_data *data, mt_summary *summary) {
    const mt_style style = mt_style_read(data->style);
    double angle = data->metrics.italic_angle;
    summary->bold = style.is_linked ? style.bold : data->metrics.weight_class >= 700;
    summary->italic = style.is_linked ? style.italic : angle < 0 || angle > 0;
    summary->own_style = style.is_linked ? style.own : strlen(data->style);
}

void mt_summarise(const mt_font_data *data, mt_summary *summary) {
    bool first = true;
    for (int i = 0; i < data->glyph_count; i++) {
        const mt_glyf *glyph = &data->glyphs[i];
        const mt_extent *extent = &summary->extents[i];
        summary->max_advance = max(summary->max_advance, glyph->advance);
        summary->max_height = max(summary->max_height, glyph->height);
        if (extent->points == 0) continue;
        add_bounds(summary, glyph, extent, first);
        add_vertical(summary, glyph, extent, first);
        add_counts(summary, glyph, extent);
        first = false;
    }
    mt_summarise_style(data, summary);
}

const char *mt_linked_style(const mt_summary *summary) {
    static const char *const styles[] = {"Regular", "Bold", "Italic", "Bold Italic"};
    return styles[(summary->bold ? 1 : 0) + (summary->italic ? 2 : 0)];
}
