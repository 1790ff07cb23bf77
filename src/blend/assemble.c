/* Regions of ink that meet are one region of their union: so where two parts meet, the union of all parts has fewer
 * components than the parts have by themselves. Where no two boxes meet nothing is drawn. */
#include "blend/assemble.h"

#include <math.h>

#include "geometry/limits.h"
#include "geometry/union.h"

typedef struct mt_drawer {
    const mt_assembly *font;
    mt_outline outline;
    mt_segment *segments; /* the next free ones */
} mt_drawer;

/* ---- boxes --------------------------------------------------------------------------------------------- */

static bool bounds_meet(mt_bounds a, mt_bounds b) {
    return a.x_min <= b.x_max && b.x_min <= a.x_max && a.y_min <= b.y_max && b.y_min <= a.y_max;
}

bool mt_boxes_meet(const mt_bounds *boxes, int count) {
    for (int i = 0; i < count; i++)
        for (int k = 0; k < i; k++)
            if (bounds_meet(boxes[i], boxes[k])) return true;
    return false;
}

/* Whether the boxes of the parts meet where these are. */
static mt_status look_at_boxes(const mt_glyf *composite, const mt_assembly *font, mt_arena *scratch,
                               bool *meet) {
    mt_bounds *boxes = mt_arena_new(scratch, (size_t)composite->reference_count, sizeof *boxes);
    if (!boxes) return MT_NO_MEMORY;
    for (int i = 0; i < composite->reference_count; i++) {
        const mt_glyf_reference *part = &composite->references[i];
        const mt_extent *extent = &font->extents[part->glyph];
        boxes[i] = extent->points ? mt_bounds_move(extent->bounds, part->dx, part->dy) : mt_no_bounds;
    }
    *meet = mt_boxes_meet(boxes, composite->reference_count);
    return MT_OK;
}

/* ---- a glyph as an outline ----------------------------------------------------------------------------- */

typedef struct mt_location {
    double x, y; /* font units */
} mt_location;

static mt_point on_grid(const mt_drawer *drawer, mt_location place) {
    double scale = (double)MT_EM / drawer->font->units;
    return (mt_point){(int32_t)floor(place.x * scale + 0.5), (int32_t)floor(place.y * scale + 0.5)};
}

/* Where the curve is next to an off-curve point: on the neighbour, or midway to it. */
static mt_location between(const mt_glyf_point *p, const mt_glyf_point *neighbour, mt_location offset) {
    double x = neighbour->on ? neighbour->x : (p->x + neighbour->x) / 2.0;
    double y = neighbour->on ? neighbour->y : (p->y + neighbour->y) / 2.0;
    return (mt_location){x + offset.x, y + offset.y};
}

/* The lines and curves that end after each point of a contour, from the first point on. */
static void draw_contour(mt_drawer *drawer, const mt_glyf_point *points, int count, mt_location offset) {
    mt_contour *contour = &drawer->outline.contours[drawer->outline.count++];
    contour->segments = drawer->segments;
    for (int i = 0; i < count; i++) {
        const mt_glyf_point *p = &points[i], *before = &points[(i + count - 1) % count];
        mt_location at = {p->x + offset.x, p->y + offset.y};
        mt_segment segment = {.degree = 1, .end = on_grid(drawer, at)};
        if (p->on && !before->on) continue; /* the curve before ends here */
        if (!p->on) {
            segment.degree = 2;
            segment.control[0] = segment.end;
            segment.end = on_grid(drawer, between(p, &points[(i + 1) % count], offset));
        }
        contour->segments[contour->count++] = segment;
    }
    drawer->segments += contour->count;
}

/* Blank parts are passed over, so that no more steps are taken than there are points. */
static void draw_glyph(mt_drawer *drawer, uint16_t index, mt_location offset) {
    const mt_glyf *glyph = &drawer->font->glyphs[index];
    if (drawer->font->extents[index].points == 0) return;
    for (int i = 0, start = 0; i < glyph->contour_count; start = glyph->ends[i++] + 1)
        draw_contour(drawer, glyph->points + start, glyph->ends[i] + 1 - start, offset);
    for (int i = 0; i < glyph->reference_count; i++) {
        const mt_glyf_reference *part = &glyph->references[i];
        draw_glyph(drawer, part->glyph, (mt_location){offset.x + part->dx, offset.y + part->dy});
    }
}

