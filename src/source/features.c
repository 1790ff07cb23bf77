/* The features of a font's spec: what they make of the glyph of a character by itself is the character's glyph.
 *
 * HarfBuzz shapes the glyph as a text of one, in the character's script, with these features and no other. Whatever kinds of
 * lookups they have, a form is what comes out as one glyph. Signs of no script (digits, punctuation, private codes) have the
 * form of the first script that makes one: Latin, the default, then the font's others. */
#include "source/handle.h"

#include <hb-ot.h>
#include <stdlib.h>

#include "geometry/limits.h"
#include "sfnt/layout_face.h"

/* A glyph stands in the text as a private character: HarfBuzz does nothing of its own to these. */
enum { FIRST_PRIVATE = 0xF0000 };
enum { SETTINGS_MAX = 1024 }; /* features that are turned on or off */

typedef struct mt_form_finder {
    mt_font *font;
    mt_face_tables tables;
    hb_face_t *face;
    hb_font_t *hb;
    hb_buffer_t *buffer;
    hb_set_t *inputs; /* the glyphs that the features may change */
    int count;
    hb_feature_t settings[SETTINGS_MAX];
    unsigned script_count;
    hb_script_t *scripts; /* to be tried for signs of no script */
} mt_form_finder;

static int by_code_point(const void *p, const void *q) {
    const mt_form *x = p, *y = q;
    return (x->code_point > y->code_point) - (x->code_point < y->code_point);
}

uint32_t mt_font_form(const mt_font *font, uint32_t code_point, uint32_t glyph) {
    mt_form key = {code_point, 0};
    if (!font->form_count || !glyph) return glyph;
    const mt_form *form = bsearch(&key, font->forms, (size_t)font->form_count, sizeof key, by_code_point);
    return form ? form->glyph : glyph;
}

bool mt_font_features_do_nothing(const mt_font *font) {
    return font->spec.feature_count > 0 && font->form_count == 0;
}

/* ---- the features -------------------------------------------------------------------------------------- */

static const mt_feature_setting *find_setting(const mt_spec *spec, uint32_t tag) {
    for (int i = 0; i < spec->feature_count; i++)
        if (spec->features[i].tag == tag) return &spec->features[i];
    return NULL;
}

static bool is_turned(const mt_form_finder *finder, uint32_t tag) {
    for (int i = 0; i < finder->count; i++)
        if (finder->settings[i].tag == tag) return true;
    return false;
}

/* Turns the font's features on and off, as far as there is room: each tag once. */
static void turn_features(mt_form_finder *finder) {
    const mt_spec *spec = &finder->font->spec;
    unsigned all = hb_ot_layout_table_get_feature_tags(finder->face, HB_OT_TAG_GSUB, 0, NULL, NULL);
    for (int pass = 0; pass < 2; pass++)
        for (unsigned i = 0; i < all && finder->count < SETTINGS_MAX; i++) {
            hb_tag_t tag;
            unsigned one = 1;
            hb_ot_layout_table_get_feature_tags(finder->face, HB_OT_TAG_GSUB, i, &one, &tag);
            const mt_feature_setting *wanted = find_setting(spec, tag);
            if (one == 0 || (wanted != NULL) != (pass == 0) || is_turned(finder, tag)) continue;
            finder->settings[finder->count++] = (hb_feature_t){
                tag, wanted ? wanted->value : 0, HB_FEATURE_GLOBAL_START, HB_FEATURE_GLOBAL_END};
        }
}

static bool has_all(const mt_form_finder *finder) {
    const mt_spec *spec = &finder->font->spec;
    for (int i = 0; i < spec->feature_count; i++)
        if (!is_turned(finder, spec->features[i].tag)) return false;
    return true;
}

static void collect_inputs(mt_form_finder *finder) {
    const mt_spec *spec = &finder->font->spec;
    hb_tag_t tags[MT_SPEC_FEATURES + 1] = {0};
    hb_set_t *lookups = hb_set_create();
    for (int i = 0; i < spec->feature_count; i++) tags[i] = spec->features[i].tag;
    hb_ot_layout_collect_lookups(finder->face, HB_OT_TAG_GSUB, NULL, NULL, tags, lookups);
    for (hb_codepoint_t lookup = HB_SET_VALUE_INVALID; hb_set_next(lookups, &lookup);)
        hb_ot_layout_lookup_collect_glyphs(finder->face, HB_OT_TAG_GSUB, lookup, NULL, finder->inputs, NULL,
                                           NULL);
    hb_set_destroy(lookups);
}

static mt_status list_scripts(mt_form_finder *finder, mt_arena *arena) {
    unsigned all = hb_ot_layout_table_get_script_tags(finder->face, HB_OT_TAG_GSUB, 0, NULL, NULL);
    finder->scripts = mt_arena_new(arena, (size_t)all + 2, sizeof *finder->scripts);
    if (!finder->scripts) return MT_NO_MEMORY;
    finder->scripts[finder->script_count++] = HB_SCRIPT_LATIN;
    finder->scripts[finder->script_count++] = HB_SCRIPT_COMMON; /* DFLT */
    for (unsigned i = 0; i < all; i++) {
        hb_tag_t tag;
        unsigned one = 1;
        hb_ot_layout_table_get_script_tags(finder->face, HB_OT_TAG_GSUB, i, &one, &tag);
        if (one) finder->scripts[finder->script_count++] = hb_ot_tag_to_script(tag);
    }
    return MT_OK;
}

/* ---- HarfBuzz ------------------------------------------------------------------------------------------ */

