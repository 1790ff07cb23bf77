#include "base/html.h"
#include "base/utf.h"
#include "geometry/limits.h"
#include "morph/between/variable_outline.h"
#include "morph/paper/rotation.h"
#include "pointing/pointing.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* What the em has of some units, and into how many parts one of them is rounded. */
typedef struct mt_units {
    double units, parts;
} mt_units;

/* What moves is drawn, and not measured. */
static const mt_units thousandths = {1000, 10};

/* Hints are as fine, and most fonts' points whole. */
static mt_units units_of(const mt_font *font) {
    return (mt_units){mt_font_units_per_em(font), 1000};
}

static void add_value(mt_json *json, const char *key, double grid, mt_units in) {
    mt_json_number(json, key, round(grid * in.units / MT_EM * in.parts) / in.parts);
}

static void add_place(mt_json *json, const char *key, double x, double y, mt_units in) {
    mt_json_array(json, key);
    add_value(json, NULL, x, in);
    add_value(json, NULL, y, in);
    mt_json_array_end(json);
}

static void add_segment(mt_json *json, const mt_segment *segment, mt_units in) {
    mt_json_array(json, NULL);
    for (int i = 0; i < segment->degree - 1; i++) {
        add_value(json, NULL, segment->control[i].x, in);
        add_value(json, NULL, segment->control[i].y, in);
    }
    add_value(json, NULL, segment->end.x, in);
    add_value(json, NULL, segment->end.y, in);
    mt_json_array_end(json);
}

static void add_contour(mt_json *json, const char *key, const mt_contour *contour, mt_units in) {
    mt_json_array(json, key);
    for (int i = 0; i < contour->count; i++) add_segment(json, &contour->segments[i], in);
    mt_json_array_end(json);
}

/* ---- both ends ----------------------------------------------------------------------------------------- */

/* Reads the glyph once more: the morph has it as rings. */
static mt_status add_side(mt_json *json, const char *key, mt_row *row, int font, uint32_t glyph,
                          const mt_side *side, mt_arena *arena) {
    mt_outline outline;
    double advance;
    mt_units in = units_of(row->fonts[font]);
    pthread_mutex_lock(&row->lock);
    mt_status status = mt_font_outline(row->fonts[font], glyph, arena, &outline, &advance);
    pthread_mutex_unlock(&row->lock);
    if (status != MT_OK) return status;
    mt_json_object(json, key);
    mt_json_int(json, "units", mt_font_units_per_em(row->fonts[font]));
    add_value(json, "advance", advance, in);
    mt_json_int(json, "components", side->whole.count);
    mt_json_array(json, "drawing");
    for (int i = 0; i < outline.count; i++) add_contour(json, NULL, &outline.contours[i], in);
    mt_json_array_end(json);
    mt_json_object_end(json);
    return MT_OK;
}

/* ---- what moves ---------------------------------------------------------------------------------------- */

static mt_status add_moving(mt_json *json, const mt_morph *morph, const mt_params *params, mt_arena *arena) {
    mt_variable_outline moving;
    mt_status status = mt_variable_outline_make(morph, params, arena, &moving);
    if (status != MT_OK) return status;
    mt_json_array(json, "moving");
    for (int i = 0; i < moving.count; i++) {
        const mt_contour_pair *contour = &moving.contours[i];
        mt_json_object(json, NULL);
        add_contour(json, "a", &contour->a, thousandths);
        add_contour(json, "b", &contour->b, thousandths);
        add_place(json, "by", contour->displacement.x, contour->displacement.y, thousandths);
        mt_json_object_end(json);
    }
    mt_json_array_end(json);
    return MT_OK;
}

static void add_turn(mt_json *json, const mt_morph *morph) {
    mt_point a = mt_box_middle(morph->a.box), b = mt_box_middle(morph->b.box);
    mt_json_object(json, "turn");
    mt_json_number(json, "degrees", morph->degrees);
    add_place(json, "a", a.x, a.y, thousandths);
    add_place(json, "b", b.x, b.y, thousandths);
    mt_json_object_end(json);
}

/* ---- hints --------------------------------------------------------------------------------------------- */

static void add_hints(mt_json *json, const mt_row *row, const mt_pointed_glyph *glyph) {
    mt_hints hints = mt_hint_index_find(row->hints[0], glyph->a, glyph->b);
    mt_json_array(json, "hints");
    for (int i = 0; i < hints.count; i++) {
        const mt_hint *hint = &hints.hints[i];
        mt_json_object(json, NULL);
        mt_json_text(json, "kind", hint->kind == MT_HINT_POINT ? "point" : "component");
        add_place(json, "a", hint->a.x, hint->a.y, units_of(row->fonts[0]));
        add_place(json, "b", hint->b.x, hint->b.y, units_of(row->fonts[1]));
        mt_json_bool(json, "idle", glyph->idle && glyph->idle[i]);
        mt_json_object_end(json);
    }
    mt_json_array_end(json);
}

/* As a person reads it: the character itself, where it can be seen, or the label. */
static void add_glyph_name(mt_json *json, const mt_pointed_glyph *glyph) {
    char character[5] = "";
    bool seen = glyph->code_point && !mt_html_is_control(glyph->code_point);
    if (seen) mt_utf8_put(glyph->code_point, character);
    mt_json_text(json, "name", seen ? character : glyph->label);
}

mt_status mt_pointing_add_glyph(mt_json *json, mt_row *row, const mt_pointed_glyph *glyph, mt_arena *arena) {
    const mt_morph *morph = &glyph->pair->morph;
    mt_json_one_line(json);
    mt_json_object(json, NULL);
    add_glyph_name(json, glyph);
    mt_json_text(json, "label", glyph->label);
    mt_status status = add_side(json, "a", row, 0, glyph->a, &morph->a, arena);
    if (status == MT_OK) status = add_side(json, "b", row, 1, glyph->b, &morph->b, arena);
    if (status == MT_OK) status = add_moving(json, morph, &row->params, arena);
    if (status != MT_OK) return status;
    add_turn(json, morph);
    add_hints(json, row, glyph);
    mt_json_object_end(json);
    return json->status;
}

/* ---- both fonts ---------------------------------------------------------------------------------------- */

static void add_name(mt_json *json, const char *key, const mt_font *font) {
    char name[1024];
    snprintf(name, sizeof name, "%s %s", mt_font_family(font), mt_font_style(font));
    mt_json_text(json, key, name);
}

void mt_pointing_add_names(mt_json *json, const char *key, const mt_row *row) {
    mt_json_object(json, key);
    add_name(json, "a", row->fonts[0]);
    add_name(json, "b", row->fonts[1]);
    mt_json_object_end(json);
}

mt_status mt_pointing_add_title(mt_buffer *text, const mt_row *row) {
    static const char between[] = " – ";
    mt_status status = mt_html_text(text, mt_font_family(row->fonts[0]));
    if (status == MT_OK) status = mt_buffer_add(text, between, strlen(between));
    return status == MT_OK ? mt_html_text(text, mt_font_family(row->fonts[1])) : status;
}
