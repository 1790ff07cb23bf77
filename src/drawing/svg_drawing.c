#include "drawing/svg_drawing.h"

#include <libxml/hash.h>
#include <math.h>
#include <string.h>

#include "drawing/element.h"
#include "drawing/pen.h"
#include "drawing/style_sheet.h"
#include "drawing/xml_tree.h"
#include "geometry/limits.h"

/* Elements that are looked at, those that use elements show again each time. */
#define ELEMENTS_MAX 65536

/* Bytes of attributes, those of elements that are used again each time, and of class for each rule of a style sheet. */
#define BYTES_MAX ((size_t)1 << 28)

#define SVG_NAMESPACE "http://www.w3.org/2000/svg"
#define TOO_DEEP "its elements are nested over 100 levels deep"

typedef struct mt_svg_reading {
    xmlHashTable *by_id;
    mt_style_sheet sheet;
    mt_pen pen;
    int elements, depth;
    size_t bytes; /* of attributes that are read, as often as they are */
    mt_view view; /* around the element at hand, for shares in per cent */
    int colours;  /* of what is drawn: 0, 1, or 2 for more */
    mt_colour colour;
    unsigned left_out;
    mt_status status;
    const char *problem;
} mt_svg_reading;

static bool is_named(const xmlNode *node, const char *name) {
    return strcmp((const char *)node->name, name) == 0;
}

static bool is_svg(const xmlNode *node) {
    return node->type == XML_ELEMENT_NODE &&
           (!node->ns || strcmp((const char *)node->ns->href, SVG_NAMESPACE) == 0);
}

/* ---- styles ---------------------------------------------------------------------------------------------- */

static mt_style style_of(const mt_svg_reading *r, const xmlNode *element, const mt_style *parent) {
    mt_style style = mt_style_inherited(parent);
    const char *declarations = mt_element_attribute(element, "style");
    for (const xmlAttr *a = element->properties; a; a = a->next) {
        if (!a->children || a->children->type != XML_TEXT_NODE) continue;
        if (strncmp((const char *)a->name, "on", 2) == 0) style.left_out |= MT_LEFT_SCRIPTS;
        mt_style_set(&style, (const char *)a->name, (const char *)a->children->content);
    }
    mt_style_sheet_apply(&r->sheet, element, &style);
    if (declarations) mt_style_set_all(&style, declarations);
    return style;
}

/* What is not drawn, by its element. */
static unsigned left_out_of(const xmlNode *element) {
    static const struct {
        const char *name;
        mt_left_out kind;
    } kinds[] = {{"text", MT_LEFT_TEXT},
                 {"image", MT_LEFT_IMAGES},
                 {"script", MT_LEFT_SCRIPTS},
                 {"foreignObject", MT_LEFT_FOREIGN},
                 {"animate", MT_LEFT_ANIMATIONS},
                 {"animateTransform", MT_LEFT_ANIMATIONS},
                 {"animateMotion", MT_LEFT_ANIMATIONS},
                 {"set", MT_LEFT_ANIMATIONS}};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (is_named(element, kinds[i].name)) return kinds[i].kind;
    return 0;
}

static void note_colour(mt_svg_reading *r, mt_colour colour) {
    if (r->colours == 0) r->colour = colour;
    if (memcmp(&colour, &r->colour, sizeof colour) != 0) r->colours = 2;
    if (r->colours == 0) r->colours = 1;
}

/* ---- elements -------------------------------------------------------------------------------------------- */

static void read_element(mt_svg_reading *r, const xmlNode *element, const mt_style *parent);

static void read_children(mt_svg_reading *r, const xmlNode *element, const mt_style *style) {
    for (const xmlNode *child = element->children; child && r->status == MT_OK; child = child->next)
        if (is_svg(child)) read_element(r, child, style);
}

static void read_shape(mt_svg_reading *r, const xmlNode *element, const mt_style *style) {
    if (!style->visible) return;
    if (style->stroke != MT_PAINT_NONE && style->stroke_width > 0) r->left_out |= MT_LEFT_STROKES;
    if (style->fill == MT_PAINT_SERVER) r->left_out |= MT_LEFT_GRADIENTS;
    bool solid = style->fill == MT_PAINT_COLOUR || style->fill == MT_PAINT_CURRENT;
    if (!solid || !(style->fill_opacity > 0)) return;
    if (style->fill_opacity < 1) r->left_out |= MT_LEFT_OPACITY;
    int before = r->pen.segment_count;
    mt_pen_layer_begin(&r->pen, style->rule);
    mt_element_draw(element, r->view.width, r->view.height, &r->pen);
    r->status = r->pen.status;
    if (r->pen.segment_count > before)
        note_colour(r, style->fill == MT_PAINT_CURRENT ? style->current : style->colour);
}

