/* The blend's glyphs for a text are A's: HarfBuzz shapes the same text with A and with the blend, and each glyph of the
 * one has to be that which the glyph of the other was made of. */
#include "base/utf.h"
#include "geometry/limits.h"
#include "glyphset/charset.h"
#include "gsub/subset.h"
#include "sfnt/sfnt.h"
#include "write/write.h"

#include <hb-ot.h>
#include <stdio.h>
#include <string.h>

#include "support/check.h"
#include "support/fixture.h"
#include "support/fonts.h"
#include "support/gsub.h"
#include "support/random.h"
#include "support/sample.h"

#define SANS "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
#define INTER "/usr/share/fonts/truetype/inter-vf/Inter.var.ttf"
#define URW "/usr/share/fonts/opentype/urw-base35/"
#define NOTO "/usr/share/fonts/opentype/noto/"
#define LINUX "/usr/share/fonts/opentype/linux-libertine/"

#define COUNT_OF(list) (int)(sizeof(list) / sizeof *(list))

enum { CHARS_MAX = 128, FEATURES_MAX = 8 };

/* A text in one language. */
typedef struct typed {
    const char *text, *features, *language; /* features: "smcp onum"; NULL for none, and for no language */
    bool vertical;
    int changed; /* how many glyphs, at least, are other ones than the characters' own */
} typed;

/* ---- shaping ------------------------------------------------------------------------------------------- */

static hb_font_t *open_shaper(hb_blob_t *blob, int face_number) {
    hb_face_t *face = hb_face_create(blob, (unsigned)face_number);
    hb_font_t *font = hb_font_create(face);
    hb_face_destroy(face);
    hb_blob_destroy(blob);
    return font;
}

/* A's own file, at its place on the axes. */
static hb_font_t *shaper_of(const mt_font *font) {
    char path[256];
    int face = 0, coords[64], count;
    const int32_t *place;
    snprintf(path, sizeof path, "%s", mt_font_spec(font));
    char *end = path + strcspn(path, "#@");
    if (*end == '#') face = atoi(end + 1);
    *end = '\0';
    hb_font_t *shaper = open_shaper(hb_blob_create_from_file(path), face);
    count = mt_font_place(font, &place);
    for (int i = 0; i < count; i++) coords[i] = place[i] >> 2;
    hb_font_set_var_coords_normalized(shaper, coords, (unsigned)count);
    return shaper;
}

static hb_buffer_t *shape(hb_font_t *font, const typed *line) {
    hb_feature_t features[FEATURES_MAX];
    unsigned count = 0;
    hb_buffer_t *buffer = hb_buffer_create();
    hb_buffer_add_utf8(buffer, line->text, -1, 0, -1);
    if (line->vertical) hb_buffer_set_direction(buffer, HB_DIRECTION_TTB);
    if (line->language) hb_buffer_set_language(buffer, hb_language_from_string(line->language, -1));
    hb_buffer_guess_segment_properties(buffer);
    for (const char *at = line->features; at && *at; at += *at == ' ') {
        int length = (int)strcspn(at, " ");
        assert_true(count < FEATURES_MAX && hb_feature_from_string(at, length, &features[count]));
        count++;
        at += length;
    }
    hb_shape(font, buffer, features, count);
    return buffer;
}

static int count_changed(hb_font_t *font, hb_buffer_t *shaped, const typed *line) {
    unsigned count;
    int changed = 0;
    const hb_glyph_info_t *glyphs = hb_buffer_get_glyph_infos(shaped, &count);
    for (unsigned i = 0; i < count; i++) {
        const char *at = line->text + glyphs[i].cluster;
        uint32_t c, nominal = 0;
        mt_utf8_next(&at, &c);
        hb_font_get_nominal_glyph(font, c, &nominal);
        changed += glyphs[i].codepoint != nominal;
    }
    return changed;
}

/* ---- comparing ----------------------------------------------------------------------------------------- */

