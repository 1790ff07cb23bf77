/* The inspection as data.
 *
 *     {
 *       "format": "morphotype inspection",
 *       "version": 1,
 *       "a": {"font": SPEC, "family": NAME, "style": NAME},     the fonts; "b" only where there are two
 *       "b": {…},
 *       "glyphs": [                                             in the order of the text
 *         {
 *           "character": "形",
 *           "code_point": 24418,                                or, of a glyph by its name, in place of these two:
 *           "glyph": "/f_i",
 *           "a": SIDE,
 *           "b": SIDE,                                          this and all below: only with two glyphs
 *           "rotation": 0,                                      degrees by which B is turned, formula (5)'s q
 *           "matches": [[i, k], …],                             component i of A goes with component k of B
 *           "contours": [CONTOUR, …],                           of matched components that are aligned whole
 *           "links": [[i, k], …]                                piece i of A goes with piece k of B, in all
 *                                                               other components: the paper's list R
 *         }
 *       ]
 *     }
 *
 * A SIDE is one font's glyph:
 *
 *     {
 *       "advance": 0.83,                                        em
 *       "area": 0.16,                                           em²
 *       "components": [                                         connected regions of ink
 *         {"area": 0.07, "holes": 0, "piece_count": 12, "first_piece": 0}
 *       ],
 *       "pieces": [                                             convex; numbered through all components
 *         {"component": 0, "area": 0.01, "centre": [0.2, 0.4], "corners": 4}
 *       ]
 *     }
 *
 * A CONTOUR moves between two contours of as many lines and curves, every point on a straight line:
 *
 *     {
 *       "a": [[0.1, 0.7], …],                                   where the lines and curves of A's end, in order
 *       "b": [[0.2, 0.7], …]                                    B's, as many
 *     }
 *
 * Lengths are in em and areas in em², to 9 decimals; y runs upwards from the baseline. Points of B are
 * given as it is drawn, before it is turned. A font's "style" may be "". Indices count from 0. */
#include "base/json.h"
#include "base/utf.h"
#include "geometry/limits.h"
#include "picture/picture.h"
#include "picture/turn.h"
#include "picture/view.h"

static double em(double grid_units) {
    return grid_units / MT_EM;
}

/* From twice an area in grid units squared. */
static double em2(int64_t area2) {
    return (double)area2 / 2 / MT_EM / MT_EM;
}

static void add_font(mt_json *json, const char *key, const mt_font *font) {
    mt_json_object(json, key);
    mt_json_text(json, "font", mt_font_spec(font));
    mt_json_text(json, "family", mt_font_family(font));
    mt_json_text(json, "style", mt_font_style(font));
    mt_json_object_end(json);
}

static void add_component(mt_json *json, const mt_side *side, int index) {
    const mt_component *component = &side->shape.components[index];
    mt_json_one_line(json);
    mt_json_object(json, NULL);
    mt_json_number(json, "area", em2(mt_component_area2(component)));
    mt_json_int(json, "holes", component->count - 1);
    mt_json_int(json, "piece_count", side->first[index + 1] - side->first[index]);
    mt_json_int(json, "first_piece", side->first[index]);
    mt_json_object_end(json);
}

static void add_point(mt_json *json, const char *key, double x, double y, const mt_turn *turn) {
    mt_turn_point(turn, &x, &y);
    mt_json_array(json, key);
    mt_json_number(json, NULL, em(x));
    mt_json_number(json, NULL, em(y));
    mt_json_array_end(json);
}

static void add_piece(mt_json *json, const mt_ring *piece, int component, const mt_turn *turn) {
    double x, y;
    mt_ring_centre(piece, &x, &y);
    mt_json_one_line(json);
    mt_json_object(json, NULL);
    mt_json_int(json, "component", component);
    mt_json_number(json, "area", em2(mt_ring_area2(piece)));
    add_point(json, "centre", x, y, turn);
    mt_json_int(json, "corners", piece->count);
    mt_json_object_end(json);
}