/* What has a view of its own: the inner svg, and a symbol that is used. `place` is where it is shown. */
static void read_view(mt_svg_reading *r, const xmlNode *element, const mt_view *place,
                      const mt_style *style) {
    const char *box = mt_element_attribute(element, "viewBox");
    const char *aspect = mt_element_attribute(element, "preserveAspectRatio");
    mt_view inner = {0, 0, place->width, place->height}, before = r->view;
    if (!(place->width > 0 && place->height > 0)) return;
    if (box) mt_view_read(box, &inner);
    mt_affine map = mt_view_map(place, &inner, aspect && strcmp(aspect, "none") == 0);
    r->pen.map = mt_affine_after(&r->pen.map, &map);
    r->view = inner;
    read_children(r, element, style);
    r->view = before;
}

static mt_view place_of(const mt_svg_reading *r, const xmlNode *element) {
    double width = r->view.width, height = r->view.height;
    return (mt_view){mt_element_length(element, "x", width, 0), mt_element_length(element, "y", height, 0),
                     mt_element_length(element, "width", width, width),
                     mt_element_length(element, "height", height, height)};
}

static void read_use(mt_svg_reading *r, const xmlNode *element, const mt_style *style) {
    const char *target = mt_element_attribute(element, "href");
    if (!target) return;
    if (*target != '#') {
        r->left_out |= MT_LEFT_REFERENCES;
        return;
    }
    const xmlNode *used = xmlHashLookup(r->by_id, BAD_CAST(target + 1));
    mt_view place = place_of(r, element);
    if (!used || !is_svg(used)) return;
    if (is_named(used, "symbol")) {
        mt_style own = style_of(r, used, style);
        read_view(r, used, &place, &own);
        return;
    }
    const mt_affine moved = {1, 0, 0, 1, place.x, place.y};
    r->pen.map = mt_affine_after(&r->pen.map, &moved);
    read_element(r, used, style);
}

static void read_shown(mt_svg_reading *r, const xmlNode *element, const mt_style *style) {
    mt_view place;
    if (mt_element_is_shape((const char *)element->name)) {
        read_shape(r, element, style);
    } else if (is_named(element, "g") || is_named(element, "a") || is_named(element, "switch")) {
        read_children(r, element, style);
    } else if (is_named(element, "use")) {
        read_use(r, element, style);
    } else if (is_named(element, "svg")) {
        place = place_of(r, element);
        read_view(r, element, &place, style);
    } else {
        return;
    }
    r->left_out |= style->left_out;
}

static size_t bytes_of(const mt_svg_reading *r, const xmlNode *element) {
    size_t bytes = 0;
    for (const xmlAttr *a = element->properties; a; a = a->next) {
        size_t times = strcmp((const char *)a->name, "class") == 0 ? (size_t)r->sheet.count + 1 : 1;
        if (a->children && a->children->type == XML_TEXT_NODE)
            bytes += strlen((const char *)a->children->content) * times;
    }
    return bytes;
}

static void read_element(mt_svg_reading *r, const xmlNode *element, const mt_style *parent) {
    mt_affine before = r->pen.map, own;
    const char *transform = mt_element_attribute(element, "transform");
    if (r->depth >= MT_XML_DEPTH_MAX) {
        r->problem = TOO_DEEP;
        r->status = MT_BAD_DRAWING;
        return;
    }
    r->bytes += bytes_of(r, element);
    if (++r->elements > ELEMENTS_MAX || r->bytes > BYTES_MAX) {
        r->status = MT_TOO_LARGE;
        return;
    }
    mt_style style = style_of(r, element, parent);
    r->left_out |= left_out_of(element);
    if (!style.shown) return;
    if (transform && mt_transform_read(transform, &own)) r->pen.map = mt_affine_after(&r->pen.map, &own);
    r->depth++;
    read_shown(r, element, &style);
    r->depth--;
    r->pen.map = before;
}

/* ---- the page --------------------------------------------------------------------------------------------- */

static void take_in(mt_vector p, mt_vector *low, mt_vector *high) {
    *low = (mt_vector){fmin(low->x, p.x), fmin(low->y, p.y)};
    *high = (mt_vector){fmax(high->x, p.x), fmax(high->y, p.y)};
}

