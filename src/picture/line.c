/* Lines of text, shaped and drawn. HarfBuzz shapes the characters of a line; a named glyph takes part as a character for private use
 * which leads to it in this line alone, and which no substitution may touch. */
#include "base/memory.h"
#include "picture/typeset.h"

#include <hb-ot.h>

/* ---- measures ------------------------------------------------------------------------------------------ */

static void widen(mt_extents *all, mt_extents one) {
    if (one.left < all->left) all->left = one.left;
    if (one.right > all->right) all->right = one.right;
    if (one.bottom < all->bottom) all->bottom = one.bottom;
    if (one.top > all->top) all->top = one.top;
}

/* A glyph of a shaped line and its place, font units, y upwards. */
typedef struct placed {
    uint32_t glyph;
    double x, y;
} placed;

/* Steps through a shaped line: the glyph at `index`, with the pen before it in *pen and after it on return. */
static placed place(const mt_line *line, unsigned index, double *pen) {
    const hb_glyph_info_t *info = hb_buffer_get_glyph_infos(line->buffer, NULL);
    const hb_glyph_position_t *position = hb_buffer_get_glyph_positions(line->buffer, NULL);
    placed glyph = {info[index].codepoint, *pen + position[index].x_offset, position[index].y_offset};
    *pen += position[index].x_advance;
    return glyph;
}

static void measure(const mt_typeset *instance, mt_line *line) {
    double pen = 0;
    mt_extents all = {0};
    for (unsigned i = 0; i < hb_buffer_get_length(line->buffer); i++) {
        placed at = place(line, i, &pen);
        mt_extents ink = mt_glyph_extents(instance, at.glyph);
        double x = at.x / instance->units, y = at.y / instance->units;
        widen(&all, (mt_extents){ink.left + x, ink.right + x, ink.bottom + y, ink.top + y, 0});
    }
    all.advance = pen / instance->units;
    if (all.right < all.advance) all.right = all.advance;
    line->extents = all;
}

/* ---- named glyphs ---------------------------------------------------------------------------------------- */

/* Named glyphs stand in a text as characters that it does not have otherwise, of the last plane for private use. */
enum { PLANE = 0x100000, PLANE_LAST = 0xFFFD };

typedef struct line_setting {
    const mt_typeset *instance;
    uint32_t *codes; /* of the text's characters and of those that stand for glyphs */
    uint32_t *
        stands_for; /* of each character of PLANE: the glyph, and 1; 0: none. NULL: the line has no named glyph */
} line_setting;

static hb_bool_t nominal_glyph(hb_font_t *font, void *data, hb_codepoint_t code, hb_codepoint_t *glyph,
                               void *user) {
    const line_setting *setting = data;
    (void)font;
    (void)user;
    uint32_t found = code >= PLANE && code <= PLANE + PLANE_LAST ? setting->stands_for[code - PLANE] : 0;
    if (!found) return hb_font_get_nominal_glyph(setting->instance->font, code, glyph);
    *glyph = found - 1;
    return true;
}

static bool has_names(const mt_choice *text, int length) {
    for (int i = 0; i < length; i++)
        if (text[i].name) return true;
    return false;
}

/* Gives each named glyph a character of PLANE that the line has not. */
static void stand_in(const mt_choice *text, int length, line_setting *setting) {
    const uint32_t taken = UINT32_MAX;
    int next = PLANE_LAST;
    for (int i = 0; i < length; i++)
        if (!text[i].name && text[i].code_point >= PLANE)
            setting->stands_for[text[i].code_point - PLANE] = taken;
    for (int i = 0; i < length; i++) {
        if (!text[i].name) continue;
        while (setting->stands_for[next]) next--;
        setting->codes[i] = PLANE + (uint32_t)next;
        setting->stands_for[next] = setting->instance->firsts[text[i].glyph].number + 1;
    }
    for (int i = 0; i < length; i++)
        if (!text[i].name && text[i].code_point >= PLANE) setting->stands_for[text[i].code_point - PLANE] = 0;
}

/* Script and direction are those of the characters, and of those that named glyphs are forms of. */
static bool set_properties(const mt_choice *text, int length, const line_setting *setting,
                           hb_buffer_t *buffer) {
    hb_segment_properties_t properties;
    hb_buffer_t *spoken = hb_buffer_create();
    for (int i = 0; i < length; i++) {
        uint32_t code =
            text[i].name ? setting->instance->firsts[text[i].glyph].code_point : text[i].code_point;
        hb_buffer_add(spoken, code, (unsigned)i);
    }
    hb_buffer_set_content_type(spoken, HB_BUFFER_CONTENT_TYPE_UNICODE);
    hb_buffer_guess_segment_properties(spoken);
    hb_buffer_get_segment_properties(spoken, &properties);
    hb_buffer_set_segment_properties(buffer, &properties);
    bool whole = hb_buffer_allocation_successful(spoken);
    hb_buffer_destroy(spoken);
    return whole;
}