static void add_side(mt_json *json, const char *key, const mt_side *side, double advance,
                     const mt_turn *turn) {
    mt_json_object(json, key);
    mt_json_number(json, "advance", em(advance));
    mt_json_number(json, "area", em2(mt_shape_area2(&side->shape)));
    mt_json_array(json, "components");
    for (int i = 0; i < side->shape.count; i++) add_component(json, side, i);
    mt_json_array_end(json);
    mt_json_array(json, "pieces");
    for (int i = 0; i < side->shape.count; i++)
        for (int k = side->first[i]; k < side->first[i + 1]; k++)
            add_piece(json, &side->pieces.rings[k], i, turn);
    mt_json_array_end(json);
    mt_json_object_end(json);
}

static void add_links(mt_json *json, const char *key, const mt_links *links) {
    mt_json_array(json, key);
    for (int i = 0; i < links->count; i++) {
        mt_json_one_line(json);
        mt_json_array(json, NULL);
        mt_json_int(json, NULL, links->links[i].a);
        mt_json_int(json, NULL, links->links[i].b);
        mt_json_array_end(json);
    }
    mt_json_array_end(json);
}

static void add_ends(mt_json *json, const char *key, const mt_contour *contour, const mt_turn *turn) {
    mt_json_one_line(json);
    mt_json_array(json, key);
    for (int i = 0; i < contour->count; i++)
        add_point(json, NULL, contour->segments[i].end.x, contour->segments[i].end.y, turn);
    mt_json_array_end(json);
}

static void add_contours(mt_json *json, const mt_morph *morph, const mt_turn *none, const mt_turn *turn) {
    mt_json_array(json, "contours");
    for (int i = 0; i < morph->contour_count; i++) {
        mt_json_object(json, NULL);
        add_ends(json, "a", &morph->contours[i].a, none);
        add_ends(json, "b", &morph->contours[i].b, turn);
        mt_json_object_end(json);
    }
    mt_json_array_end(json);
}

static void add_name(mt_json *json, const mt_choice *choice) {
    char character[5] = "", label[MT_CHOICE_LABEL_ROOM];
    mt_choice_label(choice, label);
    if (choice->name) {
        mt_json_text(json, "glyph", label);
        return;
    }
    mt_utf8_put(choice->code_point, character);
    mt_json_text(json, "character", character);
    mt_json_int(json, "code_point", choice->code_point);
}

static void add_view(mt_json *json, const mt_view *view) {
    const mt_morph *morph = &view->pair.morph;
    mt_turn none = {.cosine = 1}, turn = mt_turn_back(&view->pair);
    mt_json_object(json, NULL);
    add_name(json, view->choice);
    add_side(json, "a", &morph->a, view->pair.room_a.advance, &none);
    if (view->paired) {
        add_side(json, "b", &morph->b, view->pair.room_b.advance, &turn);
        mt_json_number(json, "rotation", morph->degrees);
        add_links(json, "matches", &morph->matches);
        add_contours(json, morph, &none, &turn);
        add_links(json, "links", &morph->links);
    }
    mt_json_object_end(json);
}

static void add_heading(mt_json *json, const mt_row *row) {
    mt_json_text(json, "format", "morphotype inspection");
    mt_json_int(json, "version", 1);
    add_font(json, "a", row->fonts[0]);
    if (row->font_count > 1) add_font(json, "b", row->fonts[1]);
}

/* An mt_view_taken. */
static mt_status take_view(const mt_view *view, int index, mt_arena *arena, void *user) {
    mt_json *json = user;
    (void)index;
    (void)arena;
    add_view(json, view);
    return json->status;
}

mt_status mt_inspect_json(mt_row *row, const mt_inspection *what, uint8_t **bytes, size_t *length,
                          int *failed) {
    mt_json json = {0};
    *failed = -1;
    mt_json_object(&json, NULL);
    add_heading(&json, row);
    mt_json_array(&json, "glyphs");
    mt_status status = mt_views_make(row, what, take_view, &json, failed);
    mt_json_array_end(&json);
    mt_json_object_end(&json);
    if (status == MT_OK) status = json.status;
    if (status == MT_OK) {
        *bytes = json.text.bytes;
        *length = json.text.length;
    } else {
        mt_buffer_free(&json.text);
    }
    return status;
}