/* The box around all points. */
static mt_view box_of(const mt_pen *pen) {
    mt_vector low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
    for (int i = 0; i < pen->contour_count; i++) take_in(pen->contours[i].start, &low, &high);
    for (int i = 0; i < pen->segment_count; i++) {
        const mt_pen_segment *s = &pen->segments[i];
        take_in(s->end, &low, &high);
        for (int k = 0; k < s->degree - 1; k++) take_in(s->control[k], &low, &high);
    }
    return (mt_view){low.x, low.y, high.x - low.x, high.y - low.y};
}

/* The view that the outermost element asks for; false where its drawing has to tell. */
static bool find_view(const xmlNode *root, mt_view *view) {
    const char *box = mt_element_attribute(root, "viewBox");
    if (box && mt_view_read(box, view)) return true;
    *view = (mt_view){0, 0, mt_element_length(root, "width", 0, 0), mt_element_length(root, "height", 0, 0)};
    return view->width > 0 && view->height > 0;
}

/* From the page to the grid (svg_drawing.h). */
typedef struct mt_grid_map {
    double x, y, scale; /* the middle of the view; grid units of a page's */
} mt_grid_map;

static mt_status to_grid(const mt_grid_map *map, mt_vector p, mt_point *point) {
    double x = round((p.x - map->x) * map->scale), y = round((map->y - p.y) * map->scale) + MT_EM * 3.0 / 8;
    if (!(fabs(x) <= MT_COORD_MAX && fabs(y) <= MT_COORD_MAX)) return MT_TOO_LARGE;
    *point = (mt_point){(int32_t)x, (int32_t)y};
    return MT_OK;
}

/* A contour on the grid, closed; empty where all of it is one point. */
static mt_status close_contour(const mt_pen *pen, const mt_pen_contour *from, const mt_grid_map *map,
                               mt_arena *arena, mt_contour *contour) {
    mt_point start, at;
    mt_status status = to_grid(map, from->start, &start);
    *contour = (mt_contour){0, mt_arena_new(arena, (size_t)from->count + 1, sizeof *contour->segments)};
    if (!contour->segments) return MT_NO_MEMORY;
    at = start;
    for (int i = 0; i < from->count && status == MT_OK; i++) {
        const mt_pen_segment *s = &pen->segments[from->first + i];
        mt_segment segment = {.degree = s->degree};
        status = to_grid(map, s->end, &segment.end);
        bool still = mt_point_equal(at, segment.end);
        for (int k = 0; k < s->degree - 1 && status == MT_OK; k++) {
            status = to_grid(map, s->control[k], &segment.control[k]);
            still = still && mt_point_equal(at, segment.control[k]);
        }
        if (still) continue;
        contour->segments[contour->count++] = segment;
        at = segment.end;
    }
    if (status == MT_OK && !mt_point_equal(at, start))
        contour->segments[contour->count++] = (mt_segment){.degree = 1, .end = start};
    return status;
}

static mt_status make_layer(const mt_pen *pen, const mt_pen_layer *from, const mt_grid_map *map,
                            mt_arena *arena, mt_layer *layer) {
    *layer = (mt_layer){{0, mt_arena_new(arena, (size_t)from->count + 1, sizeof *layer->outline.contours)},
                        from->rule};
    if (!layer->outline.contours) return MT_NO_MEMORY;
    for (int i = 0; i < from->count; i++) {
        mt_contour *contour = &layer->outline.contours[layer->outline.count];
        mt_status status = close_contour(pen, &pen->contours[from->first + i], map, arena, contour);
        if (status != MT_OK) return status;
        layer->outline.count += contour->count > 0;
    }
    return MT_OK;
}

static mt_status make_layers(const mt_svg_reading *r, const mt_view *view, mt_arena *arena,
                             mt_layers *layers) {
    double em = fmax(view->width, view->height);
    mt_grid_map map = {view->x + view->width / 2, view->y + view->height / 2, MT_EM / em};
    *layers = (mt_layers){0, mt_arena_new(arena, (size_t)r->pen.layer_count + 1, sizeof *layers->list)};
    if (!layers->list) return MT_NO_MEMORY;
    if (!isfinite(map.scale) || !(em > 0)) return r->pen.segment_count ? MT_TOO_LARGE : MT_OK;
    for (int i = 0; i < r->pen.layer_count; i++) {
        mt_layer *layer = &layers->list[layers->count];
        mt_status status = make_layer(&r->pen, &r->pen.layers[i], &map, arena, layer);
        if (status != MT_OK) return status;
        layers->count += layer->outline.count > 0;
    }
    return MT_OK;
}

/* ---- the document ----------------------------------------------------------------------------------------- */