/* Features that switch all substitutions off where a named glyph stands; from mt_new. Those that GPOS has too stay on. */
static mt_status list_features(const mt_choice *text, int length, hb_font_t *font, hb_feature_t **features,
                               unsigned *count) {
    enum { TAGS_MAX = 512 };
    hb_tag_t tags[TAGS_MAX], positions[TAGS_MAX];
    unsigned tag_count = TAGS_MAX, position_count = TAGS_MAX, named = 0, used = 0;
    hb_face_t *face = hb_font_get_face(font);
    hb_ot_layout_table_get_feature_tags(face, HB_OT_TAG_GSUB, 0, &tag_count, tags);
    hb_ot_layout_table_get_feature_tags(face, HB_OT_TAG_GPOS, 0, &position_count, positions);
    for (int i = 0; i < length; i++) named += text[i].name != NULL;
    hb_feature_t *list = mt_new((size_t)named * tag_count + 1, sizeof *list);
    if (!list) return MT_NO_MEMORY;
    for (unsigned k = 0; k < tag_count; k++) {
        bool known = false;
        for (unsigned n = 0; n < k; n++) known = known || tags[n] == tags[k];
        for (unsigned n = 0; n < position_count; n++) known = known || positions[n] == tags[k];
        for (int i = 0; i < length && !known; i++)
            if (text[i].name) list[used++] = (hb_feature_t){tags[k], 0, (unsigned)i, (unsigned)i + 1};
    }
    *features = list;
    *count = used;
    return MT_OK;
}

static mt_status shape_named(const mt_choice *text, int length, line_setting *setting, hb_buffer_t *buffer) {
    hb_feature_t *features;
    unsigned count;
    setting->stands_for = mt_new(PLANE_LAST + 3, sizeof *setting->stands_for);
    if (!setting->stands_for) return MT_NO_MEMORY;
    stand_in(text, length, setting);
    mt_status status = list_features(text, length, setting->instance->font, &features, &count);
    if (status != MT_OK) return status;
    hb_font_funcs_t *functions = hb_font_funcs_create();
    hb_font_t *font = hb_font_create_sub_font(setting->instance->font);
    hb_font_funcs_set_nominal_glyph_func(functions, nominal_glyph, NULL, NULL);
    hb_font_set_funcs(font, functions, setting, NULL);
    hb_buffer_add_codepoints(buffer, setting->codes, length, 0, length);
    bool made = set_properties(text, length, setting, buffer) && font != hb_font_get_empty() &&
                functions != hb_font_funcs_get_empty();
    if (made) hb_shape(font, buffer, features, count);
    hb_font_funcs_destroy(functions);
    hb_font_destroy(font);
    mt_free(features);
    return made ? MT_OK : MT_NO_MEMORY;
}

/* ---- lines ---------------------------------------------------------------------------------------------- */

static mt_status shape(const mt_choice *text, int length, line_setting *setting, hb_buffer_t *buffer) {
    setting->codes = mt_new((size_t)length + 1, sizeof *setting->codes);
    if (!setting->codes) return MT_NO_MEMORY;
    for (int i = 0; i < length; i++) setting->codes[i] = text[i].code_point;
    if (has_names(text, length)) return shape_named(text, length, setting, buffer);
    hb_buffer_add_codepoints(buffer, setting->codes, length, 0, length);
    hb_buffer_guess_segment_properties(buffer);
    hb_shape(setting->instance->font, buffer, NULL, 0);
    return MT_OK;
}

mt_status mt_line_shape(const mt_typeset *instance, const mt_choice *text, int length, mt_line *line) {
    line_setting setting = {.instance = instance};
    *line = (mt_line){.buffer = hb_buffer_create()};
    mt_status status = shape(text, length, &setting, line->buffer);
    if (status == MT_OK && !hb_buffer_allocation_successful(line->buffer)) status = MT_NO_MEMORY;
    if (status == MT_OK)
        measure(instance, line);
    else
        mt_line_free(line);
    mt_free(setting.codes);
    mt_free(setting.stands_for);
    return status;
}

void mt_line_free(mt_line *line) {
    hb_buffer_destroy(line->buffer);
    line->buffer = NULL;
}

void mt_line_draw(const mt_typeset *instance, const mt_line *line, cairo_t *cairo, double x, double y,
                  double size) {
    double pen = 0, scale = size / instance->units;
    for (unsigned i = 0; i < hb_buffer_get_length(line->buffer); i++) {
        placed at = place(line, i, &pen);
        mt_glyph_draw(instance, at.glyph, cairo, x + at.x * scale, y - at.y * scale, size);
    }
}
