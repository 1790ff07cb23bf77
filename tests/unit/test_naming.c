/* Glyphs by their names: what a name stands for, and the name that a glyph is shown by. */
#include "glyphset/naming.h"

#include <hb.h>
#include <stdio.h>
#include <string.h>

#include "glyphset/charset.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/gsub.h"
#include "support/sample.h"

enum { GLYPHS = 40 };

/* f, i and l are the glyphs 1 to 3. f f and f i are default ligatures; f f i is made of the first of them, i l in a feature that
 * is off, and so is another f i. */
static const mt_test_lookup ligatures[] = {{"hlig", NULL, 4, "1 2 14"},
                                           {"rlig", NULL, 4, "1 1 10"},
                                           {"liga", NULL, 4, "1 2 11"},
                                           {"clig", NULL, 4, "10 2 12"},
                                           {"dlig", NULL, 4, "2 3 13"}};
enum { LIGATURES = sizeof ligatures / sizeof *ligatures };

/* Names of all glyphs but for some. */
static const char **name_all(void) {
    const char **names = mt_arena_new(&arena, GLYPHS, sizeof *names);
    assert_non_null(names);
    for (int i = 0; i < GLYPHS; i++) {
        char *name = mt_arena_new(&arena, 16, 1);
        assert_non_null(name);
        snprintf(name, 16, i ? "own.%d" : ".notdef", i);
        names[i] = name;
    }
    names[1] = "f";
    names[20] = "twice";
    names[21] = "twice";
    names[22] = "gid5";
    names[23] = "a/b";
    names[24] = "f_l";
    names[25] = "glyph7";
    return names;
}

static mt_font *open_font(const char *name, const char **names) {
    mt_bytes gsub = mt_test_gsub(ligatures, LIGATURES, false, &arena);
    return mt_test_gsub_font(mt_sample_path(&arena, directory, name), GLYPHS, "fil", names, gsub, &arena);
}

/* -1: none. */
static int find(mt_naming *naming, const char *name) {
    uint32_t glyph = 1000;
    mt_status status = mt_naming_find(naming, name, strlen(name), &glyph);
    assert_int_equal(status, glyph == 1000 ? MT_NO_GLYPH : MT_OK);
    return status == MT_OK ? (int)glyph : -1;
}

static void by_own_names(void **state) {
    (void)state;
    mt_naming *naming;
    mt_font *font = open_font("named.ttf", name_all());
    mt_assert_ok(mt_naming_open(font, &naming));
    assert_int_equal(find(naming, ".notdef"), 0);
    assert_int_equal(find(naming, "f"), 1);
    assert_int_equal(find(naming, "own.39"), 39);
    assert_int_equal(find(naming, "twice"), 20);
    assert_int_equal(find(naming, "a/b"), 23);
    assert_int_equal(find(naming, "f_l"), 24);
    assert_int_equal(find(naming, "glyph7"), 25);
    assert_int_equal(find(naming, "own.40"), -1);
    assert_int_equal(find(naming, "F"), -1);
    assert_int_equal(find(naming, ""), -1);
    uint32_t glyph;
    mt_assert_ok(mt_naming_find(naming, "f/own.3", 1, &glyph));
    assert_int_equal(glyph, 1);
    mt_naming_close(naming);
    mt_font_close(font);
}

static void by_numbers_and_code_points(void **state) {
    (void)state;
    mt_naming *naming;
    mt_font *font = open_font("named.ttf", name_all());
    mt_assert_ok(mt_naming_open(font, &naming));
    assert_int_equal(find(naming, "gid5"), 22); /* its own name comes first */
    assert_int_equal(find(naming, "gid0"), 0);
    assert_int_equal(find(naming, "gid39"), 39);
    assert_int_equal(find(naming, "gid40"), -1);
    assert_int_equal(find(naming, "gid99999999999999999999999"), -1);
    assert_int_equal(find(naming, "gid"), -1);
    assert_int_equal(find(naming, "gid1x"), -1);
    assert_int_equal(find(naming, "gid-1"), -1);
    assert_int_equal(find(naming, "uni0069"), 2);
    assert_int_equal(find(naming, "u0069"), 2);
    assert_int_equal(find(naming, "u00006C"), 3);
    assert_int_equal(find(naming, "uni006c"), -1);
    assert_int_equal(find(naming, "uni0041"), -1);
    assert_int_equal(find(naming, "uni00069"), -1);
    assert_int_equal(find(naming, "u069"), -1);
    mt_naming_close(naming);
    mt_font_close(font);
}