bool mt_svg_looks_so(const uint8_t *bytes, size_t length) {
    size_t i = length >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    while (i < length && strchr(" \t\r\n", bytes[i]) && bytes[i]) i++;
    return i < length && bytes[i] == '<';
}

/* The text of an element's children, in the arena. NULL without memory. */
static char *text_of(const xmlNode *element, mt_arena *arena) {
    size_t length = 0;
    for (const xmlNode *child = element->children; child; child = child->next)
        if (child->type == XML_TEXT_NODE) length += strlen((const char *)child->content);
    char *text = mt_arena_new(arena, length + 1, 1), *to = text;
    for (const xmlNode *child = element->children; text && child; child = child->next)
        if (child->type == XML_TEXT_NODE) to = stpcpy(to, (const char *)child->content);
    return text;
}

/* All style elements, wherever they stand. */
static mt_status read_sheets(mt_svg_reading *r, const xmlNode *element, mt_arena *arena) {
    if (is_svg(element) && is_named(element, "style")) {
        char *text = text_of(element, arena);
        return text ? mt_style_sheet_add(text, arena, &r->sheet) : MT_NO_MEMORY;
    }
    mt_status status = MT_OK;
    for (const xmlNode *child = element->children; child && status == MT_OK; child = child->next)
        if (child->type == XML_ELEMENT_NODE) status = read_sheets(r, child, arena);
    return status;
}

/* Of several elements with one id, the first has it. */
static bool list_ids(const xmlNode *element, xmlHashTable *by_id) {
    const char *id = mt_element_attribute(element, "id");
    if (id && !xmlHashLookup(by_id, BAD_CAST id) &&
        xmlHashAddEntry(by_id, BAD_CAST id, (void *)(uintptr_t)element))
        return false;
    for (const xmlNode *child = element->children; child; child = child->next)
        if (child->type == XML_ELEMENT_NODE && !list_ids(child, by_id)) return false;
    return true;
}

static mt_status read_root(mt_svg_reading *r, const xmlNode *root, mt_arena *arena, mt_svg_drawing *drawing) {
    const mt_style initial = mt_style_initial();
    r->sheet.whole = true;
    r->status = read_sheets(r, root, arena);
    if (r->status != MT_OK) return r->status;
    if (!r->sheet.whole) r->left_out |= MT_LEFT_STYLE_SHEETS;
    mt_style style = style_of(r, root, &initial);
    bool has_view = find_view(root, &r->view);
    mt_view view = r->view;
    if (style.shown) read_children(r, root, &style);
    drawing->left_out = r->left_out | style.left_out;
    if (r->status != MT_OK) return r->status;
    if (!has_view) view = box_of(&r->pen);
    mt_status status = make_layers(r, &view, arena, &drawing->layers);
    drawing->one_colour = r->colours == 1;
    drawing->colour = r->colour;
    return status == MT_OK && drawing->layers.count == 0 ? MT_BLANK : status;
}

static mt_status read_document(xmlDoc *document, mt_arena *arena, mt_svg_drawing *drawing,
                               const char **problem) {
    mt_svg_reading reading = {.pen = {.arena = arena, .map = {1, 0, 0, 1, 0, 0}}};
    const xmlNode *root = xmlDocGetRootElement(document);
    if (!root || !is_svg(root) || !is_named(root, "svg")) {
        *problem = "it is no SVG drawing";
        return MT_BAD_DRAWING;
    }
    reading.by_id = xmlHashCreate(64);
    if (!reading.by_id) return MT_NO_MEMORY;
    mt_status status =
        list_ids(root, reading.by_id) ? read_root(&reading, root, arena, drawing) : MT_NO_MEMORY;
    xmlHashFree(reading.by_id, NULL);
    if (reading.problem) *problem = reading.problem;
    return status;
}

mt_status mt_svg_read(const uint8_t *bytes, size_t length, mt_arena *arena, mt_svg_drawing *drawing,
                      const char **problem) {
    static const char *const problems[] = {[MT_XML_DAMAGED] = "it is no SVG drawing, or a damaged one",
                                           [MT_XML_ENTITIES] = "it declares entities",
                                           [MT_XML_DEEP] = TOO_DEEP};
    xmlDoc *document;
    mt_xml_fault fault;
    *drawing = (mt_svg_drawing){0};
    *problem = NULL;
    mt_status status = mt_xml_read(bytes, length, &document, &fault);
    if (status == MT_BAD_DRAWING) *problem = problems[fault];
    if (status != MT_OK) return status;
    status = read_document(document, arena, drawing, problem);
    xmlFreeDoc(document);
    return status;
}
