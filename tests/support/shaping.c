#include "support/shaping.h"

#include "support/check.h"

#include <stdio.h>

/* Positions come in 1/FINE of a font unit, so that those of a variable font are not rounded. */
enum { FINE = 64, TABLES_MAX = 64 };

/* ---- fonts --------------------------------------------------------------------------------------------- */

static hb_font_t *font_of(hb_face_t *face) {
    int units = (int)hb_face_get_upem(face);
    hb_font_t *font = hb_font_create(face);
    hb_font_set_scale(font, FINE * units, FINE * units);
    hb_face_destroy(face);
    return font;
}

static hb_face_t *without_substitution(hb_face_t *face) {
    hb_tag_t tags[TABLES_MAX];
    unsigned count = TABLES_MAX;
    hb_face_t *bare = hb_face_builder_create();
    hb_face_get_table_tags(face, 0, &count, tags);
    for (unsigned i = 0; i < count; i++) {
        if (tags[i] == HB_TAG('G', 'S', 'U', 'B')) continue;
        hb_blob_t *table = hb_face_reference_table(face, tags[i]);
        assert_true(hb_face_builder_add_table(bare, tags[i], table));
        hb_blob_destroy(table);
    }
    hb_blob_t *blob = hb_face_reference_blob(bare);
    hb_face_t *made = hb_face_create(blob, 0);
    hb_blob_destroy(blob);
    hb_face_destroy(bare);
    hb_face_destroy(face);
    return made;
}

hb_font_t *mt_shaping_open(const char *path, float weight) {
    hb_blob_t *blob = hb_blob_create_from_file_or_fail(path);
    assert_non_null(blob);
    hb_font_t *font = font_of(without_substitution(hb_face_create(blob, 0)));
    hb_blob_destroy(blob);
    hb_variation_t variation = {HB_TAG('w', 'g', 'h', 't'), weight};
    if (weight > 0) hb_font_set_variations(font, &variation, 1);
    return font;
}

hb_font_t *mt_shaping_font(const uint8_t *bytes, size_t length) {
    hb_blob_t *blob =
        hb_blob_create((const char *)bytes, (unsigned)length, HB_MEMORY_MODE_READONLY, NULL, NULL);
    hb_font_t *font = font_of(hb_face_create(blob, 0));
    hb_blob_destroy(blob);
    return font;
}

/* ---- shaping ------------------------------------------------------------------------------------------- */

static hb_bool_t never_compose(hb_unicode_funcs_t *funcs, hb_codepoint_t a, hb_codepoint_t b,
                               hb_codepoint_t *ab, void *user) {
    (void)funcs, (void)a, (void)b, (void)ab, (void)user;
    return false;
}

static hb_bool_t never_decompose(hb_unicode_funcs_t *funcs, hb_codepoint_t ab, hb_codepoint_t *a,
                                 hb_codepoint_t *b, void *user) {
    (void)funcs, (void)ab, (void)a, (void)b, (void)user;
    return false;
}

/* HarfBuzz says what it attaches; the last time counts. */
static hb_bool_t note_attachment(hb_buffer_t *buffer, hb_font_t *font, const char *message, void *user) {
    mt_shaped *shaped = user;
    int what, to;
    (void)buffer, (void)font;
    if (sscanf(message, "attached mark glyph at %d to glyph at %d", &what, &to) == 2 ||
        sscanf(message, "cursive attached glyph at %d to glyph at %d", &what, &to) == 2)
        if (what >= 0 && what < MT_SHAPED_MAX) shaped->attached_to[what] = to;
    return true;
}

static hb_buffer_t *buffer_of(hb_script_t script, const uint32_t *text, int count) {
    hb_unicode_funcs_t *funcs = hb_unicode_funcs_create(hb_unicode_funcs_get_default());
    hb_unicode_funcs_set_compose_func(funcs, never_compose, NULL, NULL);
    hb_unicode_funcs_set_decompose_func(funcs, never_decompose, NULL, NULL);
    hb_buffer_t *buffer = hb_buffer_create();
    hb_buffer_set_unicode_funcs(buffer, funcs);
    hb_unicode_funcs_destroy(funcs);
    hb_buffer_add_codepoints(buffer, text, count, 0, count);
    hb_buffer_set_script(buffer, script);
    hb_buffer_set_direction(buffer, hb_script_get_horizontal_direction(script));
    return buffer;
}

static void read_positions(hb_buffer_t *buffer, mt_shaped *shaped) {
    unsigned count;
    const hb_glyph_position_t *positions = hb_buffer_get_glyph_positions(buffer, &count);
    bool backward = HB_DIRECTION_IS_BACKWARD(hb_buffer_get_direction(buffer));
    double x = 0;
    assert_int_equal(count, shaped->count);
    for (int i = 0; i < shaped->count; i++) {
        int at = backward ? shaped->count - 1 - i : i;
        shaped->x[at] = x + (double)positions[i].x_offset / FINE;
        shaped->y[at] = (double)positions[i].y_offset / FINE;
        shaped->advance[at] = (double)positions[i].x_advance / FINE;
        x += shaped->advance[at];
    }
}

mt_shaped mt_shape_text(hb_font_t *font, hb_script_t script, const uint32_t *text, int count) {
    mt_shaped shaped = {.count = count};
    static const hb_feature_t features[] = {{HB_TAG('k', 'e', 'r', 'n'), 0, 0, (unsigned)-1}};
    assert_true(count <= MT_SHAPED_MAX);
    for (int i = 0; i < MT_SHAPED_MAX; i++) shaped.attached_to[i] = -1;
    hb_buffer_t *buffer = buffer_of(script, text, count);
    hb_buffer_set_message_func(buffer, note_attachment, &shaped, NULL);
    hb_shape(font, buffer, features, 1);
    read_positions(buffer, &shaped);
    hb_buffer_destroy(buffer);
    return shaped;
}
