/* Characters in the forms that features of the spec make of their glyphs. */
#include "source/font.h"
#include "source/variation_sequences.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/gsub.h"
#include "support/sample.h"

#include <stdio.h>
#include <string.h>

enum { GLYPHS = 40 };

static int set_up(void **state) {
    (void)state;
    directory = mt_sample_directory(&arena);
    static const mt_test_lookup lookups[] = {
        {"ss01", NULL, 1, "1 11,2 12"},                                 /* one for one */
        {"salt", NULL, 3, "1 13 14 15"},                                /* one of several */
        {"ss02", NULL, 2, "1 16 17,2 18"},                              /* several, and one */
        {"ss03", NULL, 4, "1 2 19"},                                    /* a ligature */
        {"ss04", NULL, 6, "1 2 3 5"},       {"    ", NULL, 1, "2 20"},  /* in a context */
        {"ss05", NULL, 1, "3 21"},          {"ss07", NULL, 1, "21 22"}, /* one after another */
        {"ss06", NULL, 1, "1 39"},          {"liga", NULL, 1, "4 23,39 38"},
        {"zero", "TRK ", 1, "27 28,29 30"}, /* on by default; of another language */
    };
    mt_bytes gsub = mt_test_gsub(lookups, 11, false, &arena);
    const char *path = mt_sample_path(&arena, directory, "f.ttf");
    mt_font_close(mt_test_gsub_font(path, GLYPHS, "abcd1", NULL, gsub, &arena));
    mt_font_close(mt_test_gsub_font(mt_sample_path(&arena, directory, "f.ttf:ss01"), GLYPHS, "xyz", NULL,
                                    gsub, &arena));
    return 0;
}

/* The glyphs of a, b, c, d and 1. */
static void assert_glyphs(const char *spec, const uint32_t (*wanted)[5]) {
    mt_font *font;
    mt_assert_ok(mt_font_open(mt_sample_path(&arena, directory, spec), &font));
    for (int i = 0; i < 5; i++) {
        assert_int_equal(mt_font_glyph(font, (unsigned char)"abcd1"[i]), (*wanted)[i]);
        assert_int_equal(mt_font_mapped_glyph(font, (unsigned char)"abcd1"[i]), (*wanted)[i]);
    }
    assert_int_equal(mt_font_glyph(font, 'q'), 0);
    bool changed = memcmp(*wanted, (const uint32_t[]){1, 2, 3, 4, 5}, sizeof *wanted) != 0;
    assert_int_equal(mt_font_features_do_nothing(font), !changed && strrchr(spec, ':'));
    mt_font_close(font);
}

static void forms(void **state) {
    (void)state;
    assert_glyphs("f.ttf", &(const uint32_t[5]){1, 2, 3, 4, 5});
    assert_glyphs("f.ttf:salt", &(const uint32_t[5]){13, 2, 3, 4, 5});
    assert_glyphs("f.ttf:salt=2", &(const uint32_t[5]){14, 2, 3, 4, 5});
    assert_glyphs("f.ttf:salt=3,ss07,ss05=on", &(const uint32_t[5]){15, 2, 22, 4, 5});
    assert_glyphs("f.ttf:ss06,ss05,ss07=1", &(const uint32_t[5]){39, 2, 22, 4, 5});
    assert_glyphs("f.ttf#0:ss05", &(const uint32_t[5]){1, 2, 21, 4, 5});
}

/* More than one glyph is no form, nor is one that stands among others; a number beyond the list changes nothing. */
static void no_forms(void **state) {
    (void)state;
    assert_glyphs("f.ttf:ss02", &(const uint32_t[5]){1, 18, 3, 4, 5});
    assert_glyphs("f.ttf:ss03,ss04", &(const uint32_t[5]){1, 2, 3, 4, 5});
    assert_glyphs("f.ttf:salt=4", &(const uint32_t[5]){1, 2, 3, 4, 5});
    assert_glyphs("f.ttf:salt=0,ss05=off,ss07", &(const uint32_t[5]){1, 2, 3, 4, 5});
    assert_glyphs("f.ttf:zero", &(const uint32_t[5]){1, 2, 3, 4, 5});
}

