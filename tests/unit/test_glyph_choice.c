/* The blend's glyphs for a text are A's: HarfBuzz shapes the same text with A and with the blend, and each glyph of the
 * one has to be that which the glyph of the other was made of. */
#include "font/charset.h"
#include "font/utf.h"
#include "geometry/limits.h"

#include <hb-ot.h>
#include <stdio.h>
#include <string.h>

#include "support/check.h"
#include "support/fonts.h"
#include "support/gsub.h"
#include "support/sample.h"

#define SANS "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
#define INTER "/usr/share/fonts/truetype/inter-vf/Inter.var.ttf"
#define URW "/usr/share/fonts/opentype/urw-base35/"
#define NOTO "/usr/share/fonts/opentype/noto/"

enum { CHARS_MAX = 128, FEATURES_MAX = 8 };

/* A text in one language. */
typedef struct typed {
    const char *text, *features, *language; /* features: "smcp onum"; NULL for none, and for no language */
    bool vertical;
    int changed; /* how many glyphs, at least, are other ones than the characters' own */
} typed;

static mt_arena arena;
static char *directory;

static int set_up(void **state) {
    (void)state;
    directory = mt_sample_directory(&arena);
    return 0;
}

static int tear_down(void **state) {
    (void)state;
    mt_sample_remove(directory);
    mt_arena_release(&arena);
    return 0;
}

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
    mt_charset_request request = {chars, all, MT_GLYPHS_BOTH};
    mt_charset charset;
    mt_blend *blend;
    uint8_t *bytes;
    size_t length;
    mt_assert_ok(mt_charset_make(a, b, &request, &arena, &charset));
    mt_assert_ok(mt_blend_new(a, b, &params, &blend));
    mt_assert_ok(mt_blend_set_chars(blend, chars, all));
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

#define COUNT_OF(list) (int)(sizeof(list) / sizeof *(list))

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

static void vertical(void **state) {
    (void)state;
    static const typed texts[] = {
        {.text = "「你好，世界。」（ー）", .vertical = true, .language = "zh-cn", .changed = 5},
        {.text = "「你好，世界。」", .language = "zh-cn"},
        {.text = "骨直角", .language = "ja", .changed = 2},
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

/* All that two fonts of 65 535 glyphs have in common is one font. */
static void as_many_as_a_font_holds(void **state) {
    (void)state;
    mt_font *a, *b;
    mt_charset charset;
    mt_charset_request request = {NULL, 0, MT_GLYPHS_BOTH};
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
        cmocka_unit_test(as_many_as_a_font_holds),
        cmocka_unit_test(vertical),
        cmocka_unit_test(small_capitals_and_old_figures),
    };
    return cmocka_run_group_tests_name("glyph choice", tests, set_up, tear_down);
}