static void ligatures_by_parts(void **state) {
    (void)state;
    mt_naming *naming;
    mt_font *fonts[] = {open_font("named.ttf", name_all()), open_font("bare.ttf", NULL)};
    for (int i = 0; i < 2; i++) {
        mt_assert_ok(mt_naming_open(fonts[i], &naming));
        assert_int_equal(find(naming, "f_i"), 11);
        assert_int_equal(find(naming, "f_f"), 10);
        assert_int_equal(find(naming, "f_f_i"), 12);
        assert_int_equal(find(naming, "uni0066_uni0069"), 11);
        assert_int_equal(find(naming, "gid10_i"), 12);
        assert_int_equal(find(naming, "i_l"), 13); /* by a feature that is off */
        assert_int_equal(find(naming, "f_f_l"), -1);
        assert_int_equal(find(naming, "l_i"), -1);
        assert_int_equal(find(naming, "f_x"), -1);
        assert_int_equal(find(naming, "f_"), -1);
        assert_int_equal(find(naming, "_f"), -1);
        assert_int_equal(find(naming, "_"), -1);
        assert_int_equal(find(naming, "f_f_f_f_f_f_f_f_f_f_f_f_f_f_f_f_f_f_f_f"), -1);
        mt_naming_close(naming);
        mt_font_close(fonts[i]);
    }
}