/* What shaping does by itself stays shaping's, unless it is named. */
static void not_by_default(void **state) {
    (void)state;
    assert_glyphs("f.ttf:ss05", &(const uint32_t[5]){1, 2, 21, 4, 5});
    assert_glyphs("f.ttf:liga", &(const uint32_t[5]){1, 2, 3, 23, 5});
}

static void a_file_of_that_name(void **state) {
    (void)state;
    mt_font *font;
    mt_assert_ok(mt_font_open(mt_sample_path(&arena, directory, "f.ttf:ss01"), &font));
    assert_int_equal(mt_font_glyph(font, 'x'), 1);
    assert_string_equal(mt_font_choice(font), "");
    mt_font_close(font);
    mt_assert_ok(mt_font_open(mt_sample_path(&arena, directory, "f.ttf:salt=2"), &font));
    assert_string_equal(mt_font_choice(font), ":salt=2");
    mt_font_close(font);
}

static void unknown_and_malformed(void **state) {
    (void)state;
    static const struct {
        const char *spec;
        mt_status status;
    } wrong[] = {
        {"f.ttf:ss09", MT_NO_FEATURE},     {"f.ttf:kern", MT_NO_FEATURE},
        {"f.ttf:ss01x,", MT_BAD_FEATURE},  {"f.ttf:ss06,ss09", MT_NO_FEATURE},
        {"f.ttf:ss9=0", MT_NO_FEATURE},    {"f.ttf:", MT_BAD_FEATURE},
        {"f.ttf:ss06,", MT_BAD_FEATURE},   {"f.ttf:salt=256", MT_BAD_FEATURE},
        {"f.ttf:salt=-1", MT_BAD_FEATURE},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        mt_font *font;
        assert_int_equal(mt_font_open(mt_sample_path(&arena, directory, wrong[i].spec), &font),
                         wrong[i].status);
    }
}

static void without_layout(void **state) {
    (void)state;
    mt_font *font;
    mt_bytes table;
    mt_assert_ok(mt_font_open(mt_sample_path(&arena, directory, "f.ttf:ss05"), &font));
    assert_true(mt_font_has_table(font, MT_TAG('G', 'S', 'U', 'B')));
    assert_false(mt_font_is_without_layout(font));
    mt_font_drop_layout(font);
    assert_true(mt_font_is_without_layout(font));
    assert_false(mt_font_has_table(font, MT_TAG('G', 'S', 'U', 'B')));
    assert_true(mt_font_has_table(font, MT_TAG('c', 'm', 'a', 'p')));
    mt_assert_ok(mt_font_table(font, MT_TAG('G', 'S', 'U', 'B'), &arena, &table));
    assert_int_equal(table.length, 0);
    assert_int_equal(mt_font_glyph(font, 'c'), 21); /* what it was opened with stays */
    mt_font_close(font);
}

static void no_memory(void **state) {
    (void)state;
    const char *spec = mt_sample_path(&arena, directory, "f.ttf:salt=2,ss05");
    mt_status status = MT_NO_MEMORY;
    long request = 0;
    for (; status == MT_NO_MEMORY; request++) {
        mt_font *font;
        mt_allocation_watch();
        mt_allocation_fail(request, false);
        status = mt_font_open(spec, &font);
        if (status == MT_OK) mt_font_close(font);
        mt_allocation_unwatch();
        assert_int_equal(mt_allocation_live(), 0);
    }
    assert_int_equal(status, MT_OK);
    assert_true(request > 10);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(forms),
        cmocka_unit_test(no_forms),
        cmocka_unit_test(not_by_default),
        cmocka_unit_test(a_file_of_that_name),
        cmocka_unit_test(unknown_and_malformed),
        cmocka_unit_test(without_layout),
        cmocka_unit_test(no_memory),
    };
    return cmocka_run_group_tests_name("font features", tests, set_up, mt_test_tear_down);
}
