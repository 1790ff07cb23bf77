#include "blend/metadata.h"
#include "blend/review.h"
#include "source/panose.h"
#include "source/reserved.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/sample.h"
#include "write/write.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FONTS_MAX = 100 };
static mt_font *fonts[FONTS_MAX]; /* closed at the end */
static int font_count;

static int tear_down(void **state) {
    (void)state;
    while (font_count > 0) mt_font_close(fonts[--font_count]);
    mt_sample_remove(directory);
    mt_arena_release(&arena);
    return 0;
}

static mt_font *open_as(const char *name, const mt_font_data *data) {
    uint8_t *bytes;
    size_t length;
    mt_font *font;
    const char *path = mt_sample_path(&arena, directory, name);
    mt_assert_ok(mt_font_write(data, &bytes, &length));
    mt_sample_save(path, bytes, length);
    mt_bytes_free(bytes);
    mt_assert_ok(mt_font_open(path, &font));
    return font;
}

static void assert_near(double value, double expected) {
    assert_true(fabs(value - expected) < 1e-9);
}

/* What the blend of two fonts with these data says of itself, at t. */
static mt_font_data blended(const mt_font_data *a, const mt_font_data *b, double t, const char *family) {
    mt_font *in_a = open_as("a.ttf", a), *in_b = open_as("b.ttf", b);
    mt_font_data data = {.units = mt_metadata_units(in_a, in_b)};
    mt_metadata_fill(in_a, in_b, mt_at_both(t), &data);
    mt_assert_ok(mt_metadata_names(in_a, in_b, mt_at_both(t), family, &arena, &data));
    assert_true(font_count + 2 <= FONTS_MAX);
    fonts[font_count++] = in_a; /* some of the texts are theirs */
    fonts[font_count++] = in_b;
    return data;
}

/* ---- metrics ------------------------------------------------------------------------------------------- */

static void panose_is_mixed(void **state) {
    (void)state;
    static const uint8_t a[] = {2, 11, 8, 3, 3, 6, 0, 2, 2, 4}, b[] = {2, 6, 5, 3, 6, 6, 5, 1, 2, 3},
                         half[] = {2, 0, 7, 3, 5, 6, 0, 0, 2, 0}, script[] = {3, 6, 5, 3, 6, 6, 5, 1, 2, 3};
    uint8_t mix[MT_PANOSE_DIGITS], none[MT_PANOSE_DIGITS] = {0};
    mt_panose_mix(a, b, 0.5, mix);
    assert_memory_equal(mix, half, sizeof mix);
    mt_panose_mix(a, b, 0, mix);
    assert_memory_equal(mix, a, sizeof mix);
    mt_panose_mix(a, b, 1, mix);
    assert_memory_equal(mix, b, sizeof mix);
    mt_panose_mix(a, script, 0.5, mix);
    assert_memory_equal(mix, none, sizeof mix);
}

static void vertical_lines_of_one_font(void **state) {
    (void)state;
    mt_font_data a = mt_sample_font(&arena), b = mt_sample_font(&arena);
    a.metrics.vertical = true;
    a.metrics.vhea_ascender = 600;
    a.metrics.vhea_descender = -400;
    b.units = 2000; /* and no vertical metrics: half its em to each side */
    mt_font_data mix = blended(&a, &b, 0.25, NULL);
    assert_true(mix.metrics.vertical);
    assert_near(mix.metrics.vhea_ascender, 0.75 * 1200 + 0.25 * 1000);
    assert_near(mix.metrics.vhea_descender, 0.75 * -800 + 0.25 * -1000);
    assert_false(blended(&b, &b, 0.25, NULL).metrics.vertical);
}

/* The sum of the line that is used. */
static double line_of(const mt_metrics *m) {
    if (m->use_typo_metrics) return m->typo_ascender - m->typo_descender + m->typo_line_gap;
    return m->hhea_ascender - m->hhea_descender + m->hhea_line_gap;
}

static void lines_lie_between_the_ends(void **state) {
    (void)state;
    mt_font_data a = mt_sample_font(&arena), b = mt_sample_font(&arena);
    a.metrics.hhea_ascender = 3000; /* not used */
    b.metrics.use_typo_metrics = false;
    b.metrics.typo_line_gap = 5000; /* not used */
    double from = line_of(&a.metrics), to = line_of(&b.metrics);
    for (int i = 0; i <= 4; i++) {
        mt_font_data mix = blended(&a, &b, i / 4.0, NULL);
        assert_near(line_of(&mix.metrics), from + (to - from) * i / 4);
    }
}

static void monospaced_where_both_are(void **state) {
    (void)state;
    mt_font_data mono = mt_sample_font(&arena), not = mt_sample_font(&arena);
    mono.metrics.monospaced = true;
    assert_true(blended(&mono, &mono, 0.5, NULL).metrics.monospaced);
    assert_false(blended(&mono, &not, 0.5, NULL).metrics.monospaced);
    assert_true(blended(&mono, &not, 0, NULL).metrics.monospaced);
    assert_false(blended(&mono, &not, 1, NULL).metrics.monospaced);
}