static void compare(hb_font_t *in_a, hb_font_t *in_blend, const mt_charset *charset, const typed *line) {
    unsigned count, count_a;
    hb_buffer_t *a = shape(in_a, line), *blend = shape(in_blend, line);
    const hb_glyph_info_t *glyphs_a = hb_buffer_get_glyph_infos(a, &count_a);
    const hb_glyph_info_t *glyphs = hb_buffer_get_glyph_infos(blend, &count);
    if (count != count_a) fail_msg("%s: %u glyphs instead of %u", line->text, count, count_a);
    for (unsigned i = 0; i < count; i++) {
        assert_int_equal(glyphs[i].cluster, glyphs_a[i].cluster);
        assert_in_range(glyphs[i].codepoint, 0, (unsigned)charset->glyph_count - 1);
        uint32_t made_of = charset->glyphs[glyphs[i].codepoint].a;
        if (made_of != glyphs_a[i].codepoint)
            fail_msg("%s: glyph %u is %u of the first font, not %u", line->text, i, made_of,
                     glyphs_a[i].codepoint);
    }
    int changed = count_changed(in_a, a, line);
    if (changed < line->changed) fail_msg("%s: %d glyphs are substituted", line->text, changed);
    hb_buffer_destroy(a);
    hb_buffer_destroy(blend);
}

static int list_chars(const typed *texts, int count, uint32_t *chars) {
    int all = 0;
    for (int i = 0; i < count; i++) {
        const char *at = texts[i].text;
        uint32_t c;
        while (mt_utf8_next(&at, &c) && c) {
            assert_true(all < CHARS_MAX);
            chars[all++] = c;
        }
    }
    return all;
}

/* Blends the characters of all texts and shapes each of them. Closes the fonts. */
static void check_texts(mt_font *a, mt_font *b, const typed *texts, int count) {
    uint32_t chars[CHARS_MAX];
    int all = list_chars(texts, count, chars);
    mt_params params = mt_params_default();
    mt_charset_request request = {.wanted = chars, .count = all, .alternates = true};
    mt_charset charset;
    mt_blend *blend;
    uint8_t *bytes;
    size_t length;
    mt_assert_ok(mt_charset_make(a, b, &request, &arena, &charset));
    mt_assert_ok(mt_blend_new(a, b, &params, &blend));
    mt_assert_ok(mt_blend_set_chars(blend, chars, all));
    mt_blend_set_alternates(blend, true);
    mt_assert_ok(mt_blend_font(blend, 0.5, &bytes, &length));
    hb_blob_t *blob =
        hb_blob_create((const char *)bytes, (unsigned)length, HB_MEMORY_MODE_READONLY, NULL, NULL);
    hb_font_t *in_a = shaper_of(a), *in_blend = open_shaper(blob, 0);
    for (int i = 0; i < count; i++) compare(in_a, in_blend, &charset, &texts[i]);
    hb_font_destroy(in_a);
    hb_font_destroy(in_blend);
    mt_bytes_free(bytes);
    mt_blend_free(blend);
    mt_font_close(a);
    mt_font_close(b);
}

/* ---- fonts --------------------------------------------------------------------------------------------- */

static void ligatures_and_languages(void **state) {
    (void)state;
    static const typed texts[] = {
        {.text = "fil flut affix ﬁ", .changed = 3},
        {.text = "fil", .features = "-liga"},
        {.text = "булба", .language = "sr", .changed = 2},
        {.text = "булба", .language = "ru"},
        {.text = "Ilo", .features = "salt aalt", .changed = 1},
    };
    check_texts(mt_test_font(SANS), mt_test_font(MT_TEST_SANS), texts, COUNT_OF(texts));
}

static void arabic(void **state) {
    (void)state;
    static const typed texts[] = {
        {.text = "السلام عليكم", .changed = 8},
        {.text = "لا إله", .changed = 1},
        {.text = "ببب ھھھ", .language = "ur", .changed = 5},
    };
    check_texts(mt_test_font(SANS), mt_test_font(MT_TEST_SANS), texts, COUNT_OF(texts));
}

