/* What the specimen says of its font, read by HarfBuzz from the font as it was made. */
#include "base/html.h"
#include "specimen/specimen.h"

#include <hb-ot.h>
#include <stdlib.h>

/* HarfBuzz gives an empty object, not NULL, when it runs out of memory. */
static mt_status open_face(const mt_specimen_font *font, hb_face_t **face) {
    if (font->length > UINT32_MAX) return MT_TOO_LARGE;
    hb_blob_t *blob = hb_blob_create((const char *)font->bytes, (unsigned)font->length,
                                     HB_MEMORY_MODE_READONLY, NULL, NULL);
    hb_face_t *made = hb_face_create(blob, 0);
    hb_blob_destroy(blob);
    if (made == hb_face_get_empty()) return MT_NO_MEMORY;
    *face = made;
    return MT_OK;
}

/* ---- characters ---------------------------------------------------------------------------------------- */

static mt_status copy_chars(const hb_set_t *set, hb_font_t *shaping, mt_arena *arena,
                            mt_specimen_font *font) {
    size_t room = hb_set_get_population(set);
    hb_unicode_funcs_t *unicode = hb_unicode_funcs_get_default();
    font->chars = mt_arena_new(arena, room + 1, sizeof *font->chars);
    font->glyphs = mt_arena_new(arena, room + 1, sizeof *font->glyphs);
    font->scripts = mt_arena_new(arena, room + 1, sizeof *font->scripts);
    if (!font->chars || !font->glyphs || !font->scripts) return MT_NO_MEMORY;
    for (hb_codepoint_t c = HB_SET_VALUE_INVALID; hb_set_next(set, &c);) {
        if (mt_html_is_control(c)) continue;
        font->chars[font->char_count] = c;
        hb_font_get_nominal_glyph(shaping, c, &font->glyphs[font->char_count]);
        font->scripts[font->char_count++] = hb_script_to_iso15924_tag(hb_unicode_script(unicode, c));
    }
    return MT_OK;
}

static mt_status read_chars(hb_face_t *face, mt_arena *arena, mt_specimen_font *font) {
    hb_set_t *set = hb_set_create();
    hb_font_t *shaping = hb_font_create(face);
    hb_face_collect_unicodes(face, set);
    bool made = hb_set_allocation_successful(set) && shaping != hb_font_get_empty();
    mt_status status = made ? copy_chars(set, shaping, arena, font) : MT_NO_MEMORY;
    hb_font_destroy(shaping);
    hb_set_destroy(set);
    return status;
}

/* ---- names --------------------------------------------------------------------------------------------- */

/* "" where the font has none. */
static mt_status read_name(hb_face_t *face, hb_ot_name_id_t id, mt_arena *arena, const char **name) {
    unsigned room = hb_ot_name_get_utf8(face, id, HB_LANGUAGE_INVALID, NULL, NULL) + 1;
    char *text = mt_arena_new(arena, room, 1);
    if (!text) return MT_NO_MEMORY;
    hb_ot_name_get_utf8(face, id, HB_LANGUAGE_INVALID, &room, text);
    *name = text;
    return MT_OK;
}

static mt_status read_family(hb_face_t *face, mt_arena *arena, mt_specimen_font *font) {
    mt_status status = read_name(face, HB_OT_NAME_ID_TYPOGRAPHIC_FAMILY, arena, &font->family);
    if (status == MT_OK && !*font->family)
        status = read_name(face, HB_OT_NAME_ID_FONT_FAMILY, arena, &font->family);
    return status;
}

/* ---- features ------------------------------------------------------------------------------------------ */

static int compare(const void *p, const void *q) {
    const uint32_t *x = p, *y = q;
    return (*x > *y) - (*x < *y);
}

static int drop_repeats(uint32_t *tags, unsigned count) {
    int kept = 0;
    for (unsigned i = 0; i < count; i++)
        if (kept == 0 || tags[i] != tags[kept - 1]) tags[kept++] = tags[i];
    return kept;
}

static mt_status read_features(hb_face_t *face, mt_arena *arena, mt_specimen_font *font) {
    unsigned substitutions = hb_ot_layout_table_get_feature_tags(face, HB_OT_TAG_GSUB, 0, NULL, NULL);
    unsigned positions = hb_ot_layout_table_get_feature_tags(face, HB_OT_TAG_GPOS, 0, NULL, NULL);
    unsigned all = substitutions + positions;
    font->features = mt_arena_new(arena, (size_t)all + 1, sizeof *font->features);
    if (!font->features) return MT_NO_MEMORY;
    hb_ot_layout_table_get_feature_tags(face, HB_OT_TAG_GSUB, 0, &substitutions, font->features);
    hb_ot_layout_table_get_feature_tags(face, HB_OT_TAG_GPOS, 0, &positions, font->features + substitutions);
    qsort(font->features, all, sizeof *font->features, compare);
    font->feature_count = drop_repeats(font->features, all);
    return MT_OK;
}

/* ---- the whole ----------------------------------------------------------------------------------------- */

mt_status mt_specimen_font_read(const uint8_t *bytes, size_t length, mt_arena *arena,
                                mt_specimen_font *font) {
    hb_face_t *face;
    mt_specimen_font read = {.bytes = bytes, .length = length};
    mt_status status = open_face(&read, &face);
    if (status != MT_OK) return status;
    status = read_chars(face, arena, &read);
    if (status == MT_OK) status = read_family(face, arena, &read);
    if (status == MT_OK) status = read_features(face, arena, &read);
    hb_face_destroy(face);
    if (status == MT_OK) *font = read;
    return status;
}