/* ---- regions ------------------------------------------------------------------------------------------- */

static mt_status count_regions(const mt_drawer *drawer, const mt_outline *outline, mt_arena *scratch,
                               int *count) {
    mt_shape shape;
    bool clean;
    double tolerance = mt_grid_units(drawer->font->row->params.tolerance) / MT_OVERLAP_CARE;
    mt_status status = mt_outline_resolve(outline, tolerance, scratch, &shape, &clean);
    if (status == MT_OK) *count = shape.count;
    return status;
}

static mt_status start_drawing(mt_drawer *drawer, const mt_glyf *composite, mt_arena *scratch) {
    int points = 0, contours = 0;
    for (int i = 0; i < composite->reference_count; i++) {
        points += drawer->font->extents[composite->references[i].glyph].points;
        contours += drawer->font->extents[composite->references[i].glyph].contours;
    }
    drawer->outline.contours = mt_arena_new(scratch, (size_t)contours, sizeof(mt_contour));
    drawer->segments = mt_arena_new(scratch, (size_t)points, sizeof(mt_segment));
    return drawer->outline.contours && drawer->segments ? MT_OK : MT_NO_MEMORY;
}

/* Whether two parts overlap, or touch. As mt_flatten and mt_union. */
static mt_status parts_touch(const mt_glyf *composite, const mt_assembly *font, mt_arena *scratch,
                             bool *touch) {
    mt_drawer drawer = {.font = font};
    int apart = 0, together = 0;
    mt_status status = look_at_boxes(composite, font, scratch, touch);
    if (status != MT_OK || !*touch) return status;
    status = start_drawing(&drawer, composite, scratch);
    for (int i = 0; i < composite->reference_count && status == MT_OK; i++) {
        const mt_glyf_reference *part = &composite->references[i];
        int first = drawer.outline.count, regions = 0;
        draw_glyph(&drawer, part->glyph, (mt_location){part->dx, part->dy});
        mt_outline drawn = {drawer.outline.count - first, drawer.outline.contours + first};
        status = count_regions(&drawer, &drawn, scratch, &regions);
        apart += regions;
    }
    if (status == MT_OK) status = count_regions(&drawer, &drawer.outline, scratch, &together);
    if (status == MT_OK) *touch = together < apart;
    return status;
}

/* ---- the composite ------------------------------------------------------------------------------------- */

/* Whether the composite takes the same room in the line as a part that is where it is by itself. */
static bool has_metrics_of(const mt_glyf *glyph, const mt_glyf_reference *reference, const mt_glyf *part) {
    return reference->dx == 0 && reference->dy == 0 && glyph->advance == part->advance &&
           glyph->height == part->height && glyph->origin == part->origin;
}

/* False for an offset that is too large. Of several parts that give the metrics the first is marked. */
static bool place(const mt_composite *composite, const mt_assembly *font, const mt_glyf *glyph,
                  mt_glyf_reference *references) {
    bool given = false;
    for (int i = 0; i < composite->count; i++) {
        const mt_row_reference *moving = &composite->references[i];
        mt_glyf_reference *made = &references[i];
        made->glyph = moving->glyph;
        if (!mt_reference_at(font->row, moving, 0, font->at, font->units, &made->dx, &made->dy)) return false;
        made->same_metrics = !given && has_metrics_of(glyph, made, &font->glyphs[made->glyph]);
        given = given || made->same_metrics;
    }
    return true;
}

mt_status mt_composite_assemble(const mt_composite *composite, const mt_assembly *font, mt_arena *kept,
                                mt_arena *scratch, mt_glyf *glyph, mt_extent *extent) {
    mt_glyf made = *glyph;
    mt_extent reach = {0};
    bool touch = false;
    made.reference_count = composite->count;
    made.references = mt_arena_new(kept, (size_t)composite->count, sizeof *made.references);
    if (!made.references) return MT_NO_MEMORY;
    if (!place(composite, font, glyph, made.references)) return MT_OK;
    mt_status status = mt_glyf_extent(&made, font->extents, &reach);
    if (status == MT_OK) status = parts_touch(&made, font, scratch, &touch);
    if (status == MT_NO_MEMORY) return status;
    if (status != MT_OK || touch || reach.points == 0) return MT_OK;
    *glyph = made;
    *extent = reach;
    return MT_OK;
}