/* A variable font at a place, with contexts, and another of other names and another order. */
static void variable(void **state) {
    (void)state;
    static const typed texts[] = {
        {.text = "a->b <- c => d", .changed = 1},
        {.text = "abc 123", .features = "sups", .changed = 4},
        {.text = "H2O 123", .features = "subs", .changed = 3},
        {.text = "1a 2o", .features = "ordn", .changed = 1},
    };
    mt_font *b = mt_test_font(SANS), *a;
    mt_font_close(mt_test_font(INTER));
    mt_assert_ok(mt_font_open(INTER "@wght=650", &a));
    check_texts(a, b, texts, COUNT_OF(texts));
}

static void postscript_outlines(void **state) {
    (void)state;
    static const typed texts[] = {
        {.text = "fix flow affine offload", .changed = 4},
        {.text = "1/2 3/4 15/16", .features = "frac", .changed = 2},
        {.text = "şa", .language = "ro", .changed = 0},
    };
    check_texts(mt_test_font(URW "C059-Roman.otf"), mt_test_font(URW "P052-Roman.otf"), texts,
                COUNT_OF(texts));
}

static void capitals_and_figures(void **state) {
    (void)state;
    static const typed texts[] = {
        {.text = "Hamburg Öfen", .features = "smcp", .changed = 9},
        {.text = "Hamburg", .features = "smcp c2sc", .changed = 7},
        {.text = "0123456789", .features = "onum", .changed = 8},
        {.text = "0123456789", .features = "onum pnum", .changed = 8},
        {.text = "Auflage, office", .features = "liga", .changed = 2},
    };
    check_texts(mt_test_font(LINUX "LinLibertine_R.otf"), mt_test_font(LINUX "LinBiolinum_R.otf"), texts,
                COUNT_OF(texts));
}

static void vertical(void **state) {
    (void)state;
    static const typed texts[] = {
        {.text = "「你好，世界。」（ー）", .vertical = true, .language = "zh-cn", .changed = 5},
        {.text = "「你好，世界。」", .language = "zh-cn"},
        {.text = "骨直角", .language = "ja", .changed = 2},
        {.text = "렁·・", .language = "ko", .changed = 2}, /* one glyph in A, two in B */
        {.text = "、\uFE01。\uFE00礼\uFE00！\uFE01", .changed = 3},
    };
    mt_font *a = mt_test_font(NOTO "NotoSansCJK-Bold.ttc"),
            *b = mt_test_font(NOTO "NotoSerifCJK-Regular.ttc");
    mt_font_close(a);
    mt_font_close(b);
    mt_assert_ok(mt_font_open(NOTO "NotoSansCJK-Bold.ttc#2", &a));
    mt_assert_ok(mt_font_open(NOTO "NotoSerifCJK-Regular.ttc#2", &b));
    check_texts(a, b, texts, COUNT_OF(texts));
}

/* Two weights of a family number their glyphs alike: whatever is paired has the same number, also the forms, which have
 * no names here. */
static void weights_of_a_family(void **state) {
    (void)state;
    mt_font *a, *b;
    mt_charset charset;
    mt_charset_request request = {.set = MT_GLYPHS_BOTH};
    mt_font_close(mt_test_font(NOTO "NotoSansCJK-Bold.ttc"));
    mt_font_close(mt_test_font(NOTO "NotoSansCJK-Regular.ttc"));
    mt_assert_ok(mt_font_open(NOTO "NotoSansCJK-Bold.ttc#2", &a));
    mt_assert_ok(mt_font_open(NOTO "NotoSansCJK-Regular.ttc#2", &b));
    mt_assert_ok(mt_charset_make(a, b, &request, &arena, &charset));
    int forms = 0;
    for (int i = 0; i < charset.glyph_count; i++) {
        assert_int_equal(charset.glyphs[i].a, charset.glyphs[i].b);
        forms += !charset.glyphs[i].mapped;
    }
    assert_in_range(forms, 20000, 65535);
    mt_font_close(a);
    mt_font_close(b);
}

