/* A glyph as a GLIF document, format 2. */
#include <math.h>
#include <stdio.h>

#include "arithmetic/angles.h"
#include "save/ufo_parts.h"

/* A curve goes on through the point without a corner, as far as whole units tell: its neighbours are in line with it
 * within a unit, and within 10°. */
static bool is_smooth(mt_glyf_point before, mt_glyf_point p, mt_glyf_point after) {
    double ax = p.x - before.x, ay = p.y - before.y, bx = after.x - p.x, by = after.y - p.y;
    double cross = ax * by - ay * bx, dot = ax * bx + ay * by;
    if (!p.on || (before.on && after.on) || dot <= 0) return false;
    return fabs(cross) <= mt_hypot(ax + bx, ay + by) && fabs(cross) <= mt_tan(10 * M_PI / 180) * dot;
}

/* `type` is NULL for a control. */
static void write_place(int x, int y, const char *type, bool smooth, mt_xml *xml) {
    mt_xml_open(xml, "point");
    mt_xml_number(xml, "x", x);
    mt_xml_number(xml, "y", y);
    if (type) mt_xml_attribute(xml, "type", type);
    if (smooth) mt_xml_attribute(xml, "smooth", "yes");
    mt_xml_close(xml);
}

static void write_point(mt_glyf_point before, mt_glyf_point p, mt_glyf_point after, mt_curves curves,
                        mt_xml *xml) {
    const char *curve = curves == MT_CURVES_CUBIC ? "curve" : "qcurve";
    write_place(p.x, p.y, !p.on ? NULL : before.on ? "line" : curve, is_smooth(before, p, after), xml);
}

/* ---- cubic curves ----------------------------------------------------------------------------------------- */

/* Between two points off the curve one lies on it. */
static mt_vector between(mt_glyf_point p, mt_glyf_point q) {
    return (mt_vector){(p.x + q.x) / 2.0, (p.y + q.y) / 2.0};
}

static mt_vector end_beside(mt_glyf_point control, mt_glyf_point neighbour) {
    return neighbour.on ? (mt_vector){neighbour.x, neighbour.y} : between(control, neighbour);
}

/* A quadratic's controls as a cubic has them: two thirds of the way from each end to its one. */
static void write_control(mt_vector end, mt_glyf_point control, mt_xml *xml) {
    write_place((int)lround((end.x + 2.0 * control.x) / 3), (int)lround((end.y + 2.0 * control.y) / 3), NULL,
                false, xml);
}

/* In place of a point off the curve: both controls, and the end that quadratics leave implied, in whole units. */
static void write_cubic(mt_glyf_point before, mt_glyf_point p, mt_glyf_point after, mt_xml *xml) {
    mt_vector end = end_beside(p, after);
    write_control(end_beside(p, before), p, xml);
    write_control(end, p, xml);
    if (!after.on) write_place((int)lround(end.x), (int)lround(end.y), "curve", true, xml);
}

/* Closed contours have no first point: a curve may lie about the end of the list. */
static void write_contour(const mt_glyf_point *points, int count, mt_curves curves, mt_xml *xml) {
    mt_xml_open(xml, "contour");
    for (int i = 0; i < count; i++) {
        mt_glyf_point before = points[(i + count - 1) % count], after = points[(i + 1) % count];
        if (curves == MT_CURVES_CUBIC && !points[i].on)
            write_cubic(before, points[i], after, xml);
        else
            write_point(before, points[i], after, curves, xml);
    }
    mt_xml_close(xml);
}

static void write_code_points(const mt_ufo_glyphs *glyphs, int glyph, mt_xml *xml) {
    for (int i = glyphs->starts[glyph]; i < glyphs->starts[glyph + 1]; i++) {
        char hex[16];
        snprintf(hex, sizeof hex, "%04X", (unsigned)glyphs->code_points[i]);
        mt_xml_open(xml, "unicode");
        mt_xml_attribute(xml, "hex", hex);
        mt_xml_close(xml);
    }
}

static void write_reference(const mt_glyf_reference *reference, const mt_ufo_glyphs *glyphs, mt_xml *xml) {
    mt_xml_open(xml, "component");
    mt_xml_attribute(xml, "base", glyphs->names[reference->glyph]);
    if (reference->dx) mt_xml_number(xml, "xOffset", reference->dx);
    if (reference->dy) mt_xml_number(xml, "yOffset", reference->dy);
    mt_xml_close(xml);
}

static void write_outline(const mt_glyf *glyf, const mt_ufo_glyphs *glyphs, mt_curves curves, mt_xml *xml) {
    mt_xml_open(xml, "outline");
    for (int i = 0; i < glyf->reference_count; i++) write_reference(&glyf->references[i], glyphs, xml);
    for (int i = 0, start = 0; i < glyf->contour_count; start = glyf->ends[i++] + 1)
        write_contour(glyf->points + start, glyf->ends[i] + 1 - start, curves, xml);
    mt_xml_close(xml);
}

/* Those of the glyph stand one after another. */
static void write_anchors(const mt_fea *fea, int glyph, mt_xml *xml) {
    int low = 0, high = fea->anchor_count;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (fea->anchors[middle].glyph < glyph)
            low = middle + 1;
        else
            high = middle;
    }
    for (int i = low; i < fea->anchor_count && fea->anchors[i].glyph == glyph; i++) {
        mt_xml_open(xml, "anchor");
        mt_xml_number(xml, "x", fea->anchors[i].x);
        mt_xml_number(xml, "y", fea->anchors[i].y);
        mt_xml_attribute(xml, "name", fea->anchors[i].name);
        mt_xml_close(xml);
    }
}

static void write_origin(int origin, mt_xml *xml) {
    mt_xml_open(xml, "lib");
    mt_xml_open(xml, "dict");
    mt_plist_integer(xml, "public.verticalOrigin", origin);
    mt_xml_close(xml);
    mt_xml_close(xml);
}

void mt_ufo_glif(const mt_font_data *data, const mt_ufo_glyphs *glyphs, const mt_fea *fea, int glyph,
                 mt_xml *xml) {
    const mt_glyf *glyf = &data->glyphs[glyph];
    mt_xml_open(xml, "glyph");
    mt_xml_attribute(xml, "name", glyphs->names[glyph]);
    mt_xml_number(xml, "format", 2);
    mt_xml_open(xml, "advance");
    mt_xml_number(xml, "width", glyf->advance);
    if (data->metrics.vertical) mt_xml_number(xml, "height", glyf->height);
    mt_xml_close(xml);
    write_code_points(glyphs, glyph, xml);
    write_anchors(fea, glyph, xml);
    write_outline(glyf, glyphs, data->curves, xml);
    if (data->metrics.vertical) write_origin(glyf->origin, xml);
    mt_xml_close(xml);
}