static hb_bool_t private_glyph(hb_font_t *hb, void *data, hb_codepoint_t code, hb_codepoint_t *glyph,
                               void *user) {
    (void)hb;
    (void)data;
    (void)user;
    *glyph = code - FIRST_PRIVATE;
    return code >= FIRST_PRIVATE && *glyph < MT_GLYPHS_MAX;
}

static mt_status read_tables(mt_form_finder *finder, mt_arena *arena) {
    mt_face_tables *tables = &finder->tables;
    tables->glyph_count = mt_font_glyph_count(finder->font);
    mt_status status = mt_font_table(finder->font, MT_TAG('G', 'S', 'U', 'B'), arena, &tables->gsub);
    if (status == MT_OK)
        status = mt_font_table(finder->font, MT_TAG('G', 'D', 'E', 'F'), arena, &tables->gdef);
    return status;
}

/* A font of layout alone, at the place on the axes. */
static bool make_font(mt_form_finder *finder) {
    int coords[MT_SPEC_AXES];
    const int32_t *place;
    int axes = mt_font_place(finder->font, &place);
    finder->face = mt_face_make(&finder->tables);
    if (!finder->face) return false;
    hb_font_funcs_t *functions = hb_font_funcs_create();
    hb_font_funcs_set_nominal_glyph_func(functions, private_glyph, NULL, NULL);
    finder->hb = hb_font_create(finder->face);
    hb_font_set_funcs(finder->hb, functions, NULL, NULL);
    hb_font_funcs_destroy(functions);
    for (int i = 0; i < axes; i++) coords[i] = (place[i] + 2) >> 2; /* 14 bits after the point */
    if (axes) hb_font_set_var_coords_normalized(finder->hb, coords, (unsigned)axes);
    finder->buffer = hb_buffer_create();
    finder->inputs = hb_set_create();
    return hb_buffer_allocation_successful(finder->buffer);
}

static void close_finder(mt_form_finder *finder) {
    hb_set_destroy(finder->inputs);
    hb_buffer_destroy(finder->buffer);
    hb_font_destroy(finder->hb);
    hb_face_destroy(finder->face);
}

/* ---- forms --------------------------------------------------------------------------------------------- */

/* What the settings make of the glyph in a script; the glyph itself where that is none, or several. */
static uint32_t shape(mt_form_finder *finder, hb_script_t script, uint32_t glyph) {
    hb_buffer_t *buffer = finder->buffer;
    uint32_t code = FIRST_PRIVATE + glyph;
    unsigned count;
    hb_buffer_clear_contents(buffer);
    hb_buffer_add_codepoints(buffer, &code, 1, 0, 1);
    hb_buffer_set_direction(buffer, HB_DIRECTION_LTR);
    hb_buffer_set_script(buffer, script);
    hb_buffer_set_language(buffer, HB_LANGUAGE_INVALID);
    hb_shape(finder->hb, buffer, finder->settings, (unsigned)finder->count);
    const hb_glyph_info_t *shaped = hb_buffer_get_glyph_infos(buffer, &count);
    bool is_form =
        count == 1 && shaped->codepoint && shaped->codepoint < (unsigned)finder->tables.glyph_count;
    return is_form ? shaped->codepoint : glyph;
}

static uint32_t find_form(mt_form_finder *finder, uint32_t code_point, uint32_t glyph) {
    hb_script_t script = hb_unicode_script(hb_unicode_funcs_get_default(), code_point);
    bool none = script == HB_SCRIPT_COMMON || script == HB_SCRIPT_INHERITED || script == HB_SCRIPT_UNKNOWN;
    uint32_t form = glyph;
    if (!hb_set_has(finder->inputs, glyph)) return glyph;
    if (!none) return shape(finder, script, glyph);
    for (unsigned i = 0; i < finder->script_count && form == glyph; i++)
        form = shape(finder, finder->scripts[i], glyph);
    return form;
}

/* The forms go to the font only when all are found: until then characters lead to their own glyphs. */
static mt_status find_forms(mt_form_finder *finder, mt_arena *arena) {
    mt_form *list = NULL;
    int count = 0, room = 0;
    uint32_t c = 0;
    for (bool more = mt_font_next_char(finder->font, 0, &c); more;
         more = mt_font_next_char(finder->font, c + 1, &c)) {
        uint32_t glyph = mt_font_mapped_glyph(finder->font, c), form = find_form(finder, c, glyph);
        if (form == glyph) continue;
        mt_form *grown = mt_arena_grow_list(arena, list, count, &room, sizeof *list);
        if (!grown) return MT_NO_MEMORY;
        list = grown;
        list[count++] = (mt_form){c, form};
    }
    mt_form *kept = mt_new((size_t)count + 1, sizeof *kept);
    if (!kept) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) kept[i] = list[i];
    finder->font->forms = kept;
    finder->font->form_count = count;
    return MT_OK;
}

static mt_status read_features(mt_form_finder *finder, mt_arena *arena) {
    mt_status status = read_tables(finder, arena);
    if (status != MT_OK) return status;
    if (!make_font(finder)) return MT_NO_MEMORY;
    turn_features(finder);
    if (!has_all(finder)) return MT_NO_FEATURE;
    collect_inputs(finder);
    status = list_scripts(finder, arena);
    return status == MT_OK ? find_forms(finder, arena) : status;
}

mt_status mt_font_read_features(mt_font *font) {
    mt_arena arena = {0};
    if (font->spec.feature_count == 0) return MT_OK;
    mt_form_finder *finder = mt_new(1, sizeof *finder);
    if (!finder) return MT_NO_MEMORY;
    finder->font = font;
    mt_status status = read_features(finder, &arena);
    close_finder(finder);
    mt_free(finder);
    mt_arena_release(&arena);
    return status;
}
