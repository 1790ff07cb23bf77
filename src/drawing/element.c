#include "drawing/element.h"

#include <math.h>
#include <string.h>

#include "arithmetic/angles.h"
#include "base/real.h"
#include "drawing/path_text.h"
#include "drawing/scan.h"

const char *mt_element_attribute(const xmlNode *element, const char *name) {
    for (const xmlAttr *a = element->properties; a; a = a->next)
        if (strcmp((const char *)a->name, name) == 0 && a->children && a->children->type == XML_TEXT_NODE)
            return (const char *)a->children->content;
    return NULL;
}

double mt_element_length(const xmlNode *element, const char *name, double whole, double without) {
    const char *text = mt_element_attribute(element, name);
    double length;
    return text && mt_scan_length(text, whole, &length) ? length : without;
}

/* An ellipse from its right end on, clockwise on the page. */
static void draw_ellipse(mt_pen *pen, double x, double y, double rx, double ry) {
    if (!(rx > 0 && ry > 0)) return;
    mt_pen_move(pen, x + rx, y);
    mt_pen_arc(pen, rx, ry, 0, false, true, x - rx, y);
    mt_pen_arc(pen, rx, ry, 0, false, true, x + rx, y);
    mt_pen_close(pen);
}

static void draw_rounded(mt_pen *pen, double x, double y, double width, double height, double rx, double ry) {
    double right = x + width, bottom = y + height;
    mt_pen_move(pen, x + rx, y);
    mt_pen_line(pen, right - rx, y);
    mt_pen_arc(pen, rx, ry, 0, false, true, right, y + ry);
    mt_pen_line(pen, right, bottom - ry);
    mt_pen_arc(pen, rx, ry, 0, false, true, right - rx, bottom);
    mt_pen_line(pen, x + rx, bottom);
    mt_pen_arc(pen, rx, ry, 0, false, true, x, bottom - ry);
    mt_pen_line(pen, x, y + ry);
    mt_pen_arc(pen, rx, ry, 0, false, true, x + rx, y);
    mt_pen_close(pen);
}

/* A radius that is not given is the other one; neither is more than half a side. */
static void draw_rect(const xmlNode *element, double across, double down, mt_pen *pen) {
    double x = mt_element_length(element, "x", across, 0), y = mt_element_length(element, "y", down, 0);
    double width = mt_element_length(element, "width", across, 0);
    double height = mt_element_length(element, "height", down, 0);
    double rx = mt_element_length(element, "rx", across, -1), ry = mt_element_length(element, "ry", down, -1);
    if (!(width > 0 && height > 0)) return;
    if (rx < 0) rx = ry;
    if (ry < 0) ry = rx;
    draw_rounded(pen, x, y, width, height, fmin(fmax(rx, 0), width / 2), fmin(fmax(ry, 0), height / 2));
}

static void draw_circle(const xmlNode *element, double across, double down, mt_pen *pen) {
    double r = mt_element_length(element, "r", mt_hypot(across, down) / sqrt(2), 0);
    draw_ellipse(pen, mt_element_length(element, "cx", across, 0), mt_element_length(element, "cy", down, 0),
                 r, r);
}

static void draw_oval(const xmlNode *element, double across, double down, mt_pen *pen) {
    double rx = mt_element_length(element, "rx", across, -1), ry = mt_element_length(element, "ry", down, -1);
    if (rx < 0) rx = ry;
    if (ry < 0) ry = rx;
    draw_ellipse(pen, mt_element_length(element, "cx", across, 0), mt_element_length(element, "cy", down, 0),
                 rx, ry);
}

/* Up to the first thing that is no pair of numbers. */
static void draw_polygon(const xmlNode *element, double across, double down, mt_pen *pen) {
    const char *at = mt_element_attribute(element, "points");
    (void)across, (void)down;
    if (!at) return;
    mt_scan_blanks(&at);
    for (bool first = true; pen->status == MT_OK; first = false) {
        double x, y;
        if (!mt_real_next(&at, &x)) break;
        mt_scan_comma(&at);
        if (!mt_real_next(&at, &y)) break;
        mt_scan_comma(&at);
        if (first)
            mt_pen_move(pen, x, y);
        else
            mt_pen_line(pen, x, y);
    }
    mt_pen_close(pen);
}

static void draw_path(const xmlNode *element, double across, double down, mt_pen *pen) {
    const char *text = mt_element_attribute(element, "d");
    (void)across, (void)down;
    if (text) mt_path_text_draw(text, pen);
}

static const struct shape {
    const char *name;
    void (*draw)(const xmlNode *element, double across, double down, mt_pen *pen);
} shapes[] = {{"path", draw_path},    {"rect", draw_rect},       {"circle", draw_circle},
              {"ellipse", draw_oval}, {"polygon", draw_polygon}, {"polyline", draw_polygon}};

static const struct shape *find_shape(const char *name) {
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++)
        if (strcmp(name, shapes[i].name) == 0) return &shapes[i];
    return NULL;
}

bool mt_element_is_shape(const char *name) {
    return find_shape(name) != NULL;
}

void mt_element_draw(const xmlNode *element, double width, double height, mt_pen *pen) {
    const struct shape *shape = find_shape((const char *)element->name);
    if (shape) shape->draw(element, width, height, pen);
}