/* ---- dates --------------------------------------------------------------------------------------------- */

static void dates_are_fixed(void **state) {
    (void)state;
    mt_font_data a = mt_sample_font(&arena), b = mt_sample_font(&arena);
    a.modified = 3500000000;
    unsetenv("SOURCE_DATE_EPOCH");
    assert_int_equal(blended(&a, &b, 0.5, NULL).modified, b.modified);
    setenv("SOURCE_DATE_EPOCH", "1000000000", 1);
    mt_font_data mix = blended(&a, &b, 0.5, NULL);
    setenv("SOURCE_DATE_EPOCH", "yesterday", 1);
    assert_int_equal(blended(&b, &a, 0.5, NULL).created, b.modified);
    unsetenv("SOURCE_DATE_EPOCH");
    assert_int_equal(mix.created, 1000000000 + INT64_C(2082844800));
    assert_int_equal(mix.modified, mix.created);
}

/* ---- names --------------------------------------------------------------------------------------------- */

static void words_in_names(void **state) {
    (void)state;
    static const char *const held[][2] = {{"Source Sans", "source"},
                                          {"New SOURCE-sans Pro", "Source Sans"},
                                          {"DejaVu  Serif", "dejavu_serif"},
                                          {"A", "A"},
                                          {"形 Sans", "形"},
                                          {"Foo: Bar", "bar"}};
    static const char *const not_held[][2] = {{"Resource", "Source"},
                                              {"Sources", "Source"},
                                              {"Source", "Source Sans"},
                                              {"Foo", ""},
                                              {"", "Foo"},
                                              {"Foo", "-"},
                                              {"SourceSans", "Source Sans"},
                                              {"Foo B", "Foo Bar"}};
    for (int i = 0; i < 6; i++) assert_true(mt_name_holds(held[i][0], held[i][1]));
    for (int i = 0; i < 8; i++) assert_false(mt_name_holds(not_held[i][0], not_held[i][1]));
}

static void assert_reserved(const char *copyright, const char *license, const char *names) {
    char all[200] = "";
    mt_reserved reserved;
    mt_font_data data = mt_sample_font(&arena);
    data.family = "Own";
    data.copyright = copyright;
    data.license = license;
    mt_font *font = open_as("reserved.ttf", &data);
    mt_assert_ok(mt_reserved_find(font, &arena, &reserved));
    for (int i = 0; i < reserved.count; i++) {
        strcat(all, i ? "|" : "");
        strcat(all, reserved.names[i]);
    }
    assert_string_equal(all, names);
    mt_font_close(font);
}

static void reserved_names(void **state) {
    (void)state;
    assert_reserved(NULL, NULL, "Own");
    assert_reserved("© 2010 Foundry, with Reserved Font Name ‘Source’.", NULL, "Own|Source");
    assert_reserved("(c) X with Reserved Font Names \"Foo\" and \"Bar Sans\". All \"rights\".", NULL,
                    "Own|Foo|Bar Sans");
    assert_reserved("(c) Y, with Reserved Font Name: Linux Libertine.",
                    "with reserved font name(s) Biolinum, and so", "Own|Linux Libertine|Biolinum");
    assert_reserved(NULL, "\"Reserved Font Name\" refers to any names specified as such.", "Own");
    assert_reserved(
        NULL,
        "renamed to names not containing either the words \"Bitstream\" or the word \"Vera\". The \"x\"",
        "Own|Bitstream|Vera");
    assert_reserved("with Reserved Font Name", "with Reserved Font Name \"", "Own");
}

static void family_is_its_own(void **state) {
    (void)state;
    mt_font_data a = mt_sample_font(&arena), b = mt_sample_font(&arena);
    assert_int_equal(strncmp(blended(&a, &b, 0.5, NULL).family, "Morphotype ", 11), 0);
    b.family = "Morphotype";
    a.copyright = "(c) with Reserved Font Name 'Between'.";
    const char *family = blended(&a, &b, 0.5, NULL).family;
    assert_false(mt_name_holds(family, "Morphotype") || mt_name_holds(family, "Between"));
    assert_string_equal(blended(&a, &b, 0.5, "Zwischen").family, "Zwischen");
}

static void sources_are_named(void **state) {
    (void)state;
    mt_font_data a = mt_sample_font(&arena), b = mt_sample_font(&arena);
    a.family = "First";
    b.family = "Second";
    b.version = NULL;
    b.copyright = "(c) B";
    b.trademark = NULL;
    b.designer = "B. Drawer";
    mt_font_data mix = blended(&a, &b, 0.25, NULL);
    assert_string_equal(mix.style, "At 0.25");
    assert_string_equal(mix.copyright, "© é\n(c) B");
    assert_string_equal(mix.trademark, "Sample is no trademark");
    assert_string_equal(mix.designer, "É. Signer, B. Drawer");
    assert_string_equal(mix.license, "MIT");
    assert_string_equal(mix.description,
                        "Between First Half Way, version 1.250 (T = 0) and Second Half Way (T = 1), at "
                        "T = 0.25, by Morphotype " MORPHOTYPE_VERSION);
    assert_non_null(strstr(mix.unique_id, "First Half Way 1.250"));
}