static void names_that_are_too_long(void **state) {
    (void)state;
    char name[1000];
    mt_naming *naming;
    mt_font *font = open_font("named.ttf", name_all());
    memset(name, 'f', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    mt_assert_ok(mt_naming_open(font, &naming));
    for (size_t length = 250; length < sizeof name; length++) {
        uint32_t glyph;
        assert_int_equal(mt_naming_find(naming, name, length, &glyph), MT_NO_GLYPH);
    }
    mt_naming_close(naming);
    mt_font_close(font);
}

static void assert_label(const mt_naming *naming, uint32_t glyph, const char *wanted) {
    char label[MT_GLYPH_LABEL_ROOM];
    mt_naming_label(naming, glyph, label);
    assert_string_equal(label, wanted);
}

static void labels(void **state) {
    (void)state;
    mt_naming *naming;
    mt_font *named = open_font("named.ttf", name_all()), *bare = open_font("bare.ttf", NULL);
    mt_assert_ok(mt_naming_open(named, &naming));
    assert_label(naming, 0, "/.notdef");
    assert_label(naming, 1, "/f");
    assert_label(naming, 20, "/twice");
    assert_label(naming, 21, "/gid21"); /* the name is the other one's */
    assert_label(naming, 23, "/gid23"); /* the name would end at its slash */
    assert_label(naming, 25, "/glyph7");
    mt_naming_close(naming);
    mt_assert_ok(mt_naming_open(bare, &naming));
    assert_label(naming, 12, "/gid12");
    mt_naming_close(naming);
    mt_font_close(named);
    mt_font_close(bare);
}

static void by_the_library(void **state) {
    (void)state;
    uint32_t glyph = 1000;
    mt_font *font = open_font("named.ttf", name_all());
    mt_assert_ok(mt_font_glyph_of_name(font, "f_f_i", &glyph));
    assert_int_equal(glyph, 12);
    assert_int_equal(mt_font_glyph_of_name(font, "x", &glyph), MT_NO_GLYPH);
    assert_int_equal(glyph, 12);
    mt_font_close(font);
}

/* ---- sets of named glyphs ------------------------------------------------------------------------------ */

/* The glyphs that are wanted, their characters and what becomes of them; paired as in a set of all. */
static void are_kept(void **state) {
    (void)state;
    mt_charset all, some;
    static const uint32_t wanted[] = {2, 10};
    mt_font *a = open_font("a.ttf", NULL), *b = open_font("b.ttf", NULL);
    mt_charset_request request = {.set = MT_GLYPHS_BOTH};
    mt_assert_ok(mt_charset_make(a, b, &request, &arena, &all));
    request.glyphs = wanted;
    request.glyph_count = 2;
    mt_assert_ok(mt_charset_make(a, b, &request, &arena, &some));
    static const uint32_t kept[] = {0, 2, 10, 12}; /* 12: of the two */
    assert_int_equal(some.primary_count, 4);
    for (int i = 0; i < 4; i++) {
        assert_int_equal(some.glyphs[i].a, kept[i]);
        for (int k = 0; k < all.primary_count; k++)
            if (all.glyphs[k].a == kept[i]) assert_int_equal(all.glyphs[k].b, some.glyphs[i].b);
        assert_int_not_equal(some.glyphs[i].b, MT_NO_PARTNER);
    }
    assert_int_equal(some.char_count, 1);
    assert_int_equal(some.chars[0].code_point, 'i');
    mt_font_close(a);
    mt_font_close(b);
}

static void need_no_character(void **state) {
    (void)state;
    mt_charset charset;
    static const uint32_t wanted[] = {13};
    mt_font *a = open_font("a.ttf", NULL), *b = open_font("b.ttf", NULL);
    const mt_charset_request request = {.glyphs = wanted, .glyph_count = 1};
    mt_assert_ok(mt_charset_make(a, b, &request, &arena, &charset));
    assert_int_equal(charset.glyph_count, 2);
    assert_int_equal(charset.glyphs[1].a, 13);
    assert_int_equal(charset.glyphs[1].b, 13);
    assert_int_equal(charset.char_count, 0);
    mt_font_close(a);
    mt_font_close(b);
}

static void numbers_of_a_blend(void **state) {
    (void)state;
    mt_blend *blend;
    uint8_t *bytes;
    size_t length;
    const mt_params params = mt_params_default();
    mt_font *a = open_font("a.ttf", NULL), *b = open_font("b.ttf", NULL);
    mt_assert_ok(mt_blend_new(a, b, &params, &blend));
    assert_int_equal(mt_blend_set_glyph_numbers(blend, (const uint32_t[]){1, GLYPHS}, 2), MT_BAD_PARAMETER);
    mt_assert_ok(mt_blend_set_glyph_numbers(blend, (const uint32_t[]){13}, 1));
    mt_assert_ok(mt_blend_font(blend, 0.5, &bytes, &length));
    hb_blob_t *blob =
        hb_blob_create((const char *)bytes, (unsigned)length, HB_MEMORY_MODE_READONLY, NULL, NULL);
    hb_face_t *face = hb_face_create(blob, 0);
    assert_int_equal(hb_face_get_glyph_count(face), 2);
    hb_face_destroy(face);
    hb_blob_destroy(blob);
    mt_bytes_free(bytes);
    mt_blend_free(blend);
    mt_font_close(a);
    mt_font_close(b);
}

/* ---- memory -------------------------------------------------------------------------------------------- */

static mt_status find_all(const char *path) {
    mt_font *font;
    uint32_t glyph;
    mt_status status = mt_font_open(path, &font);
    if (status != MT_OK) return status;
    status = mt_font_glyph_of_name(font, "f_f_i", &glyph);
    if (status == MT_OK) status = mt_font_glyph_of_name(font, "twice", &glyph);
    mt_font_close(font);
    return status;
}

static void without_memory(void **state) {
    (void)state;
    mt_font_close(open_font("named.ttf", name_all()));
    const char *path = mt_sample_path(&arena, directory, "named.ttf");
    bool failed = true;
    int failures = 0;
    for (long first = 0; failed; first++) {
        mt_allocation_watch();
        mt_allocation_fail(first, true);
        mt_status status = find_all(path);
        failed = mt_allocation_requests() > first;
        mt_allocation_succeed();
        long live = mt_allocation_live();
        mt_allocation_unwatch();
        assert_int_equal(live, 0);
        assert_int_equal(status, failed ? MT_NO_MEMORY : MT_OK);
        failures += failed;
    }
    assert_true(failures > 10);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(by_own_names),
        cmocka_unit_test(by_numbers_and_code_points),
        cmocka_unit_test(ligatures_by_parts),
        cmocka_unit_test(names_that_are_too_long),
        cmocka_unit_test(labels),
        cmocka_unit_test(by_the_library),
        cmocka_unit_test(are_kept),
        cmocka_unit_test(need_no_character),
        cmocka_unit_test(numbers_of_a_blend),
        cmocka_unit_test(without_memory),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, mt_test_tear_down);
}
