#include "write/extent.h"

#include <limits.h>

#include "geometry/limits.h"

enum { UNKNOWN = -1 }; /* a depth */

const mt_bounds mt_no_bounds = {INT_MAX, INT_MAX, INT_MIN, INT_MIN};

static int min(int a, int b) {
    return a < b ? a : b;
}

static int max(int a, int b) {
    return a > b ? a : b;
}

int mt_glyf_point_count(const mt_glyf *glyph) {
    return glyph->contour_count ? glyph->ends[glyph->contour_count - 1] + 1 : 0;
}

mt_bounds mt_bounds_join(mt_bounds a, mt_bounds b) {
    return (mt_bounds){min(a.x_min, b.x_min), min(a.y_min, b.y_min), max(a.x_max, b.x_max),
                       max(a.y_max, b.y_max)};
}

mt_bounds mt_bounds_move(mt_bounds b, int dx, int dy) {
    if (mt_bounds_empty(b)) return b;
    return (mt_bounds){b.x_min + dx, b.y_min + dy, b.x_max + dx, b.y_max + dy};
}

/* ---- one glyph ----------------------------------------------------------------------------------------- */

static void add_points(const mt_glyf *glyph, mt_extent *extent) {
    extent->points = mt_glyf_point_count(glyph);
    extent->contours = glyph->contour_count;
    for (int i = 0; i < extent->points; i++) {
        int x = glyph->points[i].x, y = glyph->points[i].y;
        extent->bounds = mt_bounds_join(extent->bounds, (mt_bounds){x, y, x, y});
    }
}

static void add_reference(const mt_glyf_reference *reference, const mt_extent *part, mt_extent *extent) {
    extent->depth = max(extent->depth, part->depth + 1);
    if (part->points == 0) return;
    extent->points += part->points;
    extent->contours += part->contours;
    extent->bounds =
        mt_bounds_join(extent->bounds, mt_bounds_move(part->bounds, reference->dx, reference->dy));
}

static bool fits(const mt_extent *extent) {
    const mt_bounds *b = &extent->bounds;
    return extent->points <= MT_GLYF_POINTS_MAX && extent->contours <= MT_GLYF_CONTOURS_MAX &&
           b->x_min >= INT16_MIN && b->y_min >= INT16_MIN && b->x_max <= INT16_MAX && b->y_max <= INT16_MAX;
}

mt_status mt_glyf_extent(const mt_glyf *glyph, const mt_extent *extents, mt_extent *extent) {
    mt_extent made = {.bounds = mt_no_bounds};
    add_points(glyph, &made);
    for (int i = 0; i < glyph->reference_count; i++) {
        add_reference(&glyph->references[i], &extents[glyph->references[i].glyph], &made);
        if (made.points > 0 && !fits(&made)) return MT_TOO_LARGE;
    }
    if (made.points == 0) made.bounds = (mt_bounds){0};
    *extent = made;
    return MT_OK;
}

/* ---- all glyphs ---------------------------------------------------------------------------------------- */

static mt_status check_references(const mt_glyf *glyphs, int count) {
    for (int i = 0; i < count; i++)
        for (int k = 0; k < glyphs[i].reference_count; k++)
            if (glyphs[i].references[k].glyph >= count) return MT_BAD_PARAMETER;
    return MT_OK;
}

static bool is_ready(const mt_glyf *glyph, const mt_extent *extents) {
    for (int k = 0; k < glyph->reference_count; k++)
        if (extents[glyph->references[k].glyph].depth == UNKNOWN) return false;
    return true;
}

/* Those glyphs that are not known yet and refer to known ones only. Returns how many remain. */
static int fill_ready(const mt_glyf *glyphs, int count, mt_extent *extents, mt_status *status) {
    int remaining = 0;
    for (int i = 0; i < count && *status == MT_OK; i++) {
        if (extents[i].depth != UNKNOWN) continue;
        bool ready = is_ready(&glyphs[i], extents);
        if (ready) *status = mt_glyf_extent(&glyphs[i], extents, &extents[i]);
        if (ready && extents[i].depth > MT_GLYF_DEPTH_MAX) *status = MT_BAD_PARAMETER;
        remaining += !ready;
    }
    return remaining;
}

/* A round knows all glyphs of one more depth at least. */
mt_status mt_extents_fill(const mt_glyf *glyphs, int count, mt_extent *extents) {
    mt_status status = check_references(glyphs, count);
    int remaining = count;
    for (int i = 0; i < count; i++) extents[i].depth = UNKNOWN;
    for (int round = 0; round <= MT_GLYF_DEPTH_MAX && remaining > 0 && status == MT_OK; round++)
        remaining = fill_ready(glyphs, count, extents, &status);
    if (status == MT_OK && remaining > 0) return MT_BAD_PARAMETER;
    return status;
}
