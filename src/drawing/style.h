/* How an element is filled: properties of SVG from attributes and from style="…", inherited ("SVG 2", chapters 6 and 13). */
#pragma once

#include "drawing/colour.h"
#include "geometry/union.h"

/* What a drawing has that is not drawn: bits. */
typedef enum mt_left_out {
    MT_LEFT_STROKES = 1 << 0,
    MT_LEFT_GRADIENTS = 1 << 1, /* and patterns */
    MT_LEFT_TEXT = 1 << 2,
    MT_LEFT_IMAGES = 1 << 3,
    MT_LEFT_FILTERS = 1 << 4,
    MT_LEFT_MASKS = 1 << 5,
    MT_LEFT_CLIP_PATHS = 1 << 6,
    MT_LEFT_MARKERS = 1 << 7,
    MT_LEFT_SCRIPTS = 1 << 8,
    MT_LEFT_STYLE_SHEETS = 1 << 9, /* rules of these that select otherwise than by a name, a class or an id */
    MT_LEFT_REFERENCES = 1 << 10,  /* to other files */
    MT_LEFT_OPACITY = 1 << 11,
    MT_LEFT_FOREIGN = 1 << 12,
    MT_LEFT_ANIMATIONS = 1 << 13,
    MT_LEFT_KINDS = 14
} mt_left_out;

typedef enum mt_paint { MT_PAINT_NONE, MT_PAINT_COLOUR, MT_PAINT_CURRENT, MT_PAINT_SERVER } mt_paint;

typedef struct mt_style {
    mt_paint fill, stroke;
    mt_colour colour, current; /* of the fill; of the property color */
    double fill_opacity, stroke_width;
    mt_rule rule;
    bool visible;
    bool shown; /* not inherited: neither display: none nor opacity: 0 */
    unsigned left_out;
} mt_style;

/* What an element without any property has. */
mt_style mt_style_initial(void);
/* What a child begins with. */
mt_style mt_style_inherited(const mt_style *parent);

/* Sets a property; what is no property here, or no value of one, changes nothing. */
void mt_style_set(mt_style *style, const char *name, const char *value);
/* Declarations with semicolons between them. */
void mt_style_set_all(mt_style *style, const char *declarations);
