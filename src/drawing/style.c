#include "drawing/style.h"

#include <ctype.h>
#include <math.h>
#include <string.h>
#include <strings.h>

#include "base/real.h"
#include "drawing/scan.h"

mt_style mt_style_initial(void) {
    return (mt_style){.fill = MT_PAINT_COLOUR,
                      .stroke = MT_PAINT_NONE,
                      .fill_opacity = 1,
                      .stroke_width = 1,
                      .rule = MT_NONZERO,
                      .visible = true,
                      .shown = true};
}

mt_style mt_style_inherited(const mt_style *parent) {
    mt_style style = *parent;
    style.shown = true;
    style.left_out = 0;
    return style;
}

/* ---- colours --------------------------------------------------------------------------------------------- */

static uint8_t channel(double value) {
    return (uint8_t)lround(fmin(fmax(value, 0), 255));
}

/* rgb(R, G, B) with numbers or per cent, an alpha after them; *clear tells that there is nothing of it. */
static bool read_function(const char *text, mt_colour *colour, bool *clear) {
    double values[4] = {0, 0, 0, 1};
    int count = 0;
    if (strncasecmp(text, "rgb", 3) != 0) return false;
    text += 3;
    if (*text == 'a' || *text == 'A') text++;
    if (*text++ != '(') return false;
    for (mt_scan_blanks(&text); *text != ')'; mt_scan_comma(&text)) {
        if (count == 4 || !mt_real_next(&text, &values[count])) return false;
        if (*text == '%') {
            values[count] *= count == 3 ? 0.01 : 2.55;
            text++;
        }
        count++;
        mt_scan_blanks(&text);
        if (*text == '/') text++;
    }
    *colour = (mt_colour){channel(values[0]), channel(values[1]), channel(values[2])};
    *clear = values[3] <= 0;
    return count >= 3;
}

/* #RGBA and #RRGGBBAA as #RGB and #RRGGBB. */
static bool read_with_alpha(const char *text, mt_colour *colour, bool *clear) {
    char opaque[8];
    size_t length = strlen(text), digits = length == 5 ? 1 : 2;
    if (*text != '#' || (length != 5 && length != 9)) return false;
    memcpy(opaque, text, length - digits);
    opaque[length - digits] = '\0';
    for (size_t i = length - digits; i < length; i++)
        if (!isxdigit((unsigned char)text[i])) return false;
    *clear = strspn(text + length - digits, "0") == digits;
    return mt_colour_read(opaque, colour);
}

static void set_paint(const char *value, mt_paint *paint, mt_colour *colour) {
    mt_colour read;
    bool clear = false;
    if (mt_colour_read(value, &read) || read_with_alpha(value, &read, &clear) ||
        read_function(value, &read, &clear)) {
        *paint = clear ? MT_PAINT_NONE : MT_PAINT_COLOUR;
        *colour = read;
    } else if (strcasecmp(value, "none") == 0 || strcasecmp(value, "transparent") == 0) {
        *paint = MT_PAINT_NONE;
    } else if (strcasecmp(value, "currentcolor") == 0) {
        *paint = MT_PAINT_CURRENT;
    } else if (strncasecmp(value, "url(", 4) == 0) {
        *paint = MT_PAINT_SERVER;
    }
}

/* ---- properties ------------------------------------------------------------------------------------------ */

static void set_opacity(mt_style *style, const char *value) {
    double opacity;
    const char *at = value;
    if (!mt_real_next(&at, &opacity)) return;
    if (opacity <= 0)
        style->shown = false;
    else if (opacity < (*at == '%' ? 100 : 1))
        style->left_out |= MT_LEFT_OPACITY;
}

static void set_fill_opacity(mt_style *style, const char *value) {
    double opacity;
    const char *at = value;
    if (mt_real_next(&at, &opacity)) style->fill_opacity = *at == '%' ? opacity / 100 : opacity;
}

static void set_color(mt_style *style, const char *value) {
    mt_paint paint = MT_PAINT_NONE;
    mt_colour colour;
    set_paint(value, &paint, &colour);
    if (paint == MT_PAINT_COLOUR) style->current = colour;
}

static void set_stroke_width(mt_style *style, const char *value) {
    double width;
    if (mt_scan_length(value, 1, &width)) style->stroke_width = width;
}

/* Properties that take a part of the drawing away, or add to it. */
static void note(mt_style *style, const char *name, const char *value) {
    static const struct {
        const char *name;
        mt_left_out kind;
    } kinds[] = {{"filter", MT_LEFT_FILTERS},       {"mask", MT_LEFT_MASKS},
                 {"clip-path", MT_LEFT_CLIP_PATHS}, {"marker", MT_LEFT_MARKERS},
                 {"marker-start", MT_LEFT_MARKERS}, {"marker-mid", MT_LEFT_MARKERS},
                 {"marker-end", MT_LEFT_MARKERS}};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (strcmp(name, kinds[i].name) == 0 && strcmp(value, "none") != 0) style->left_out |= kinds[i].kind;
}

void mt_style_set(mt_style *style, const char *name, const char *value) {
    mt_colour ignored;
    if (strcmp(value, "inherit") == 0) return;
    if (strcmp(name, "fill") == 0)
        set_paint(value, &style->fill, &style->colour);
    else if (strcmp(name, "stroke") == 0)
        set_paint(value, &style->stroke, &ignored);
    else if (strcmp(name, "color") == 0)
        set_color(style, value);
    else if (strcmp(name, "fill-rule") == 0)
        style->rule = strcmp(value, "evenodd") == 0   ? MT_EVEN_ODD
                      : strcmp(value, "nonzero") == 0 ? MT_NONZERO
                                                      : style->rule;
    else if (strcmp(name, "display") == 0)
        style->shown = style->shown && strcmp(value, "none") != 0;
    else if (strcmp(name, "visibility") == 0)
        style->visible = strcmp(value, "visible") == 0;
    else if (strcmp(name, "opacity") == 0)
        set_opacity(style, value);
    else if (strcmp(name, "fill-opacity") == 0)
        set_fill_opacity(style, value);
    else if (strcmp(name, "stroke-width") == 0)
        set_stroke_width(style, value);
    else
        note(style, name, value);
}

/* Copies the text from `from` to `to` without blanks around it; false where it does not fit. */
static bool trim(const char *from, const char *to, char *copy, size_t room) {
    while (from < to && isspace((unsigned char)*from)) from++;
    while (from < to && isspace((unsigned char)to[-1])) to--;
    if ((size_t)(to - from) >= room) return false;
    memcpy(copy, from, (size_t)(to - from));
    copy[to - from] = '\0';
    return true;
}

void mt_style_set_all(mt_style *style, const char *declarations) {
    enum { ROOM = 128 };
    for (const char *at = declarations; *at;) {
        char name[ROOM], value[ROOM];
        const char *end = at + strcspn(at, ";"), *colon = at + strcspn(at, ":;");
        const char *important = memchr(at, '!', (size_t)(end - at));
        bool fits = *colon == ':' && trim(at, colon, name, sizeof name) &&
                    trim(colon + 1, important && important > colon ? important : end, value, sizeof value);
        if (fits) mt_style_set(style, name, value);
        at = *end ? end + 1 : end;
    }
}
