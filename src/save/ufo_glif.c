/* A glyph as a GLIF document, format 2. */
#include <math.h>
#include <stdio.h>

#include "save/ufo_parts.h"

/* A curve goes on through the point without a corner, as far as whole units tell: its neighbours are in line with it
 * within a unit, and within 10°. */
static bool is_smooth(mt_glyf_point before, mt_glyf_point p, mt_glyf_point after) {
    double ax = p.x - before.x, ay = p.y - before.y, bx = after.x - p.x, by = after.y - p.y;
    double cross = ax * by - ay * bx, dot = ax * bx + ay * by;
    if (!p.on || (before.on && after.on) || dot <= 0) return false;
    return fabs(cross) <= hypot(ax + bx, ay + by) && fabs(cross) <= tan(10 * acos(-1) / 180) * dot;
}

static void write_point(mt_glyf_point before, mt_glyf_point p, mt_glyf_point after, mt_xml *xml) {
    mt_xml_open(xml, "point");
    mt_xml_number(xml, "x", p.x);
    mt_xml_number(xml, "y", p.y);
    if (p.on) mt_xml_attribute(xml, "type", before.on ? "line" : "qcurve");
    if (is_smooth(before, p, after)) mt_xml_attribute(xml, "smooth", "yes");
    mt_xml_close(xml);
}

/* Closed contours have no first point: a curve may lie about the end of the list. */
static void write_contour(const mt_glyf_point *points, int count, mt_xml *xml) {
    mt_xml_open(xml, "contour");
    for (int i = 0; i < count; i++)
        write_point(points[(i + count - 1) % count], points[i], points[(i + 1) % count], xml);
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

static void write_outline(const mt_glyf *glyf, const mt_ufo_glyphs *glyphs, mt_xml *xml) {
    mt_xml_open(xml, "outline");
    for (int i = 0; i < glyf->reference_count; i++) write_reference(&glyf->references[i], glyphs, xml);
    for (int i = 0, start = 0; i < glyf->contour_count; start = glyf->ends[i++] + 1)
        write_contour(glyf->points + start, glyf->ends[i] + 1 - start, xml);
    mt_xml_close(xml);
}

static void write_origin(int origin, mt_xml *xml) {
    mt_xml_open(xml, "lib");
    mt_xml_open(xml, "dict");
    mt_plist_integer(xml, "public.verticalOrigin", origin);
    mt_xml_close(xml);
    mt_xml_close(xml);
}

void mt_ufo_glif(const mt_font_data *data, const mt_ufo_glyphs *glyphs, int glyph, mt_xml *xml) {
    const mt_glyf *glyf = &data->glyphs[glyph];
    mt_xml_open(xml, "glyph");
    mt_xml_attribute(xml, "name", glyphs->names[glyph]);
    mt_xml_number(xml, "format", 2);
    mt_xml_open(xml, "advance");
    mt_xml_number(xml, "width", glyf->advance);
    if (data->metrics.vertical) mt_xml_number(xml, "height", glyf->height);
    mt_xml_close(xml);
    write_code_points(glyphs, glyph, xml);
    write_outline(glyf, glyphs, xml);
    if (data->metrics.vertical) write_origin(glyf->origin, xml);
    mt_xml_close(xml);
}