/* Texts that 'name' has no room for are cut between two characters. */
static void long_texts_are_cut(void **state) {
    (void)state;
    enum { LONG = 31000 };
    mt_font_data a = mt_sample_font(&arena), b = mt_sample_font(&arena);
    char *text = mt_arena_new(&arena, LONG + 1, 1), *other = mt_arena_new(&arena, LONG + 1, 1);
    assert_true(text && other);
    for (int i = 0; i < LONG; i += 2) memcpy(text + i, "é", 2);
    memcpy(other, text, LONG);
    other[0] = other[1] = 'x';
    a.license = text;
    b.license = other;
    mt_font_data mix = blended(&a, &b, 0.5, NULL);
    assert_in_range(strlen(mix.license), 20000, 20020);
    assert_non_null(strstr(mix.license, "é…\nxxé"));
    mix.glyph_count = a.glyph_count;
    mix.glyphs = a.glyphs;
    uint8_t *bytes;
    size_t length;
    mt_assert_ok(mt_font_write(&mix, &bytes, &length));
    mt_bytes_free(bytes);
}

/* ---- warnings ------------------------------------------------------------------------------------------ */

static void collect(const char *line, void *user) {
    strcat(user, line);
    strcat(user, "\n");
}

/* What is said of two fonts with these data; in the arena. */
static char *warnings(const mt_font_data *a, const mt_font_data *b, const char *family) {
    char *lines = mt_arena_new(&arena, 8192, 1);
    assert_non_null(lines);
    mt_font *in_a = open_as("a.ttf", a), *in_b = open_as("b.ttf", b);
    mt_assert_ok(mt_review((mt_font *[]){in_a, in_b}, 2, family, collect, lines));
    mt_font_close(in_a);
    mt_font_close(in_b);
    return lines;
}

static void nothing_to_warn_of(void **state) {
    (void)state;
    mt_font_data data = mt_sample_font(&arena);
    data.embedding = 8;
    data.license = "You may copy, modify, merge and publish it. The licence document may be copied; it is "
                   "not to be sold.";
    assert_string_equal(warnings(&data, &data, NULL), "");
    assert_string_equal(warnings(&data, &data, "Samples"), "");
}

static void rights_are_warned_of(void **state) {
    (void)state;
    mt_font_data a = mt_sample_font(&arena), b = mt_sample_font(&arena);
    a.embedding = 0x302;
    b.embedding = 0;
    b.license = "Free to use. The font MAY NOT BE MODIFIED in any way. Else fine.";
    const char *said = warnings(&a, &b, "The Sample 形 Mono");
    assert_null(strstr(said, "“Sample 形”"));
    assert_non_null(strstr(said, "a.ttf restricts its embedding (OS/2 fsType): restricted"));
    assert_non_null(strstr(said, "; no subsetting; bitmap embedding only\n"));
    assert_non_null(strstr(said, "b.ttf may not permit a changed font"));
    assert_non_null(strstr(said, "“… MAY NOT BE MODIFIED in any way …”"));
    assert_null(strstr(said, "left out"));
    a.embedding = 0;
    a.family = "Sample";
    said = warnings(&a, &a, "The SAMPLE-Mono");
    assert_non_null(strstr(said, "“The SAMPLE-Mono” has “Sample” in it"));
}

static void tables_left_out_are_told(void **state) {
    (void)state;
    static const uint8_t some[] = {0, 0, 0, 0};
    mt_font_data a = mt_sample_font(&arena), b = mt_sample_font(&arena);
    a.embedding = b.embedding = 0;
    a.extra_count = 2;
    a.extras[0] = (mt_extra_table){'S' << 24 | 'V' << 16 | 'G' << 8 | ' ', {some, 4}};
    a.extras[1] = (mt_extra_table){'M' << 24 | 'A' << 16 | 'T' << 8 | 'H', {some, 4}};
    b.extra_count = 1;
    b.extras[0] = (mt_extra_table){'C' << 24 | 'O' << 16 | 'L' << 8 | 'R', {some, 4}};
    const char *said = warnings(&a, &b, NULL);
    assert_non_null(strstr(said, "left out: SVG, MATH of "));
    assert_non_null(strstr(said, "a.ttf; COLR of "));
    assert_ptr_equal(strchr(said, '\n'), said + strlen(said) - 1); /* one line */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(panose_is_mixed),
        cmocka_unit_test(vertical_lines_of_one_font),
        cmocka_unit_test(lines_lie_between_the_ends),
        cmocka_unit_test(monospaced_where_both_are),
        cmocka_unit_test(dates_are_fixed),
        cmocka_unit_test(words_in_names),
        cmocka_unit_test(reserved_names),
        cmocka_unit_test(family_is_its_own),
        cmocka_unit_test(sources_are_named),
        cmocka_unit_test(long_texts_are_cut),
        cmocka_unit_test(nothing_to_warn_of),
        cmocka_unit_test(rights_are_warned_of),
        cmocka_unit_test(tables_left_out_are_told),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, tear_down);
}