/* ---- random texts -------------------------------------------------------------------------------------- */

/* The new font's characters and substitutions, with blank glyphs of A's advances (to which HarfBuzz looks where a mark
 * stands alone) and A's GPOS as it is (where a font has no marks there, HarfBuzz composes Hebrew letters; where things
 * then lie is not looked at). Its bytes are in the arena. */
static hb_font_t *open_blank(mt_font *a, hb_font_t *in_a, const mt_charset *charset) {
    mt_font_data data = mt_sample_font(&arena);
    mt_layout_tables tables;
    mt_bytes gpos;
    uint8_t *bytes;
    size_t length;
    uint16_t *kept = mt_arena_new(&arena, (size_t)charset->primary_count, sizeof *kept);
    data.glyph_count = charset->glyph_count;
    data.glyphs = mt_arena_new(&arena, (size_t)charset->glyph_count, sizeof *data.glyphs);
    assert_true(kept && data.glyphs);
    for (int i = 0; i < charset->primary_count; i++) kept[i] = (uint16_t)charset->glyphs[i].a;
    for (int i = 0; i < charset->glyph_count; i++)
        data.glyphs[i].advance = (uint16_t)hb_font_get_glyph_h_advance(in_a, charset->glyphs[i].a);
    data.units = mt_font_units_per_em(a);
    data.char_count = charset->char_count;
    data.chars = charset->chars;
    mt_assert_ok(mt_gsub_subset(a, kept, charset->primary_count, &arena, &tables));
    mt_assert_ok(mt_charset_twins(charset, &arena, &tables));
    data.extras[data.extra_count++] = (mt_extra_table){MT_TAG('G', 'S', 'U', 'B'), tables.gsub};
    if (tables.gdef.length)
        data.extras[data.extra_count++] = (mt_extra_table){MT_TAG('G', 'D', 'E', 'F'), tables.gdef};
    mt_assert_ok(mt_font_table(a, MT_TAG('G', 'P', 'O', 'S'), &arena, &gpos));
    if (gpos.length) data.extras[data.extra_count++] = (mt_extra_table){MT_TAG('G', 'P', 'O', 'S'), gpos};
    mt_assert_ok(mt_font_write(&data, &bytes, &length));
    uint8_t *copy = mt_arena_new(&arena, length, 1);
    assert_non_null(copy);
    memcpy(copy, bytes, length);
    mt_bytes_free(bytes);
    return open_shaper(
        hb_blob_create((const char *)copy, (unsigned)length, HB_MEMORY_MODE_READONLY, NULL, NULL), 0);
}

static int by_code_point(const void *p, const void *q) {
    uint32_t x = ((const mt_char *)p)->code_point, y = ((const mt_char *)q)->code_point;
    return (x > y) - (x < y);
}

/* An hb_font_get_nominal_glyph_func_t. */
static hb_bool_t find_shared(hb_font_t *font, void *charset_of, hb_codepoint_t c, hb_codepoint_t *glyph,
                             void *user) {
    (void)font, (void)user;
    const mt_charset *charset = charset_of;
    mt_char key = {c, 0};
    const mt_char *found =
        bsearch(&key, charset->chars, (size_t)charset->char_count, sizeof key, by_code_point);
    if (found) *glyph = charset->glyphs[found->glyph].a;
    return found != NULL;
}

/* A with no more characters than the blend has: where one is missing, HarfBuzz composes and decomposes others. */
static hb_font_t *with_shared_chars(hb_font_t *in_a, mt_charset *charset) {
    hb_font_t *font = hb_font_create_sub_font(in_a);
    hb_font_funcs_t *calls = hb_font_funcs_create();
    hb_font_funcs_set_nominal_glyph_func(calls, find_shared, NULL, NULL);
    hb_font_set_funcs(font, calls, charset, NULL);
    hb_font_funcs_destroy(calls);
    hb_font_destroy(in_a);
    return font;
}

typedef struct random_text {
    char text[128], features[128];
    typed line;
} random_text;

/* Two to twelve characters that are next to each other in the font, mostly. */
static void make_text(mt_random *random, const mt_charset *charset, random_text *made) {
    static const char *const features[] = {"liga", "-liga", "dlig", "salt", "vert", "fwid", "hwid",
                                           "ruby", "case",  "aalt", "hist", "ss01", "frac", "sups"};
    static const char *const languages[] = {NULL, "sr", "ro", "ur", "ja", "ko", "zh-tw", "tr"};
    int length = 0, count = mt_random_between(random, 2, 12), at = 0;
    *made = (random_text){.line = {.vertical = mt_random_one_in(random, 4)}};
    for (int i = 0; i < count; i++) {
        bool far = i == 0 || mt_random_one_in(random, 6);
        int last = charset->char_count - 1, most = mt_random_one_in(random, 2) ? 2000 : last;
        at = far ? mt_random_between(random, 0, most < last ? most : last)
                 : at + mt_random_between(random, -40, 40);
        at = at < 0 ? 0 : at > last ? last : at;
        length += mt_utf8_put(charset->chars[at].code_point, made->text + length);
    }
    for (int i = mt_random_between(random, 0, 3); i > 0; i--)
        snprintf(made->features + strlen(made->features), sizeof made->features - strlen(made->features),
                 "%s%s", *made->features ? " " : "",
                 features[mt_random_between(random, 0, COUNT_OF(features) - 1)]);
    made->line.text = made->text;
    made->line.features = made->features;
    made->line.language = languages[mt_random_between(random, 0, COUNT_OF(languages) - 1)];
}

static bool all_kept(hb_font_t *in_a, const mt_charset *charset, const typed *line) {
    unsigned count;
    bool kept = true;
    hb_buffer_t *shaped = shape(in_a, line);
    const hb_glyph_info_t *glyphs = hb_buffer_get_glyph_infos(shaped, &count);
    for (unsigned i = 0; i < count; i++) {
        int k = 0;
        while (k < charset->primary_count && charset->glyphs[k].a != glyphs[i].codepoint) k++;
        kept = kept && k < charset->primary_count;
    }
    hb_buffer_destroy(shaped);
    return kept;
}

/* Texts whose glyphs in A are all there in the blend. */
static void check_random(const char *spec_a, const char *spec_b, int cases) {
    mt_font *a, *b;
    mt_charset charset;
    mt_charset_request request = {.set = MT_GLYPHS_BOTH};
    mt_assert_ok(mt_font_open(spec_a, &a));
    mt_assert_ok(mt_font_open(spec_b, &b));
    mt_assert_ok(mt_charset_make(a, b, &request, &arena, &charset));
    hb_font_t *in_a = with_shared_chars(shaper_of(a), &charset);
    hb_font_t *in_blend = open_blank(a, in_a, &charset);
    int checked = 0;
    for (int i = 0; i < cases; i++) {
        mt_random random = mt_random_case(i);
        random_text text;
        make_text(&random, &charset, &text);
        if (!all_kept(in_a, &charset, &text.line)) continue;
        compare(in_a, in_blend, &charset, &text.line);
        checked++;
    }
    assert_true(checked > cases / 2);
    hb_font_destroy(in_a);
    hb_font_destroy(in_blend);
    mt_font_close(a);
    mt_font_close(b);
}

static void random_texts(void **state) {
    (void)state;
    mt_font_close(mt_test_font(SANS));
    mt_font_close(mt_test_font(NOTO "NotoSansCJK-Bold.ttc"));
    mt_font_close(mt_test_font(NOTO "NotoSerifCJK-Regular.ttc"));
    mt_font_close(mt_test_font(INTER));
    check_random(SANS, MT_TEST_SANS, mt_test_cases(1000));
    check_random(INTER "@wght=300", INTER "@wght=800", mt_test_cases(1000));
    check_random(NOTO "NotoSansCJK-Bold.ttc#2", NOTO "NotoSerifCJK-Regular.ttc#2", mt_test_cases(400));
}

/* All that two fonts of 65 535 glyphs have in common is one font. */
static void as_many_as_a_font_holds(void **state) {
    (void)state;
    mt_font *a, *b;
    mt_charset charset;
    mt_charset_request request = {.set = MT_GLYPHS_BOTH};
    mt_font_close(mt_test_font(NOTO "NotoSansCJK-Bold.ttc"));
    mt_font_close(mt_test_font(NOTO "NotoSerifCJK-Regular.ttc"));
    mt_assert_ok(mt_font_open(NOTO "NotoSansCJK-Bold.ttc#2", &a));
    mt_assert_ok(mt_font_open(NOTO "NotoSerifCJK-Regular.ttc#2", &b));
    for (int i = 0; i < 2; i++) {
        request.set = i ? MT_GLYPHS_FIRST : MT_GLYPHS_BOTH;
        mt_assert_ok(mt_charset_make(a, b, &request, &arena, &charset));
        assert_in_range(charset.glyph_count, 60000, MT_GLYPHS_MAX);
        assert_true(charset.char_count > 44000);
        for (int k = 0; k < charset.char_count; k++)
            assert_int_equal(charset.glyphs[charset.chars[k].glyph].a,
                             mt_font_glyph(a, charset.chars[k].code_point));
    }
    mt_font_close(a);
    mt_font_close(b);
}

/* Two fonts that order and apply their forms differently. */
static void small_capitals_and_old_figures(void **state) {
    (void)state;
    static const mt_test_lookup in_a[] = {{"liga", NULL, 4, "1 2 13"},
                                          {"locl", "TRK ", 1, "2 14"},
                                          {"onum", NULL, 1, "3 11,4 12"},
                                          {"smcp", NULL, 1, "1 9,2 10,13 15"}};
    static const mt_test_lookup in_b[] = {{"locl", "TRK ", 1, "3 5"},
                                          {"onum", NULL, 3, "1 8,2 6 7"},
                                          {"liga", NULL, 4, "4 3 12"},
                                          {"smcp", NULL, 1, "3 9,4 10,12 11"}};
    static const typed texts[] = {
        {.text = "fi12if", .changed = 1},
        {.text = "fi12if", .features = "smcp", .changed = 3},
        {.text = "fi12if", .features = "smcp onum", .changed = 5},
        {.text = "fi12if", .features = "-liga", .language = "tr", .changed = 2},
    };
    mt_font *a = mt_test_gsub_font(mt_sample_path(&arena, directory, "a.ttf"), 20, "fi12", NULL,
                                   mt_test_gsub(in_a, COUNT_OF(in_a), false, &arena), &arena);
    mt_font *b = mt_test_gsub_font(mt_sample_path(&arena, directory, "b.ttf"), 20, "21if", NULL,
                                   mt_test_gsub(in_b, COUNT_OF(in_b), true, &arena), &arena);
    check_texts(a, b, texts, COUNT_OF(texts));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ligatures_and_languages),
        cmocka_unit_test(arabic),
        cmocka_unit_test(variable),
        cmocka_unit_test(postscript_outlines),
        cmocka_unit_test(capitals_and_figures),
        cmocka_unit_test(as_many_as_a_font_holds),
        cmocka_unit_test(weights_of_a_family),
        cmocka_unit_test(random_texts),
        cmocka_unit_test(vertical),
        cmocka_unit_test(small_capitals_and_old_figures),
    };
    return cmocka_run_group_tests_name("glyph choice", tests, mt_test_set_up, mt_test_tear_down);
}
